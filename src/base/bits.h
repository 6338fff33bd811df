// The bits of a value as another type of the same size: std::bit_cast, which not every library in use has yet.
#pragma once

#include <type_traits>

namespace slicecast {

template <typename To, typename From>
constexpr To bitCast(const From& from) {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
    return __builtin_bit_cast(To, from);
}

}  // namespace slicecast

// The bits of a value as another type of the same size: std::bit_cast, which not every library in
// use has yet.
#pragma once

#include <cstdint>
#include <type_traits>

namespace slicecast {

template <typename To, typename From>
constexpr To bitCast(const From& from) {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> &&
                  std::is_trivially_copyable_v<From>);
    return __builtin_bit_cast(To, from);
}

// The integer nearest to `value`, which must lie within +-2^50: added to 1.5 * 2^52 a number has no
// bits after the point, and stands in the low bits of the double. Cheaper than a conversion, in
// WebAssembly above all.
inline std::int64_t nearestInteger(double value) {
    constexpr double kMagic = 6755399441055744.0;
    return bitCast<std::int64_t>(value + kMagic) - bitCast<std::int64_t>(kMagic);
}

}  // namespace slicecast

// Programs with sanitizers are several times slower, so their tests try less.
#pragma once

namespace slicecast {

#ifdef SLICECAST_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace slicecast

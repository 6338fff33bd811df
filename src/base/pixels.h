// Masks for the channels of a pixel, and for two of them at a time.
#pragma once

#include "slicecast/colour.h"

namespace slicecast {

inline constexpr Pixel kRedAndBlue = 0x00ff00ff;
inline constexpr Pixel kOpaque = 0xff000000;  // the whole alpha

}  // namespace slicecast

// The contact sheet, to check textures by eye: each one tiled 3 x 3, at four times its size,
// reduced to 16 and to 32 texels, and in grey. Pictures with holes and pictures of several frames
// stand three times instead: over a checkerboard, over a dark and over a light ground, as large as
// there is room; those that repeat are tiled.
#pragma once

#include <vector>

#include "catalogue.h"

namespace slicecast::textures {

Picture contactSheet(const std::vector<Entry>& entries);

}  // namespace slicecast::textures

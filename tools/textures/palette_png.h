// PNG files with a palette: a picture of few colours has a byte a pixel in them. The project's are
// little more than half as large so.
#pragma once

#include "base/image.h"

#include <cstdint>
#include <vector>

namespace slicecast::textures {

// The bytes of the file; none for a picture of more than 256 colours.
std::vector<std::uint8_t> encodePalettePng(const std::vector<Pixel>& pixels, int width, int height);

}  // namespace slicecast::textures

// Pictures as files.
#pragma once

#include "slicecast/image.h"

#include <filesystem>
#include <string>

namespace slicecast {

// Writes a PNG file, whole or not at all: what stood there before stays until all is written. Empty
// on success, else what was wrong. An empty image is refused.
std::string saveImage(const Image& image, const std::filesystem::path& file);

}  // namespace slicecast

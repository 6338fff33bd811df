// Writes pictures to files.
#pragma once

#include "slicecast/image.h"

#include <filesystem>
#include <string>

namespace slicecast {

// Writes a PNG file, whole or not at all: an old file stays until all of the new one is written.
// Returns an empty text on success, else what is wrong. Refuses an empty image.
std::string saveImage(const Image& image, const std::filesystem::path& file);

}  // namespace slicecast

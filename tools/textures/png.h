// Writing pictures as PNG files, 8 bits a channel, opaque.
#pragma once

#include <string>

#include "picture.h"

namespace slicecast::textures {

// False if the file could not be written.
bool writePng(const std::string& path, const Picture& picture);

}  // namespace slicecast::textures

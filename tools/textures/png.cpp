#include "png.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace slicecast::textures {

bool writePng(const std::string& path, const Picture& picture) {
    stbi_write_png_compression_level = 9;
    std::vector<unsigned char> bytes;
    bytes.reserve(picture.pixels.size() * 3);
    for (const Colour& colour : picture.pixels) {
        bytes.push_back(colour.r);
        bytes.push_back(colour.g);
        bytes.push_back(colour.b);
    }
    return stbi_write_png(path.c_str(), picture.width, picture.height, 3, bytes.data(), 3 * picture.width) != 0;
}

}  // namespace slicecast::textures

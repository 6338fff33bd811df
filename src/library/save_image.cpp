#include "slicecast/save_image.h"

#include "base/image.h"
#include "base/words.h"
#include "files/write_file.h"

namespace slicecast {

std::string saveImage(const Image& image, const std::filesystem::path& file) {
    if (image.empty())
        return words("\"", file.string(), "\": found an empty image, expected pixels");
    return writeWholeFile(file.string(),
                          encodePng(image.pixels.data(), image.width, image.height, image.width));
}

}  // namespace slicecast

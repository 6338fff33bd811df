// Any bytes as a PNG file.
#include "base/image.h"

#include <cstdint>
#include <cstdlib>

using namespace slicecast;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr int kMost = 20;  // pixels a side: some of the pictures that it begins with have more
    const DecodedImage decoded = decodePng({data, size}, kMost, kMost);
    const Image& image = decoded.image;
    if (decoded.fault.empty() == image.empty()) std::abort();
    if (image.width > kMost || image.height > kMost ||
        image.pixels.size() !=
            static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
        std::abort();
    return 0;
}

#include "base/image.h"

#include "base/words.h"

#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace {

// A hostile file's compressed data may expand without end, whatever size its picture claims to
// have. The largest picture that is read has 8192 x 4096 pixels of 4 bytes, and a filter byte for
// each row.
constexpr std::size_t kMaxAllocation = 8192ull * 4096 * 4 + 4096;

void* allocateBounded(std::size_t bytes) {
    return bytes > kMaxAllocation ? nullptr : std::malloc(bytes);
}
void* reallocateBounded(void* memory, std::size_t bytes) {
    return bytes > kMaxAllocation ? nullptr : std::realloc(memory, bytes);
}

}  // namespace

// Only PNG is decoded; files are opened elsewhere.
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MALLOC(bytes) allocateBounded(bytes)
#define STBI_REALLOC(memory, bytes) reallocateBounded(memory, bytes)
#define STBI_FREE(memory) std::free(memory)
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wcast-qual"
#endif
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace slicecast {
namespace {

// No image within the limits needs a larger file. The limit also keeps the length within
// stb_image's int.
constexpr std::size_t kMaxPngBytes = 64u << 20;

}  // namespace

// Joins the pixels as numbers and unpacks one colour at the end. In code built for size, a call of
// toColour for each pixel would take most of the time.
bool Image::isOpaque() const {
    Pixel common = ~Pixel{0};
    for (const Pixel pixel : pixels) common &= pixel;
    return toColour(common).a == 255;
}

std::int64_t pixelsOfPng(std::span<const std::uint8_t> bytes) {
    int width = 0;
    int height = 0;
    int channels = 0;
    if (bytes.size() > kMaxPngBytes ||
        !stbi_info_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width, &height,
                               &channels))
        return 0;
    return std::int64_t{width} * height;
}

DecodedImage decodePng(std::span<const std::uint8_t> bytes, int maxWidth, int maxHeight,
                       bool blank) {
    constexpr std::uint8_t kSignature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    if (bytes.size() < sizeof kSignature ||
        std::memcmp(bytes.data(), kSignature, sizeof kSignature) != 0)
        return {{}, "is not a PNG file"};
    if (bytes.size() > kMaxPngBytes)
        return {{}, words("has ", bytes.size(), " bytes; at most ", kMaxPngBytes, " are read")};

    const int length = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (!stbi_info_from_memory(bytes.data(), length, &width, &height, &channels)) {
        return {{}, words("is a damaged PNG file (", stbi_failure_reason(), ")")};
    }
    if (width > maxWidth || height > maxHeight) {
        return {{},
                words("is ", width, "x", height, " pixels; at most ", maxWidth, "x", maxHeight,
                      " are read")};
    }
    if (blank) return {Image(width, height), {}};
    stbi_uc* decoded = stbi_load_from_memory(bytes.data(), length, &width, &height, &channels, 4);
    if (!decoded) return {{}, words("is a damaged PNG file (", stbi_failure_reason(), ")")};
    Image image;
    image.width = width;
    image.height = height;
    const auto* first = reinterpret_cast<const Pixel*>(decoded);
    image.pixels.assign(first,
                        first + static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    stbi_image_free(decoded);
    return {std::move(image), {}};
}

std::vector<std::uint8_t> compressed(std::span<const std::uint8_t> bytes) {
    constexpr int kQuality = 32;  // earlier matches tried for each byte; more save no bytes
    int size = 0;
    // stb's parameter is not const, but stb only reads the bytes.
    unsigned char* packed = stbi_zlib_compress(const_cast<unsigned char*>(bytes.data()),
                                               static_cast<int>(bytes.size()), &size, kQuality);
    std::vector<std::uint8_t> result(packed, packed + size);
    std::free(packed);
    return result;
}

std::vector<std::uint8_t> encodePng(const Pixel* pixels, int width, int height, int pitch) {
    std::vector<std::uint8_t> bytes;
    const auto append = [](void* context, void* data, int size) {
        auto* out = static_cast<std::vector<std::uint8_t>*>(context);
        const auto* first = static_cast<const std::uint8_t*>(data);
        out->insert(out->end(), first, first + size);
    };
    stbi_write_png_to_func(append, &bytes, width, height, 4, pixels,
                           pitch * static_cast<int>(sizeof(Pixel)));
    return bytes;
}

}  // namespace slicecast

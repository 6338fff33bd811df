#include "base/image.h"

#include "base/words.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>
#include <utility>

namespace {

// A hostile file's compressed data may expand without end, whatever size its picture claims to
// have. The largest picture that is read has 8192 x 4096 pixels of 4 bytes, and a filter byte for
// each row.
constexpr std::size_t kMaxAllocation = 8192ull * 4096 * 4 + 4096;

// New memory is full of zeros: stb_image lets compressed data repeat bytes at a distance of 0,
// which it has not written yet. The same file then always gives the same picture.
void* reallocateBounded(void* memory, std::size_t oldBytes, std::size_t bytes) {
    if (bytes > kMaxAllocation) return nullptr;
    void* larger = std::realloc(memory, bytes);
    if (larger != nullptr && bytes > oldBytes)
        std::memset(static_cast<char*>(larger) + oldBytes, 0, bytes - oldBytes);
    return larger;
}
void* allocateBounded(std::size_t bytes) {
    return reallocateBounded(nullptr, 0, bytes);
}

}  // namespace

// Only PNG is decoded; files are opened elsewhere.
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MALLOC(bytes) allocateBounded(bytes)
#define STBI_REALLOC_SIZED(memory, oldBytes, bytes) reallocateBounded(memory, oldBytes, bytes)
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

// What a PNG's chunks say before any is decoded.
struct Chunks {
    std::string_view fault = {};                 // what is wrong with them
    int bits = 0;                                // of a sample
    bool isIndexed = false;                      // pixels are numbers of colours in a palette
    std::span<const std::uint8_t> palette = {};  // three bytes for each colour
    std::span<const std::uint8_t> alphas = {};   // of the first colours; the others are opaque
};

constexpr std::size_t kFirstChunk = 8;   // where it begins: behind the signature
constexpr std::size_t kColourType = 25;  // where the header says how pixels are stored
constexpr std::uint8_t kGrey = 0;
constexpr std::uint8_t kIndexed = 3;

// Goes from chunk to chunk up to the end mark: each is a length, a name of four letters, that many
// bytes, and a checksum. stb_image would read zeros behind the end of a file, and quote the name of
// a chunk whatever bytes it has.
Chunks readChunks(std::span<const std::uint8_t> bytes) {
    Chunks chunks;
    std::size_t at = kFirstChunk;
    bool hasPixels = false;
    while (true) {
        constexpr std::size_t kFrame = 12;  // length, name and checksum
        if (bytes.size() - at < kFrame) return {.fault = "cut off"};
        const std::uint8_t* chunk = bytes.data() + at;
        const std::size_t length =
            std::size_t{chunk[0]} << 24 | chunk[1] << 16 | chunk[2] << 8 | chunk[3];
        const std::string_view name(reinterpret_cast<const char*>(chunk) + 4, 4);
        for (const char c : name) {
            if ((c | 0x20) < 'a' || (c | 0x20) > 'z') return {.fault = "a chunk without a name"};
        }
        // Those with a small letter first may be left out
        if ((name[0] & 0x20) == 0 && name != "IHDR" && name != "PLTE" && name != "IDAT" &&
            name != "IEND")
            return {.fault = "an unknown chunk"};
        if (bytes.size() - at - kFrame < length) return {.fault = "cut off"};
        const std::span data(chunk + 8, length);
        if (at == kFirstChunk) {
            if (name != "IHDR" || length != 13) return {.fault = "no header"};
            chunks.bits = bytes[kColourType - 1];
            chunks.isIndexed = bytes[kColourType] == kIndexed;
        }
        if (name == "IEND") return chunks;
        hasPixels = hasPixels || name == "IDAT";
        if (chunks.isIndexed && name == "PLTE") {
            if (hasPixels || chunks.palette.data() != nullptr || length % 3 != 0 || length == 0 ||
                length > 768)
                return {.fault = "a wrong palette"};
            chunks.palette = data;
        }
        if (chunks.isIndexed && name == "tRNS") {
            if (hasPixels || chunks.alphas.data() != nullptr || 3 * length > chunks.palette.size())
                return {.fault = "wrong alphas of a palette"};
            chunks.alphas = data;
        }
        at += kFrame + length;
    }
}

std::string damaged(const Words& why) {
    std::string fault = "is a damaged PNG file (";
    add(fault, why);
    return fault + ")";
}

// With stb_image's reason. It gives none if it got no memory.
std::string damagedAsDecoded() {
    const char* reason = stbi_failure_reason();
    return damaged(reason != nullptr ? reason : "too many bytes");
}

struct FreePixels {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};
using DecodedPixels = std::unique_ptr<stbi_uc, FreePixels>;

// Null for a damaged file.
DecodedPixels decodedPixels(std::span<const std::uint8_t> bytes, int channels) {
    stbi__g_failure_reason = nullptr;  // of another file
    int width = 0;
    int height = 0;
    int stored = 0;
    return DecodedPixels(stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width,
                                               &height, &stored, channels));
}

// A picture whose pixels are numbers of colours. stb_image would take colours beyond the palette's
// end from memory that nobody has written. So it gets the file as one of grey pixels, whose grey is
// the number of the colour.
DecodedImage decodeIndexed(std::span<const std::uint8_t> bytes, const Chunks& chunks, int width,
                           int height) {
    if (chunks.palette.empty()) return {{}, damaged("no palette")};
    std::vector<std::uint8_t> grey(bytes.begin(), bytes.end());
    grey[kColourType] = kGrey;
    // Grey pixels have other alphas: as a chunk of an unknown name, these are left out
    if (chunks.alphas.data() != nullptr)
        grey[static_cast<std::size_t>(chunks.alphas.data() - bytes.data()) - 1] = 's';
    const DecodedPixels numbers = decodedPixels(grey, 1);
    if (!numbers) return {{}, damagedAsDecoded()};

    const std::size_t count = chunks.palette.size() / 3;
    std::array<Pixel, 256> colours;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* colour = &chunks.palette[3 * i];
        colours[i] = toPixel({colour[0], colour[1], colour[2],
                              i < chunks.alphas.size() ? chunks.alphas[i] : std::uint8_t{255}});
    }
    Image image(width, height);
    const int shift = 8 - chunks.bits;  // greys of fewer bits are spread over 0 to 255
    const stbi_uc* number = numbers.get();
    for (Pixel& pixel : image.pixels) {
        const unsigned colour = *number++ >> shift;
        if (colour >= count)
            return {{},
                    damaged({"a pixel of colour ", colour, ", a palette of ",
                             Counted{static_cast<std::int64_t>(count), "colour"}})};
        pixel = colours[colour];
    }
    return {std::move(image), {}};
}

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

    const Chunks chunks = readChunks(bytes);
    if (!chunks.fault.empty()) return {{}, damaged(chunks.fault)};
    const int length = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (!stbi_info_from_memory(bytes.data(), length, &width, &height, &channels))
        return {{}, damagedAsDecoded()};
    if (width > maxWidth || height > maxHeight) {
        return {{},
                words("is ", width, "x", height, " pixels; at most ", maxWidth, "x", maxHeight,
                      " are read")};
    }
    if (blank) return {Image(width, height), {}};
    if (chunks.isIndexed) return decodeIndexed(bytes, chunks, width, height);
    const DecodedPixels decoded = decodedPixels(bytes, 4);
    if (!decoded) return {{}, damagedAsDecoded()};
    Image image;
    image.width = width;
    image.height = height;
    const auto* first = reinterpret_cast<const Pixel*>(decoded.get());
    image.pixels.assign(first,
                        first + static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
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

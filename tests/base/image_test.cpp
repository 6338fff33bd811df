#include "base/image.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {
namespace {

Image coloured(int width, int height) {
    Image image(width, height);
    Random random(4);
    for (Pixel& pixel : image.pixels) pixel = static_cast<Pixel>(random.next());
    return image;
}

TEST(Image, PngThereAndBack) {
    const Image image = coloured(13, 7);
    const std::vector<std::uint8_t> bytes = encodePng(image.pixels.data(), 13, 7, 13);
    const DecodedImage decoded = decodePng(bytes, 13, 7);
    EXPECT_EQ(decoded.fault, "");
    EXPECT_EQ(decoded.image.width, 13);
    EXPECT_EQ(decoded.image.height, 7);
    EXPECT_EQ(decoded.image.pixels, image.pixels);
}

TEST(Image, PngOfPaddedRows) {
    const Image image = coloured(8, 4);
    const std::vector<std::uint8_t> bytes = encodePng(image.pixels.data(), 5, 4, 8);
    const DecodedImage decoded = decodePng(bytes, 100, 100);
    ASSERT_EQ(decoded.image.width, 5);
    EXPECT_EQ(decoded.image.at(4, 3), image.at(4, 3));
}

TEST(Image, RefusesWhatIsNoPng) {
    const std::vector<std::uint8_t> jpeg = {0xff, 0xd8, 0xff, 0xe0, 0, 16, 'J', 'F', 'I', 'F', 0};
    EXPECT_EQ(decodePng(jpeg, 10, 10).fault, "is not a PNG file");
    EXPECT_EQ(decodePng({}, 10, 10).fault, "is not a PNG file");
}

TEST(Image, RefusesWhatIsTooLargeBeforeDecoding) {
    const Image image = coloured(20, 3);
    const std::vector<std::uint8_t> bytes = encodePng(image.pixels.data(), 20, 3, 20);
    const DecodedImage decoded = decodePng(bytes, 19, 19);
    EXPECT_TRUE(decoded.image.empty());
    EXPECT_NE(decoded.fault.find("20x3"), std::string::npos) << decoded.fault;
    EXPECT_NE(decoded.fault.find("19x19"), std::string::npos) << decoded.fault;
}

#ifndef SLICECAST_SANITIZED  // which would take long over so many bytes
// The largest size that worlds allow is within the bound on memory.
TEST(Image, ReadsTheLargestPicture) {
    const Image image(8192, 4096);
    const std::vector<std::uint8_t> bytes =
        encodePng(image.pixels.data(), image.width, image.height, image.width);
    const DecodedImage decoded = decodePng(bytes, 8192, 4096);
    EXPECT_EQ(decoded.fault, "");
    EXPECT_EQ(decoded.image.width, 8192);
}
#endif

TEST(Image, RefusesEveryCutOffPng) {
    const Image image = coloured(9, 9);
    const std::vector<std::uint8_t> bytes = encodePng(image.pixels.data(), 9, 9, 9);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const DecodedImage decoded = decodePng(std::span(bytes).first(length), 100, 100);
        ASSERT_TRUE(decoded.image.empty()) << length;
        ASSERT_EQ(decoded.fault,
                  length < 8 ? "is not a PNG file" : "is a damaged PNG file (cut off)");
    }
}

using Bytes = std::vector<std::uint8_t>;

void addNumber(Bytes& bytes, std::size_t number) {
    for (const int shift : {24, 16, 8, 0})
        bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

// Without its checksum, which no reader asks for.
void addChunk(Bytes& bytes, std::string_view name, const Bytes& data) {
    addNumber(bytes, data.size());
    bytes.insert(bytes.end(), name.begin(), name.end());
    bytes.insert(bytes.end(), data.begin(), data.end());
    addNumber(bytes, 0);
}

struct Chunk {
    std::string_view name;
    Bytes data;
};

// A picture whose rows take a whole number of bytes; `colourType` as in a PNG's header.
Bytes pngOf(int width, int height, int bits, int colourType, const std::vector<Chunk>& before,
            const Bytes& data, const std::vector<Chunk>& behind = {}) {
    Bytes bytes = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    Bytes header;
    addNumber(header, static_cast<std::size_t>(width));
    addNumber(header, static_cast<std::size_t>(height));
    for (const int part : {bits, colourType, 0, 0, 0})
        header.push_back(static_cast<std::uint8_t>(part));
    addChunk(bytes, "IHDR", header);
    for (const Chunk& chunk : before) addChunk(bytes, chunk.name, chunk.data);
    Bytes rows;
    const std::size_t rowBytes = data.size() / static_cast<std::size_t>(height);
    for (std::size_t i = 0; i < data.size(); ++i) {
        if (i % rowBytes == 0) rows.push_back(0);  // no filter
        rows.push_back(data[i]);
    }
    addChunk(bytes, "IDAT", compressed(rows));
    for (const Chunk& chunk : behind) addChunk(bytes, chunk.name, chunk.data);
    addChunk(bytes, "IEND", {});
    return bytes;
}

constexpr int kIndexed = 3;

TEST(Image, IndexedPixelsHaveTheColoursOfThePalette) {
    for (const int bits : {1, 2, 4, 8}) {
        const int count = std::min(1 << bits, 200);
        Random random(static_cast<std::uint64_t>(bits));
        Bytes palette;
        for (int i = 0; i < 3 * count; ++i)
            palette.push_back(static_cast<std::uint8_t>(random.below(256)));
        const Bytes alphas = {17};  // the other colours are opaque
        constexpr int kWidth = 16;
        constexpr int kHeight = 9;
        std::vector<int> numbers;
        Bytes data;
        for (int i = 0; i < kWidth * kHeight; ++i) {
            numbers.push_back(random.below(count));
            if (i * bits % 8 == 0) data.push_back(0);
            data.back() = static_cast<std::uint8_t>(data.back() << bits | numbers.back());
        }
        for (const bool hasAlphas : {false, true}) {
            std::vector<Chunk> before = {{"gAMA", {0, 0, 177, 143}}, {"PLTE", palette}};
            if (hasAlphas) before.push_back({"tRNS", alphas});
            const DecodedImage decoded =
                decodePng(pngOf(kWidth, kHeight, bits, kIndexed, before, data), 100, 100);
            ASSERT_EQ(decoded.fault, "") << bits;
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                const auto at = 3 * static_cast<std::size_t>(numbers[i]);
                const std::uint8_t alpha = hasAlphas && numbers[i] == 0 ? 17 : 255;
                ASSERT_EQ(decoded.image.pixels[i],
                          toPixel({palette[at], palette[at + 1], palette[at + 2], alpha}))
                    << bits << " bits, pixel " << i;
            }
        }
    }
}

TEST(Image, RefusesWrongPalettes) {
    const Bytes three = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    const Bytes data = {0, 1, 2, 0};
    const Bytes beyond = {0, 1, 2, 3};
    const auto faultOf = [](const std::vector<Chunk>& before, const Bytes& indices,
                            const std::vector<Chunk>& behind = {}) {
        return decodePng(pngOf(2, 2, 8, kIndexed, before, indices, behind), 9, 9).fault;
    };
    const std::string palette = "is a damaged PNG file (a wrong palette)";
    const std::string alphas = "is a damaged PNG file (wrong alphas of a palette)";
    EXPECT_EQ(faultOf({{"PLTE", three}}, data), "");
    EXPECT_EQ(faultOf({{"PLTE", three}, {"tRNS", {9, 9, 9}}}, data), "");
    EXPECT_EQ(faultOf({{"PLTE", three}, {"tRNS", {}}}, data), "");
    EXPECT_EQ(faultOf({{"PLTE", three}}, beyond),
              "is a damaged PNG file (a pixel of colour 3, a palette of 3 colours)");
    EXPECT_EQ(faultOf({{"PLTE", {1, 2, 3}}}, {0, 0, 255, 1}),
              "is a damaged PNG file (a pixel of colour 255, a palette of 1 colour)");
    EXPECT_EQ(faultOf({{"PLTE", {}}}, data), palette);
    EXPECT_EQ(faultOf({{"PLTE", {1, 2}}}, data), palette);
    EXPECT_EQ(faultOf({{"PLTE", Bytes(771)}}, data), palette);
    EXPECT_EQ(faultOf({{"PLTE", three}, {"PLTE", three}}, data), palette);
    EXPECT_EQ(faultOf({{"PLTE", three}}, data, {{"PLTE", three}}), palette);
    EXPECT_EQ(faultOf({{"PLTE", three}, {"tRNS", {1, 2, 3, 4}}}, data), alphas);
    EXPECT_EQ(faultOf({{"tRNS", {1}}, {"PLTE", three}}, data), alphas);
    EXPECT_EQ(faultOf({{"PLTE", three}, {"tRNS", {1}}, {"tRNS", {1}}}, data), alphas);
    EXPECT_EQ(faultOf({{"PLTE", three}}, data, {{"tRNS", {1}}}), alphas);
    EXPECT_NE(faultOf({}, data), "");
    EXPECT_EQ(faultOf({{"PLTE", three}, {"CgBI", {1}}}, data),
              "is a damaged PNG file (an unknown chunk)");
    EXPECT_EQ(faultOf({{"\x1b]0;", {1}}}, data), "is a damaged PNG file (a chunk without a name)");
}

// Whatever one byte is changed to: the same answer again, with an image or a reason, and nothing in
// it that the file made up. Run by valgrind, each pixel is compared and so must have been written.
TEST(Image, AnyChangedByteGivesAnImageOrAReason) {
    Random random(11);
    const auto noise = [&](int count, int below) {
        Bytes bytes;
        for (int i = 0; i < count; ++i)
            bytes.push_back(static_cast<std::uint8_t>(random.below(below)));
        return bytes;
    };
    const Bytes palette = noise(3 * 16, 256);
    const Bytes pictures[] = {
        pngOf(6, 5, 8, kIndexed, {{"PLTE", palette}, {"tRNS", {1, 2}}}, noise(30, 16)),
        pngOf(8, 3, 4, kIndexed, {{"PLTE", palette}}, noise(12, 256)),
        pngOf(8, 3, 1, 0, {{"tRNS", {0, 1}}}, noise(3, 256)),
        pngOf(3, 3, 16, 2, {{"tRNS", {0, 1, 0, 1, 0, 1}}}, noise(54, 256)),
        pngOf(4, 3, 8, 6, {}, noise(48, 256))};
    int images = 0;
    int faults = 0;
    for (const Bytes& picture : pictures) {
        ASSERT_EQ(decodePng(picture, 32, 32).fault, "");
        for (std::size_t at = 8; at < picture.size(); ++at) {
            for (const int change : {1, 2, 8, 0x80, 0xff}) {
                Bytes changed = picture;
                changed[at] = static_cast<std::uint8_t>(changed[at] ^ change);
                const DecodedImage decoded = decodePng(changed, 32, 32);
                const DecodedImage again = decodePng(changed, 32, 32);
                ASSERT_EQ(decoded.fault, again.fault);
                ASSERT_EQ(decoded.image.pixels, again.image.pixels);
                ASSERT_EQ(decoded.fault.empty(), !decoded.image.empty());
                ASSERT_EQ(decoded.fault.find("()"), std::string::npos);
                for (const char c : decoded.fault) ASSERT_TRUE(c >= ' ' && c <= '~');
                ++(decoded.fault.empty() ? images : faults);
            }
        }
    }
    EXPECT_GT(images, 100);
    EXPECT_GT(faults, 100);
}

}  // namespace
}  // namespace slicecast

#include "base/image.h"

#include "base/random.h"

#include <gtest/gtest.h>

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
    // The last 12 bytes are the end mark, whose absence stb_image forgives.
    for (std::size_t length = 0; length + 16 < bytes.size(); ++length) {
        const DecodedImage decoded = decodePng(std::span(bytes).first(length), 100, 100);
        ASSERT_TRUE(decoded.image.empty()) << length;
        ASSERT_NE(decoded.fault, "") << length;
    }
}

}  // namespace
}  // namespace slicecast

#include "lettering.h"

#include <algorithm>
#include <string_view>

#include "glyphs.h"

namespace slicecast::textures {

namespace {

constexpr int kBand = 16;

struct LetterPlace {
    int left;
    int top;
    int zoom;
    Colour colour;
};

void drawLetter(Picture& picture, char letter, const LetterPlace& place) {
    const GlyphRows& rows = glyphOf(letter);
    for (int y = 0; y < kGlyphHeight * place.zoom; ++y) {
        for (int x = 0; x < kGlyphWidth * place.zoom; ++x) {
            if (rows[static_cast<std::size_t>(y / place.zoom)]
                    [static_cast<std::size_t>(x / place.zoom)] == '#') {
                picture.at(place.left + x, place.top + y) = place.colour;
            }
        }
    }
}

}  // namespace

Picture paintLettering() {
    Picture picture(kSide, kSide);
    // Four bands of different colour around a pale, chequered field
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const int right = kSide - 1 - x;
            const int bottom = kSide - 1 - y;
            const int nearest = std::min({x, y, right, bottom});
            Colour colour = (x / 8 + y / 8) % 2 == 0 ? kCream : kStone6;
            if (nearest < kBand) {
                colour = nearest == y        ? kSea1
                         : nearest == bottom ? kClay2
                         : nearest == right  ? kBrass1
                                             : kMoss2;
            }
            picture.at(x, y) = colour;
        }
    }
    drawLetter(picture, 'N', {.left = 59, .top = 1, .zoom = 2, .colour = kCream});
    drawLetter(picture, 'S', {.left = 59, .top = kSide - 15, .zoom = 2, .colour = kCream});
    drawLetter(picture, 'W', {.left = 3, .top = 57, .zoom = 2, .colour = kCream});
    drawLetter(picture, 'E', {.left = kSide - 13, .top = 57, .zoom = 2, .colour = kCream});
    // The arrow
    constexpr int kMiddle = 64;
    for (int y = 22; y < 60; ++y) {
        const int half = y < 42 ? y - 22 : 7;
        for (int x = kMiddle - half; x < kMiddle + half; ++x) {
            picture.at(x, y) = kClay3;
        }
    }
    // The word
    constexpr std::string_view kWord = "READ";
    constexpr int kZoom = 4;
    int left = 18;
    for (const char letter : kWord) {
        drawLetter(picture, letter, {.left = left, .top = 70, .zoom = kZoom, .colour = kInk});
        left += (kGlyphWidth + 1) * kZoom - 1;
    }
    // A dot in the upper left corner of the field
    for (int y = 20; y < 30; ++y) {
        for (int x = 20; x < 30; ++x) {
            picture.at(x, y) = kPlum;
        }
    }
    return picture;
}

}  // namespace slicecast::textures

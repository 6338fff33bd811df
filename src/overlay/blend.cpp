#include "overlay/blend.h"

#include "render/pixels/vectors.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace slicecast {
namespace {

// blended() for four pixels at a time.
[[maybe_unused]] inline U32x4 blendedFour(U32x4 under, U32x4 over) {
    const U32x4 two = allLanes(kRedAndBlue);
    const U32x4 alphas = over >> 24;
    const U16x8 alpha = (U16x8)(alphas | alphas << 16);
    const U16x8 rest = (U16x8)two - alpha;
    const U16x8 half = (U16x8)allLanes(0x00800080);
    const U16x8 even = (U16x8)(over & two) * alpha + ((U16x8)(under & two) * rest + half);
    const U16x8 odd = ((U16x8)over >> 8) * alpha + (((U16x8)under >> 8) * rest + half);
    return (U32x4)((even + (even >> 8)) >> 8) | ((U32x4)(odd + (odd >> 8)) & ~two) |
           allLanes(kOpaque);
}

// True if four pixels are fully transparent.
[[maybe_unused]] inline bool isClear(const Pixel* four) {
    std::uint64_t halves[2];
    std::memcpy(halves, four, sizeof halves);
    return (halves[0] | halves[1]) == 0;
}

// `next` is the step of `over` from pixel to pixel: 1, or 0 for four equal pixels.
void blendPixels(Pixel* row, int count, const Pixel* over, int next) {
    int x = 0;
    if constexpr (kHasVectors) {
        for (; x + 4 <= count; x += 4) {
            const Pixel* const four = over + x * next;
            if (!isClear(four))
                storeVector(row + x,
                            blendedFour(loadVector<U32x4>(row + x), loadVector<U32x4>(four)));
        }
    }
    for (; x < count; ++x) row[x] = blended(row[x], over[x * next]);
}

}  // namespace

void blendRow(Pixel* row, int count, Colour colour) {
    const Pixel over = toPixel(colour);
    const Pixel four[] = {over, over, over, over};
    blendPixels(row, count, four, 0);
}

void blendRow(Pixel* row, int count, const Pixel* over) {
    blendPixels(row, count, over, 1);
}

void blendPixel(const Picture& picture, int x, int y, Colour colour) {
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
    Pixel& pixel = picture.row(y)[x];
    pixel = blended(pixel, colour);
}

void blendRect(const Picture& picture, PixelRect rect, Colour colour) {
    const int firstX = std::max(rect.x, 0);
    const int firstY = std::max(rect.y, 0);
    const int lastX = std::min(rect.x + rect.width, picture.width);
    const int lastY = std::min(rect.y + rect.height, picture.height);
    for (int y = firstY; y < lastY; ++y) blendRow(picture.row(y) + firstX, lastX - firstX, colour);
}

void drawPanel(const Picture& picture, PixelRect rect, int scale) {
    if (rect.width < 5 * scale || rect.height < 5 * scale) return;
    const int rim = (scale + 1) / 2;
    for (int y = 0; y < rect.height; ++y) {
        const int fromEdge = std::min(y, rect.height - 1 - y);
        const int inset = plateInset(fromEdge, scale);
        // The rim follows the corner: it ends where the row one rim further out ends
        const int side = fromEdge < rim ? rect.width / 2
                                        : std::max(inset + rim, plateInset(fromEdge - rim, scale));
        const int row = rect.y + y;
        const int width = rect.width - 2 * side;
        blendRect(picture, {rect.x + inset, row, side - inset, 1}, kPanelRim);
        blendRect(picture, {rect.x + side, row, width, 1},
                  fromEdge < rim ? kPanelRim : kPanelColour);
        blendRect(picture, {rect.x + rect.width - side, row, side - inset, 1}, kPanelRim);
    }
}

}  // namespace slicecast

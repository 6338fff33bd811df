#include "overlay/pixel_grid.h"

#include "base/words.h"
#include "overlay/blend.h"
#include "overlay/layout.h"
#include "overlay/text.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace slicecast {
namespace {

constexpr int kFine = 10;
constexpr int kClear = 100;
constexpr int kLabelDots = 4 * kGlyphAdvance + 6;  // four digits and a gap
// A dark line beside each light one keeps it visible over bright scenes.
constexpr Colour kFineLight = {255, 255, 255, 26};
constexpr Colour kFineDark = {0, 0, 0, 26};
constexpr Colour kClearLight = {255, 255, 255, 150};
constexpr Colour kClearDark = {0, 0, 0, 110};

void drawLabel(const Picture& picture, int x, int y, int number, int scale) {
    std::array<char, 12> text;
    const std::string_view label = write(text, number);
    blendRect(picture, {x, y, textWidth(label, scale) + 4 * scale, 11 * scale}, kPanelColour);
    drawText(picture, x + 2 * scale, y + 2 * scale, label, {.scale = scale});
}

// The vertical lines, drawn row by row, because a line's next pixel is far away in memory. The
// pattern repeats with each strong line; the left edge has none.
void drawUpright(const Picture& picture, int wide) {
    std::array<Pixel, kClear> over{};
    for (int x = 0; x < kClear; ++x) {
        const bool clear = x < 2 * wide;
        const int width = clear ? wide : 1;
        const int from = clear ? x : x % kFine;
        if (from < width) {
            over[static_cast<std::size_t>(x)] = toPixel(clear ? kClearLight : kFineLight);
        } else if (from < 2 * width) {
            over[static_cast<std::size_t>(x)] = toPixel(clear ? kClearDark : kFineDark);
        }
    }
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; x += kClear) {
            const int edge = x == 0 ? kFine : 0;
            blendRow(picture.row(y) + x + edge, std::min(kClear, picture.width - x) - edge,
                     over.data() + edge);
        }
    }
}

}  // namespace

void drawPixelGrid(const Picture& picture) {
    const int scale = readableScale(picture.width, picture.height);
    const int wide = lineWidth(scale);
    drawUpright(picture, wide);
    for (int y = kFine; y < picture.height; y += kFine) {
        const bool clear = y % kClear == 0;
        const int width = clear ? wide : 1;
        blendRect(picture, {0, y, picture.width, width}, clear ? kClearLight : kFineLight);
        blendRect(picture, {0, y + width, picture.width, width}, clear ? kClearDark : kFineDark);
    }

    // The numbers are along the middle lines, where no panel is; at every second line or fewer if
    // they are too wide.
    const int step = (kLabelDots * scale + kClear - 1) / kClear * kClear;
    const int middleX = picture.width / 2 / kClear * kClear;
    const int middleY = picture.height / 2 / kClear * kClear;
    for (int x = step; x < picture.width; x += step)
        drawLabel(picture, x + 2 * wide, middleY + 2 * wide, x, scale);
    for (int y = kClear; y < picture.height; y += kClear) {
        if (y != middleY) drawLabel(picture, middleX + 2 * wide, y + 2 * wide, y, scale);
    }
}

}  // namespace slicecast

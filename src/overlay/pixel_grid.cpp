#include "overlay/pixel_grid.h"

#include "base/words.h"
#include "overlay/blend.h"
#include "overlay/layout.h"
#include "overlay/text.h"

#include <algorithm>
#include <array>

namespace slicecast {
namespace {

constexpr int kFine = 10;
constexpr int kClear = 100;
constexpr int kLabelDots = 4 * kGlyphAdvance + 6;  // of four digits, and a gap
// A dark line beside each light one shows it over bright scenes too.
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

// What the upright lines leave of a row; clear ones are `wide` pixels wide.
void drawUpright(Pixel* row, int count, int wide) {
    for (int x = kFine; x < count; x += kFine) {
        if (x % kClear == 0) {
            blendRow(row + x, std::min(wide, count - x), kClearLight);
            blendRow(row + x + wide, std::min(wide, count - x - wide), kClearDark);
        } else {
            for (int i = 0; i < 2 && x + i < count; ++i)
                row[x + i] = blended(row[x + i], i == 0 ? toPixel(kFineLight) : toPixel(kFineDark));
        }
    }
}

}  // namespace

void drawPixelGrid(const Picture& picture) {
    const int scale = readableScale(picture.width, picture.height);
    const int wide = lineWidth(scale);
    // Row by row, for the next pixel of an upright line is far away in memory
    for (int y = 0; y < picture.height; ++y) drawUpright(picture.row(y), picture.width, wide);
    for (int y = kFine; y < picture.height; y += kFine) {
        const bool clear = y % kClear == 0;
        const int width = clear ? wide : 1;
        blendRect(picture, {0, y, picture.width, width}, clear ? kClearLight : kFineLight);
        blendRect(picture, {0, y + width, picture.width, width}, clear ? kClearDark : kFineDark);
    }

    // The numbers run along the middle lines, where no panel stands; at every second line or more
    // where they are wider than it is to the next.
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

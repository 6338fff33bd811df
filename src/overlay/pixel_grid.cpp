#include "overlay/pixel_grid.h"

#include "base/words.h"
#include "overlay/blend.h"
#include "overlay/layout.h"
#include "overlay/text.h"

#include <array>

namespace slicecast {
namespace {

constexpr int kFine = 10;
constexpr int kClear = 100;
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

}  // namespace

void drawPixelGrid(const Picture& picture) {
    for (int x = kFine; x < picture.width; x += kFine) {
        const bool clear = x % kClear == 0;
        blendRect(picture, {x, 0, 1, picture.height}, clear ? kClearLight : kFineLight);
        blendRect(picture, {x + 1, 0, 1, picture.height}, clear ? kClearDark : kFineDark);
    }
    for (int y = kFine; y < picture.height; y += kFine) {
        const bool clear = y % kClear == 0;
        blendRect(picture, {0, y, picture.width, 1}, clear ? kClearLight : kFineLight);
        blendRect(picture, {0, y + 1, picture.width, 1}, clear ? kClearDark : kFineDark);
    }

    // The numbers run along the middle lines, where no panel stands.
    const int scale = readableScale(picture.width, picture.height);
    const int middleX = picture.width / 2 / kClear * kClear;
    const int middleY = picture.height / 2 / kClear * kClear;
    for (int x = kClear; x < picture.width; x += kClear)
        drawLabel(picture, x + 2, middleY + 2, x, scale);
    for (int y = kClear; y < picture.height; y += kClear) {
        if (y != middleY) drawLabel(picture, middleX + 2, y + 2, y, scale);
    }
}

}  // namespace slicecast

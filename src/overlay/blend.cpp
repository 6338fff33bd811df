#include "overlay/blend.h"

#include <algorithm>

namespace slicecast {

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
    for (int y = firstY; y < lastY; ++y) {
        for (int x = firstX; x < lastX; ++x) {
            Pixel& pixel = picture.row(y)[x];
            pixel = blended(pixel, colour);
        }
    }
}

void drawPanel(const Picture& picture, PixelRect rect) {
    if (rect.width < 3 || rect.height < 3) return;
    blendRect(picture, {rect.x + 1, rect.y + 1, rect.width - 2, rect.height - 2}, kPanelColour);
    blendRect(picture, {rect.x + 1, rect.y, rect.width - 2, 1}, kPanelRim);
    blendRect(picture, {rect.x + 1, rect.y + rect.height - 1, rect.width - 2, 1}, kPanelRim);
    blendRect(picture, {rect.x, rect.y + 1, 1, rect.height - 2}, kPanelRim);
    blendRect(picture, {rect.x + rect.width - 1, rect.y + 1, 1, rect.height - 2}, kPanelRim);
}

}  // namespace slicecast

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

void drawPanel(const Picture& picture, PixelRect rect, int scale) {
    if (rect.width < 5 * scale || rect.height < 5 * scale) return;
    const int rim = (scale + 1) / 2;
    for (int y = 0; y < rect.height; ++y) {
        const int fromEdge = std::min(y, rect.height - 1 - y);
        const int inset = plateInset(fromEdge, scale);
        // The rim goes round the corner: where the row that lies a rim further out ends
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

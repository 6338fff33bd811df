#include "overlay/layout.h"

#include "overlay/panels.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr int kLeastMinimap = 15;    // pixels; below it there is nothing to see
constexpr int kLeastSideWidth = 90;  // dots of the font; below it a side view cannot be read
constexpr int kLeastSideHeight = 60;

PixelRect ifInside(PixelRect rect, int pictureWidth, int pictureHeight) {
    const bool inside = rect.x >= 0 && rect.y >= 0 && rect.x + rect.width <= pictureWidth &&
                        rect.y + rect.height <= pictureHeight;
    return inside ? rect : PixelRect{};
}

}  // namespace

int readableScale(int pictureWidth, int pictureHeight) {
    return 1 + std::min(pictureWidth / 800, pictureHeight / 480);
}

int overlayMargin(int pictureWidth, int pictureHeight) {
    return 2 + std::min(pictureWidth, pictureHeight) / 80;
}

OverlayLayout layoutOverlays(int pictureWidth, int pictureHeight) {
    OverlayLayout layout;
    layout.margin = overlayMargin(pictureWidth, pictureHeight);
    const int margin = layout.margin;
    const int panelHeights = panelHeightDots(kPlayerPanelRows) + panelHeightDots(kProcessPanelRows);
    layout.scale = readableScale(pictureWidth, pictureHeight);
    while (layout.scale > 1 && panelHeights * layout.scale + 3 * margin > pictureHeight)
        --layout.scale;

    // The map, a third of the shorter side
    const int side = std::min(pictureWidth, pictureHeight) / 3;
    if (side >= kLeastMinimap) layout.minimap = {margin, margin, side, side};

    // The two panels of text along the right edge
    const int panelWidth = panelWidthDots() * layout.scale;
    const int playerHeight = panelHeightDots(kPlayerPanelRows) * layout.scale;
    const int processHeight = panelHeightDots(kProcessPanelRows) * layout.scale;
    const int panelX = pictureWidth - margin - panelWidth;
    layout.player =
        ifInside({panelX, margin, panelWidth, playerHeight}, pictureWidth, pictureHeight);
    layout.process =
        ifInside({panelX, pictureHeight - margin - processHeight, panelWidth, processHeight},
                 pictureWidth, pictureHeight);

    // What is left of them below the map
    const int width = panelX - 2 * margin;
    const int height = std::min(pictureHeight - side - 3 * margin, pictureHeight * 2 / 5);
    if (width >= kLeastSideWidth * layout.scale && height >= kLeastSideHeight * layout.scale) {
        layout.sideView = {margin, pictureHeight - margin - height, width, height};
    }
    return layout;
}

}  // namespace slicecast

#include "overlay/layout.h"

#include "overlay/panels.h"
#include "overlay/text.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr int kLeastMinimap = 15;    // pixels; nothing is visible in a smaller one
constexpr int kSmallMinimap = 96;    // pixels; up to this size it may exceed a third of the picture
constexpr int kLeastSideWidth = 90;  // dots of the font; a smaller side view cannot be read
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
    const int playerDots = panelHeightDots(kPlayerPanelRows);
    const int processDots = panelHeightDots(kProcessPanelRows) + kProcessPanelRules * kRuleAdvance;
    layout.scale = readableScale(pictureWidth, pictureHeight);
    while (layout.scale > 1 &&
           (playerDots + processDots) * layout.scale + 3 * margin > pictureHeight)
        --layout.scale;

    // The minimap: a third of the shorter side, more in small pictures
    const int shorter = std::min(pictureWidth, pictureHeight);
    const int side = std::max(shorter / 3, std::min(kSmallMinimap, shorter * 2 / 5));
    if (side >= kLeastMinimap) layout.minimap = {margin, margin, side, side};

    // The two panels of text along the right edge; the second one shows only its first rows if not
    // all fit
    const int panelWidth = kPanelWidth * layout.scale;
    const int playerHeight = playerDots * layout.scale;
    const int panelX = pictureWidth - margin - panelWidth;
    const bool besideMap = panelX >= side + 2 * margin;
    if (besideMap)
        layout.player =
            ifInside({panelX, margin, panelWidth, playerHeight}, pictureWidth, pictureHeight);
    const int room = pictureHeight - playerHeight - 3 * margin;
    layout.processRows = kProcessPanelRows;
    int processHeight = processDots * layout.scale;
    if (processHeight > room) {
        const int around = panelHeightDots(0) * layout.scale;
        layout.processRows =
            std::clamp((room - around) / (kLineAdvance * layout.scale), 0, kProcessPanelRows - 1);
        processHeight = panelHeightDots(layout.processRows) * layout.scale;
    }
    if (layout.processRows > 0 && panelX >= margin)
        layout.process =
            ifInside({panelX, pictureHeight - margin - processHeight, panelWidth, processHeight},
                     pictureWidth, pictureHeight);

    // The side view in the remaining space below the minimap
    const int width = panelX - 2 * margin;
    const int height = std::min(pictureHeight - side - 3 * margin, pictureHeight * 2 / 5);
    if (width >= kLeastSideWidth * layout.scale && height >= kLeastSideHeight * layout.scale) {
        layout.sideView = {margin, pictureHeight - margin - height, width, height};
    }
    return layout;
}

}  // namespace slicecast

// Places the overlays: all keep the margin, and none overlap.
//
//     +---------+               +--------+
//     | minimap |               | player |
//     +---------+               +--------+
//
//     +--------------------+   +---------+
//     |     side view      |   | process |
//     +--------------------+   +---------+
//
// All in pixels of the picture. A rectangle of width 0 has no room.
#pragma once

#include "overlay/blend.h"

namespace slicecast {

inline constexpr int kPanelPadding = 5;  // dots of the font between a panel's edge and its text

struct OverlayLayout {
    // Pixels per dot of the font: readableScale(), or less if the panels would not fit
    int scale = 1;
    int margin = 0;  // around and between the panels
    PixelRect minimap;
    PixelRect player;
    PixelRect process;
    int processRows = 0;  // rows that fit into it
    PixelRect sideView;
};

// The scale at which text is readable in a picture of this size: 1, from 800 x 480 on 2, from 1600
// x 960 on 3, and so on.
int readableScale(int pictureWidth, int pictureHeight);

// Width of a fine line at a scale of text, pixels; visible in large pictures too.
constexpr int lineWidth(int scale) {
    return (scale + 1) / 2;
}

// Distance between the picture's edge and a panel, pixels.
int overlayMargin(int pictureWidth, int pictureHeight);

OverlayLayout layoutOverlays(int pictureWidth, int pictureHeight);

}  // namespace slicecast

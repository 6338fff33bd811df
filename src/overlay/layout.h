// Where the overlays stand: all on one margin, none on another.
//
//     +---------+               +--------+
//     | minimap |               | player |
//     +---------+               +--------+
//
//     +--------------------+   +---------+
//     |     side view      |   | process |
//     +--------------------+   +---------+
//
// All in pixels of the picture. A rectangle without width has no room.
#pragma once

#include "overlay/blend.h"

namespace slicecast {

inline constexpr int kPanelPadding = 5;  // dots of the font, from a panel's edge to its text

struct OverlayLayout {
    int scale = 1;  // pixels that a dot of the font is wide and high: a readable one, or less where
                    // the panels would not fit
    int margin = 0;  // around and between the panels
    PixelRect minimap;
    PixelRect player;
    PixelRect process;
    int processRows = 0;  // that it has room for
    PixelRect sideView;
};

// The scale at which text is readable in a picture of that size: 1, or 2 from 800 x 480 on, 3 from
// 1600 x 960 on ...
int readableScale(int pictureWidth, int pictureHeight);

// Of a fine line at a scale of text, pixels: so it is seen in large pictures too.
constexpr int lineWidth(int scale) {
    return (scale + 1) / 2;
}

// From the picture's edge to a panel.
int overlayMargin(int pictureWidth, int pictureHeight);

OverlayLayout layoutOverlays(int pictureWidth, int pictureHeight);

}  // namespace slicecast

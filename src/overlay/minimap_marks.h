// Draws on the minimap: the eye with its view and reach, north, and the levels.
#pragma once

#include "overlay/minimap_view.h"
#include "render/eye.h"
#include "slicecast/picture.h"
#include "world/map.h"

namespace slicecast {

// A translucent disc with a rim, for the reach.
void drawMinimapReach(const MinimapView& view, double reach, const Picture& picture);

// An N on the rim that marks north.
void drawMinimapNorth(const MinimapView& view, int scale, const Picture& picture);

// The levels of the map as a stack of bars in the lower left corner: those below in their tones on
// the map, the shown one with its number, those above as outlines. A dot marks the eye's.
struct MinimapLevels {
    int count = 1;
    int shown = 0;
    int eye = 0;
};
void drawMinimapLevels(const MinimapLevels& levels, const MinimapView& view, int scale,
                       const Picture& picture);

// The field of view, fading with distance, and the eye as an arrow head.
void drawMinimapEye(const MinimapView& view, const Eye& eye, double fovDegrees,
                    const Picture& picture);

}  // namespace slicecast

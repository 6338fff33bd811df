// What lies on the map of a minimap: the eye and what it sees and reaches, north, and the levels.
#pragma once

#include "overlay/minimap_view.h"
#include "render/eye.h"
#include "slicecast/picture.h"
#include "world/map.h"

namespace slicecast {

// A translucent disc with a rim.
void drawMinimapReach(const MinimapView& view, double reach, const Picture& picture);

// Where north is, on the rim.
void drawMinimapNorth(const MinimapView& view, int scale, const Picture& picture);

// The levels of the map as a stack of bars in the lower left corner, in the tones that they have on
// it: those below, the one that is shown with its number, and those above as outlines. A dot is the
// eye's.
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

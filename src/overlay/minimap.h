// The map from above, around the eye, in the upper left corner of a picture, north up or the way
// that the eye looks; an N on the rim is north. It shows one level, and what is below and above it:
//
//     brick red, the brighter the higher      a block of part of the level's height
//     slate blue                              a block that reaches the level's upper edge
//     either of these, half through           a block that stands in the air
//     grey, the darker the deeper             no block: how far down the ground lies below
//     its own colour over the ground          water
//     a light edge, a shadow                  a step down to the next tile, a step up
//     a dashed line                           where something above the level begins
//     gold; a golden frame                    a gate that is shut; one that is open
//     purple stripes                          a block that moves
//     nothing                                 outside the grid
//     turquoise                               portals: a block's side, or a whole tile
//     pale, or magenta with a line ahead      objects that stand still, and that move (see
//                                             minimap_objects.h)
//
// A stack of bars in the lower left corner has a bar for each level, in the tone that its ground
// has on the map, with the number of the level that is shown and a dot beside the eye's.
//
// A yellow arrow is the eye, with the field that it sees before it, and a circle about it as far as
// it reaches. Green lines are level rays, each to the first block of the level that stands at their
// height or to a portal, never into the map behind it.
#pragma once

#include "overlay/minimap_map.h"
#include "render/classic/classic_options.h"
#include "render/eye.h"
#include "slicecast/picture.h"
#include "world/world.h"

namespace slicecast {

inline constexpr int kMinimapRays =
    25;  // over the field of view, as evenly as the slices of a picture

struct MinimapOptions {
    int level = -1;  // the level shown, clamped to the map's; -1 for the one that the eye is on
    double fovDegrees = 60.0;  // of the field that the eye sees
    bool rays = false;
    bool turns = false;           // with the way that the eye looks up; else north
    double reach = 0.0;           // radius of the circle, units; 0 for none
    double classicShare = 0.0;    // of the picture's width, from the left: these rays go by the
    ClassicOptions classic = {};  // classic method
};

// Where the minimap stands and how large it is, in pixels.
struct MinimapLayout {
    int left = 0;
    int top = 0;
    int side = 0;  // of the square with its rim; 0 if the picture is too small for one
    int pixelsPerTile = 0;
};
MinimapLayout layoutMinimap(int pictureWidth, int pictureHeight);

// The level that is shown.
int minimapLevel(const Map& map, const Eye& eye, const MinimapOptions& options);

class Minimap {
public:
    // Draws it; without allocating memory, once it has drawn one of that size. Nothing for an eye
    // in a map that does not exist.
    void draw(const World& world, const Eye& eye, const MinimapOptions& options,
              const Picture& picture);

    // Of the map, so far: only those of which something has changed.
    long drawnTiles() const { return map_.drawnTiles(); }

private:
    MinimapMap map_;
};

}  // namespace slicecast

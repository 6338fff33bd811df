// The map from above, around the eye, in the upper left corner of a picture. North is up, or the
// eye's heading; an N on the rim marks north. It shows one level, with hints of the levels below
// and above:
//
//     brick red, brighter when higher         a block lower than the level
//     slate blue                              a block that reaches the top of the level
//     either of these, translucent            a block that floats
//     grey, darker when deeper                no block: the depth of the ground below
//     blue over the ground                    water
//     a light edge, a shadow                  a step down to the next tile, a step up
//     a dashed line                           the edge of a block above the level
//     gold; a golden frame                    a shut gate; an open one
//     purple stripes                          a moving block
//     nothing                                 outside the grid
//     turquoise                               portals: a block's side, or a whole tile
//     pale, or magenta with a line ahead      still objects; moving ones (see
//                                             minimap_objects.h)
//
// A stack in the lower left corner has a bar for each level, in the tone of its ground on the map.
// The shown level has its number, and the eye's level a dot.
//
// A yellow arrow is the eye, with its field of view ahead and a circle for its reach. Green lines
// are horizontal rays, each up to the first block of the level at their height or to a portal,
// never into the map behind it.
#pragma once

#include "classic/classic_options.h"
#include "overlay/minimap_map.h"
#include "render/eye.h"
#include "slicecast/picture.h"
#include "world/world.h"

namespace slicecast {

// Spread over the field of view as evenly as the slices of a picture.
inline constexpr int kMinimapRays = 25;

struct MinimapOptions {
    int level = -1;            // the level shown, clamped to the map's; -1 for the eye's
    double fovDegrees = 60.0;  // of the field of view
    bool rays = false;
    bool turns = false;           // the eye's heading is up; else north is up
    double reach = 0.0;           // radius of the circle, units; 0 for none
    double classicShare = 0.0;    // part of the width, from the left, whose rays
    ClassicOptions classic = {};  // follow the classic method
};

// The minimap's place and size, in pixels.
struct MinimapLayout {
    int left = 0;
    int top = 0;
    int side = 0;  // of the square with its rim; 0 if the picture is too small
    int pixelsPerTile = 0;
};
MinimapLayout layoutMinimap(int pictureWidth, int pictureHeight);

// The level to show.
int minimapLevel(const Map& map, const Eye& eye, const MinimapOptions& options);

class Minimap {
public:
    // Draws the minimap. Allocates no memory after the first drawing of the same size. Draws
    // nothing if the eye's map does not exist.
    void draw(const World& world, const Eye& eye, const MinimapOptions& options,
              const Picture& picture);

    // Tiles drawn so far; only those that have changed are redrawn.
    long drawnTiles() const { return map_.drawnTiles(); }

private:
    MinimapMap map_;
};

}  // namespace slicecast

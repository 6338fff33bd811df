// Blueprints: named descriptions that many cells share.
#pragma once

#include "base/coordinate.h"
#include "slicecast/colour.h"
#include "slicecast/face.h"
#include "world/baked_light.h"
#include "world/plan.h"
#include "world/slope.h"

#include <array>
#include <cstdint>
#include <string>

namespace slicecast {

using TextureId = std::uint16_t;  // index into World::textures
inline constexpr TextureId kNoTexture = 0xffff;

using BlueprintId = std::uint16_t;  // index into World::blueprints; 0 is the empty cell
inline constexpr BlueprintId kEmptyCell = 0;

using PortalId = std::uint16_t;  // index into World::portals
inline constexpr PortalId kNoPortal = 0xffff;

inline constexpr Colour kWaterColour = {38, 92, 104, 255};
inline constexpr double kWaterSight = 8.0;

struct FaceBlueprint {
    TextureId texture = kNoTexture;
    double light = 1.0;  // factor on the map's light, 0 to 1
    // The factor alone sets the brightness, at any distance and whatever the map's light.
    bool glow = false;
    std::uint8_t mirror = 0;      // of a top face: strength of its reflection, of 255
    std::uint8_t ripples = 0;     // of a mirror: how far waves move its reflection, of 255
    PortalId portal = kNoPortal;  // the face leads to another place
    LampId lamp = kNoLamp;        // before its middle; only of blocks that stand still
};

// A filled cell: the box between `bottom` and `top` above its level's base, over the whole tile or
// over the part of it that `plan` says; `slopes` may cut off a part of the box above and below.
// Blocks that move, open or lead elsewhere get blueprints of their own when the world is made,
// because each step may change their edges and textures. While top <= bottom their cells are empty
// (see Map::occupied).
struct CellBlueprint {
    std::string name;
    Coordinate bottom;             // its lowest point, 0 <= bottom < top
    Coordinate top = tileEdge(1);  // its highest, <= 1
    Plan plan;                     // see markPlans; not of water or blocks with portals
    Slopes slopes;                 // not of water, halves, nor blocks with portals
    std::array<FaceBlueprint, kFaces> faces;
    bool seeThrough = false;  // a texel of a face has alpha below 255; set by markSeeThrough
    bool join =
        true;  // leaves out the two faces between touching see-through blocks of this blueprint

    bool passable = false;  // bodies go through it, as through an open gate
    bool isWater = false;   // see world/water.h; counts as see-through, and faces without a texture
                            // are not drawn
    Colour waterColour = kWaterColour;  // under water everything fades to this colour with distance
    double waterSight = kWaterSight;  // units, > 0: from this distance on only that colour is seen
    bool hasPortals = false;          // a face has one; set by markPortals
    // How far its motion has moved its textures up, east and south, 0 to 1; they wrap around
    Coordinate textureRise;
    Coordinate textureEast;
    Coordinate textureSouth;
    BlueprintId origin = kEmptyCell;  // the blueprint that this one was made from, if it moves,
                                      // opens, has portals or is a variant; else empty
    // Cells of this blueprint show it or one of its variants (see variants.h), which are the
    // blueprints from `firstVariant` on. `variants` counts it too; 1 if it has none.
    BlueprintId firstVariant = kEmptyCell;
    std::uint16_t variants = 1;
    int mover = -1;      // index into World::movers, of which this block is a part; -1 for none
    int motion = -1;     // index into World::motions; -1 for still blocks
    int gate = -1;       // index into World::gateKinds; -1 for other blocks
    int gateIndex = -1;  // index into World::gates, of which this block is a part; -1 for none

    // Neither moves nor opens.
    bool isStill() const { return motion < 0 && gate < 0; }
    // Reaches the upper end of its level everywhere, or the lower one.
    bool fillsUp() const { return top == tileEdge(1) && slopes.top.isLevel(); }
    bool fillsDown() const { return bottom == Coordinate{0} && slopes.bottom.isLevel(); }
    // A part of a block that moves up and down, whose slope goes on in the level above, or below.
    bool isCutAbove() const { return !slopes.top.isLevel() && slopes.top.most() > top; }
    bool isCutBelow() const { return !slopes.bottom.isLevel() && slopes.bottom.least() < bottom; }
    // Reaches the upper end of its level somewhere at least, or the lower one.
    bool goesUp() const { return fillsUp() || isCutAbove(); }
    bool goesDown() const { return fillsDown() || isCutBelow(); }
    // Fills its tile and is level.
    bool isBox() const { return plan.isWhole() && !slopes.any(); }
    const FaceBlueprint& face(Face f) const { return faces[static_cast<std::size_t>(f)]; }
};

}  // namespace slicecast

// Blueprints: named descriptions that many cells share.
#pragma once

#include "base/coordinate.h"
#include "slicecast/colour.h"
#include "slicecast/face.h"

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
    bool glow =
        false;  // the factor is all: as bright as that at any distance, whatever the map's light
    std::uint8_t mirror = 0;      // of a top face: how much of what is above shows in it, of 255
    PortalId portal = kNoPortal;  // who or what comes in through this face is elsewhere
};

// A filled cell: the box between `bottom` and `top` above its level's base. What moves, opens, or
// leads elsewhere has blueprints of its own, made when the world is: its edges and textures may
// change with every step. While top <= bottom its cells are empty (see Map::occupied).
struct CellBlueprint {
    std::string name;
    Coordinate bottom;             // 0 <= bottom < top
    Coordinate top = tileEdge(1);  // <= 1
    std::array<FaceBlueprint, kFaces> faces;
    bool seeThrough = false;  // a texel of a face has alpha below 255; set by markSeeThrough
    bool join = true;         // where two see-through blocks of this blueprint touch, the two faces
                              // between them are left out

    bool passable = false;  // bodies go through it: an open gate
    bool isWater = false;   // bodies get into it, see world/water.h; counts as see-through, and
                            // faces without a texture are not there
    Colour waterColour = kWaterColour;  // what an eye in it sees all in, the more the farther
    double waterSight = kWaterSight;    // units, > 0: from there on it sees this colour alone
    bool hasPortals = false;            // a face has one; set by markPortals
    Coordinate textureRise;  // by which what moves has carried its sides' textures up, 0 to 1; they
                             // begin anew where they end
    BlueprintId origin = kEmptyCell;  // what it was made from, as one that moves, opens or has
                                      // portals; empty for those of the scene's text
    int mover = -1;   // the thing that moves as one, of which this block is a part; -1 for none
    int motion = -1;  // index into World::motions; -1 for what stands still
    int gate = -1;    // index into World::gateKinds; -1 for what is no gate

    const FaceBlueprint& face(Face f) const { return faces[static_cast<std::size_t>(f)]; }
};

}  // namespace slicecast

// Gates: blocks that open and close.
//
//     closed -> opening -> open -> closing -> closed         at any moment the other way round, from the progress reached
//
// Cells of one gate's blueprint that touch, side by side or stacked, are one gate. Bodies go
// through it only while it is fully open. A gate never closes on anyone: it waits, still open,
// until nobody is in it. Its faces that show a held sheet show the frame of its progress, the last
// one when it is open.
#pragma once

#include "base/coordinate.h"
#include "world/blueprint.h"
#include "world/placing_fault.h"

#include <cstdint>
#include <span>
#include <vector>

namespace slicecast {

struct Body;
struct World;

inline constexpr double kLongestGate = 60.0;   // seconds, to open and to hold
inline constexpr double kFarthestGate = 64.0;  // units, to reach and to approach

// What a blueprint says of its gates.
struct GateKind {
    int steps = 96;  // from closed to open, > 0
    Coordinate reach =
        tileEdge(2);    // how far an eye may be that opens it, from the nearest point of its blocks
    bool keyed = true;  // opened and closed by whoever is within reach
    bool opensOnApproach = false;
    Coordinate approach = {};  // a body that comes this near opens it
    int holdSteps = 120;       // and it closes when nobody has been that near for so long
    bool startsOpen = false;
};

struct GateBox {
    int x = 0;
    int y = 0;
    Coordinate bottom;  // above the map's floor
    Coordinate top;
};

// A face that shows a sheet: frame 0 is `first`, frame n is `later` + n - 1.
struct GateFace {
    BlueprintId part = kEmptyCell;
    Face face = Face::north;
    TextureId first = kNoTexture;
    TextureId later = kNoTexture;
    int frames = 1;
};

enum class GateState : std::uint8_t { closed, opening, open, closing };

struct Gate {
    int map = 0;  // indices into World::maps and World::gateKinds
    int kind = 0;
    std::vector<BlueprintId> parts;
    std::vector<GateBox> boxes;
    std::vector<GateFace> faces;
    int progress = 0;  // steps, 0 is closed
    bool wantsOpen = false;
    bool isNear = false;  // somebody has approached
    int awaySteps = 0;    // since nobody was near
};

// What somebody asks of the gates within reach of an eye. To close one that has somebody in it is
// granted when they have gone.
struct GateAsk {
    enum class Wish : std::uint8_t { nothing, change, open, close };
    Wish wish = Wish::nothing;
    int map = 0;
    Coordinate x;
    Coordinate y;
    Coordinate z;
};

// Finds the gates of a world whose cells are complete, and puts them in their first state. What it
// gives is wrong with the world, which is of no use then.
std::vector<PlacingFault> makeGates(World& world);

// Textures for the frames of the sheets that the gates show. For a world whose textures have been
// read, before markSeeThrough.
void makeGateFrames(World& world);

// What the key would do to the gates that hear it there: the wish itself does not matter. Where one
// would open and another one close, it is open.
enum class GateOffer : std::uint8_t { none, open, close };
GateOffer gateOffer(const World& world, const GateAsk& ask);

// One step of all of them. The bodies stay where they are.
void stepGates(World& world, std::span<Body> bodies, const GateAsk& ask);

// Back to the beginning.
void resetGates(World& world);

GateState stateOf(const Gate& gate, const GateKind& kind);

}  // namespace slicecast

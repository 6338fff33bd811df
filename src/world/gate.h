// Gates: blocks that open and close.
//
//     closed -> opening -> open -> closing -> closed     it may reverse at any moment
//
// Cells of one gate's blueprint that touch, side by side or stacked, are one gate. Faces with a
// held sheet show the frame of the gate's progress, the last one when it is open.
//
// A gate with a motion is a mover that goes as far as the gate is open, and waits where bodies are
// in its way (see mover.h). Any other gate stays where it is: bodies pass only while it is fully
// open, and it never closes on a body, but stays open until nobody is inside.
//
// Gates open and shut by keys, for whoever comes near, at regular times, or with other gates, which
// then are switches.
#pragma once

#include "base/coordinate.h"
#include "world/blueprint.h"
#include "world/box.h"
#include "world/placing_fault.h"
#include "world/quest.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace slicecast {

struct Body;
struct World;

inline constexpr std::size_t kMaxGateCells = 1024;  // of all gates of a world
// How many pairs of a gate that opens on approach, and a body, a step compares. Where there are
// more, the gates look for bodies in turn.
inline constexpr std::size_t kMostApproachLooks = 1 << 16;
inline constexpr double kLongestGate = 60.0;   // seconds; for opening and for holding
inline constexpr double kFarthestGate = 64.0;  // units; for reach and approach

// The properties of the gates of one blueprint.
struct GateKind {
    int steps = 96;  // from closed to open, > 0
    // Keys work within this distance, from the eye to the nearest point of the gate's blocks.
    Coordinate reach = tileEdge(2);
    bool keyed = true;  // keys within reach open and close it
    bool opensOnApproach = false;
    Coordinate approach = {};  // a body that comes this close opens it
    int holdSteps = 120;       // it closes after nobody has been that close for this long, > 0
    int everySteps = 0;        // it also opens by itself so often; 0 for never
    bool once = false;         // it never closes again
    bool startsOpen = false;
    std::vector<int> follows =
        {};                   // kinds, each once: it opens when a gate of one is open, else closes
    Needs needs = {};         // it opens only for a player who has these finds
    std::string locked = {};  // the message without them; empty for one that says what is missing

    std::vector<int> followers = {};  // kinds that follow it and stand in a map, set by makeGates
    // Of the present step.
    bool isLocked = false;  // the player lacks some of the needs; set by the quest
    int openLeaders = 0;    // gates that it follows and that are open
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
    int mover = -1;  // index into World::movers of the one that it moves, or -1
    std::vector<BlueprintId> parts;
    std::vector<Box> boxes;  // of its blocks, as wide as their tiles
    Box bounds;              // around all boxes
    std::vector<GateFace> faces;
    int progress = 0;          // steps, 0 is closed
    int previousProgress = 0;  // before the last step
    bool wantsOpen = false;
    bool isNear = false;      // a body is within `approach`
    int awaySteps = 0;        // steps since the last body left
    int waitSteps = 0;        // steps since it last opened by itself
    bool isLed = false;       // a gate that it follows is open
    int firstEncounter = -1;  // see findEncounters
};

// What a player asks of the gates within reach of the eye. A gate with somebody inside closes when
// they have left.
struct GateAsk {
    enum class Wish : std::uint8_t { nothing, change, open, close };
    Wish wish = Wish::nothing;
    int map = 0;
    Coordinate x;
    Coordinate y;
    Coordinate z;
};

// Finds the gates of a world whose cells are complete, and sets their initial states. Returns
// faults; with any the world is unusable.
std::vector<PlacingFault> makeGates(World& world);

// Makes textures for the frames of the sheets that gates show. Call it after the textures are read
// and before markSeeThrough.
void makeGateFrames(World& world);

// What the use key would do to the gates within reach; ignores ask.wish. `open` if it would open
// any. Locked gates do not count.
enum class GateOffer : std::uint8_t { none, open, close };
GateOffer gateOffer(const World& world, const GateAsk& ask);

// The gate that the player tries to open without what it needs, by a key or by coming near; -1 for
// none.
int refusedGate(const World& world, const GateAsk& ask, int map, const Box& body);

// True if the boxes are at most `distance` apart; those that touch are 0 apart.
bool areWithin(const Box& a, const Box& b, Coordinate distance);

// One step of all gates. Does not move the bodies. Call findEncounters before.
void stepGates(World& world, std::span<Body> bodies, const GateAsk& ask);

// Restores the initial states.
void resetGates(World& world);

// What a moment keeps of a gate, see world_moment.h.
struct GateMoment {
    int progress = 0;
    int previousProgress = 0;
    bool wantsOpen = false;
    bool isNear = false;
    int awaySteps = 0;
    int waitSteps = 0;
    bool isLed = false;
};
std::vector<GateMoment> momentOfGates(const World& world);
// Not what the gates move: that is restored with the movers.
void restoreGates(World& world, std::span<const GateMoment> moments);

GateState stateOf(const Gate& gate, const GateKind& kind);

}  // namespace slicecast

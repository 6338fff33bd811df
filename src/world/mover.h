// Movers: blocks that move along an axis by a motion, as a whole or some edge of them.
//
//      |     |  level 2
//      |:::::|                  Each shaft has a blueprint of its own on every level that it can
//      |#####|  level 1         reach. It is cut off at the level's borders, and empty while the
//      |#####|                  shaft is elsewhere. A shaft along x or y is the same, with tiles in
//      |     |  level 0         the place of levels.
//      +-----+
//
// Cells of one moving blueprint that touch, side by side or stacked, are one mover: all of it moves
// by the same offset. A shaft is a run of its cells along the axis, shared by all places that have
// the same run.
//
// A mover waits, and its clock with it, while it would enter a body that was free. It lifts bodies
// that stand on its top or that it meets from below; bodies that rest on it go down with it too.
// One that goes sideways pushes bodies before it, and takes along those that rest on it, as far as
// they have room. It takes nobody into a portal or out of one.
//
// Slopes go along with their block: each part has those of the whole block, cut off at the part's
// edges. A body stands at the height of the slope's highest point below it.
#pragma once

#include "base/coordinate.h"
#include "world/blueprint.h"
#include "world/box.h"
#include "world/placing_fault.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace slicecast {

class TaskList;

struct Body;
struct World;

// All cells of movers, with the cells that they reach.
inline constexpr std::size_t kMaxMovingCells = 1'000'000;
inline constexpr std::size_t kMaxMoverParts = 32'768;  // blueprints of movers, one for each place
inline constexpr std::size_t kMaxMovers = 8'192;       // a step moves each

// Where a run of a shaft's cells begins, in the shaft's first place.
struct RunStart {
    std::uint32_t tile = 0;  // see Map::tileIndex
    int level = 0;
};

struct Shaft {
    Coordinate low;  // along the axis, without the motion's offset
    Coordinate high;
    Slopes slopes;  // of a block with slopes, which is `low.tile()` along the axis, in its cell
    int first = 0;  // the levels, or tiles, that it can reach
    int last = 0;
    BlueprintId firstPart = kEmptyCell;  // in `first`; those of the next places follow it
    std::vector<RunStart> runs;
};

struct Mover {
    int map = 0;  // indices into World::maps and World::motions
    int motion = 0;
    int gate = -1;  // index into World::gates of the gate that moves it; -1 if its clock does
    int west = 0;   // the tiles that it can reach, inclusive
    int east = 0;
    int north = 0;
    int south = 0;
    std::vector<Shaft> shafts;
    int clock = 0;  // steps that it has moved, modulo the period
    Coordinate offset;
    Coordinate previousOffset;  // before the last step
    int firstEncounter = -1;    // see findEncounters
};

// Finds the movers of a world whose cells are complete, and puts them in their initial places.
// Returns faults; with any the world is unusable.
std::vector<PlacingFault> makeMovers(World& world);

// The same as tasks, which it adds to a list.
class MoverMaker {
public:
    // It, the world and the list must outlive the tasks.
    MoverMaker(World& world, TaskList& tasks);
    MoverMaker(const MoverMaker&) = delete;
    ~MoverMaker();
    std::vector<PlacingFault> takeFaults();

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

// One step of all movers that no gate moves. Moves the bodies along. Call findEncounters before.
void stepMovers(World& world, std::span<Body> bodies);

// Moves a mover to an offset, and the bodies along. False if it has to wait.
bool moveTo(World& world, Mover& mover, Coordinate offset, std::span<Body> bodies);

// Restores the initial places.
void resetMovers(World& world);

// What a moment keeps of a mover, see world_moment.h.
struct MoverMoment {
    int clock = 0;
    Coordinate offset;
    Coordinate previousOffset;
};
std::vector<MoverMoment> momentOfMovers(const World& world);
void restoreMovers(World& world, std::span<const MoverMoment> moments);

// Shows the movers at a part of the way between the last two steps: see showBetween.
void showMovers(World& world, double part);

// A box around where it is at present. Of several shafts the first tells its place along the axis.
Box boundsOf(const World& world, const Mover& mover);

}  // namespace slicecast

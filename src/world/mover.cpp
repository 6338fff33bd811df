#include "world/mover.h"

#include "world/body.h"
#include "world/moving_cells.h"
#include "world/solids.h"
#include "world/world.h"

#include <algorithm>

namespace slicecast {
namespace {

struct Extent {
    Coordinate low;
    Coordinate high;

    bool isEmpty() const { return high <= low; }
};

Extent extentOf(const Shaft& shaft, MovingEdges edges, Coordinate offset) {
    return {edges == MovingEdges::high ? shaft.low : shaft.low + offset,
            edges == MovingEdges::low ? shaft.high : shaft.high + offset};
}

// The height at which bodies stand on the shaft, even while it is empty. A top that does not move
// carries nothing.
Coordinate groundOf(const Extent& extent) {
    return std::max(extent.low, extent.high);
}

// The least height above all of the top between two places along the slope's axis, and the greatest
// below all of the underside.
Coordinate topBetween(const Slant& slant, Coordinate low, Coordinate high) {
    const std::int64_t most = std::max(slant.heightAt(low.raw), slant.heightAt(high.raw));
    return {static_cast<std::int32_t>((most + 0xffff) >> 16)};
}
Coordinate bottomBetween(const Slant& slant, Coordinate low, Coordinate high) {
    const std::int64_t least = std::min(slant.heightAt(low.raw), slant.heightAt(high.raw));
    return {static_cast<std::int32_t>(least >> 16)};
}

// Cuts the extent of a shaft that goes along its slopes' axis to where it has a point between two
// heights above its level.
void cutToHeights(Extent& extent, const Shaft& shaft, Coordinate offset, Coordinate bottom,
                  Coordinate top) {
    const auto cut = [&](const Slant& slant, Coordinate height, bool keepsHigher) {
        if (slant.isLevel()) return;
        // The place at that height, in 1/65536 units, rounded away from what is kept
        const std::int64_t number = (std::int64_t{height.raw} - slant.from.raw) * 65536;
        const std::int64_t rise = slant.rise();
        const bool keepsHigh = (rise > 0) == keepsHigher;
        std::int64_t place = number / rise;
        if (number % rise != 0 && (number < 0) == (rise < 0) && !keepsHigh) ++place;
        if (number % rise != 0 && (number < 0) != (rise < 0) && keepsHigh) --place;
        const std::int64_t at =
            place + slant.shift.raw + tileEdge(shaft.low.tile()).raw + offset.raw;
        const Coordinate end = {static_cast<std::int32_t>(
            std::clamp<std::int64_t>(at, extent.low.raw, extent.high.raw))};
        (keepsHigh ? extent.low : extent.high) = end;
    };
    cut(shaft.slopes.top, bottom, true);
    cut(shaft.slopes.bottom, top, false);
}

// The part of a plan along the slope's axis that a box in tile (x, y) lies over or under.
Extent sharedAlong(const Slopes& slopes, const Plan& plan, int x, int y, const Box& box) {
    return slopes.alongX ? Extent{std::max(plan.west, box.west - tileEdge(x)),
                                  std::min(plan.east, box.east - tileEdge(x))}
                         : Extent{std::max(plan.north, box.north - tileEdge(y)),
                                  std::min(plan.south, box.south - tileEdge(y))};
}

const Motion& motionOf(const World& world, const Mover& mover) {
    return world.motions[static_cast<std::size_t>(mover.motion)];
}

// The parts of a shaft, from `first` on.
std::span<CellBlueprint> partsOf(World& world, const Shaft& shaft) {
    return std::span(world.blueprints)
        .subspan(shaft.firstPart, static_cast<std::size_t>(shaft.last - shaft.first + 1));
}

// The slopes of a shaft in one of the places that it reaches. Where they are wholly outside of the
// cell, the part is level.
Slopes slopesAt(const Shaft& shaft, Axis axis, Coordinate offset, int place) {
    const Coordinate way = offset + tileEdge(shaft.low.tile() - place);
    Slopes slopes =
        moved(shaft.slopes, axis == Axis::x ? way : Coordinate{},
              axis == Axis::y ? way : Coordinate{}, axis == Axis::z ? way : Coordinate{});
    if (slopes.top.least() >= tileEdge(1)) slopes.top = {tileEdge(1), tileEdge(1)};
    if (slopes.bottom.most() <= Coordinate{0}) slopes.bottom = {};
    return slopes;
}

// The places of a shaft, as in Shaft::first and last.
struct Places {
    int first;
    int last;
};

// Updates some of a shaft's parts; their textures and slopes move with it.
void placeShaft(World& world, const Mover& mover, const Shaft& shaft, Coordinate offset,
                const Places& places) {
    const Motion& motion = motionOf(world, mover);
    const Extent extent = extentOf(shaft, motion.edges, offset);
    Map& map = world.maps[static_cast<std::size_t>(mover.map)];
    for (int place = places.first; place <= places.last; ++place) {
        CellBlueprint& part =
            world.blueprints[static_cast<std::size_t>(shaft.firstPart + place - shaft.first)];
        const auto within = [&](Coordinate at) {
            return std::clamp(at - tileEdge(place), Coordinate{0}, tileEdge(1));
        };
        const bool wasEmpty = highEdge(part, motion.axis) <= lowEdge(part, motion.axis);
        lowEdge(part, motion.axis) = within(extent.low);
        highEdge(part, motion.axis) = within(extent.high);
        (motion.axis == Axis::x   ? part.textureEast
         : motion.axis == Axis::y ? part.textureSouth
                                  : part.textureRise) = {offset.raw & 0xffff};
        if (shaft.slopes.any()) part.slopes = slopesAt(shaft, motion.axis, offset, place);
        const bool isEmpty = highEdge(part, motion.axis) <= lowEdge(part, motion.axis);
        if (isEmpty == wasEmpty) continue;
        const int step = motion.axis == Axis::x ? 1 : motion.axis == Axis::y ? map.width : 0;
        const auto tiles = static_cast<std::size_t>((place - shaft.first) * step);
        const int levels = motion.isSideways() ? 0 : place - shaft.first;
        for (const RunStart& run : shaft.runs)
            map.occupied[run.tile + tiles] ^= 1u << (run.level + levels);
    }
}

// Puts a mover where it is with that offset. Both this one and the one that it has are from `first`
// to `last`, or the other way round: the parts that it touches with none of these are empty, and
// stay so.
void place(World& world, const Mover& mover, Coordinate offset, Coordinate first, Coordinate last) {
    const MovingEdges edges = motionOf(world, mover).edges;
    for (const Shaft& shaft : mover.shafts) {
        const Extent a = extentOf(shaft, edges, first);
        const Extent b = extentOf(shaft, edges, last);
        const Coordinate low = std::min({a.low, a.high, b.low, b.high});
        const Coordinate high = std::max({a.low, a.high, b.low, b.high});
        placeShaft(world, mover, shaft, offset,
                   {std::max(shaft.first, low.tile()),
                    std::min(shaft.last, Coordinate{high.raw - 1}.tile())});
    }
}

// The shaft of a cell's blueprint; null for a cell that is not of the mover.
const Shaft* shaftOf(const World& world, const Mover& mover, BlueprintId id) {
    if (world.blueprints[id].mover != static_cast<int>(&mover - world.movers.data()))
        return nullptr;
    const auto next = std::upper_bound(
        mover.shafts.begin(), mover.shafts.end(), id,
        [](BlueprintId part, const Shaft& shaft) { return part < shaft.firstPart; });
    return &*(next - 1);
}

// Calls action(body) for all bodies that the mover may touch.
template <typename Action>
void eachBody(World& world, const Mover& mover, std::span<Body> bodies, Action action) {
    eachEncounter(world.encounters, mover.firstEncounter,
                  [&](int body) { action(bodies[static_cast<std::size_t>(body)]); });
}

bool isAnyInTheWay(World& world, const Mover& mover, std::span<Body> bodies) {
    bool isAny = false;
    eachBody(world, mover, bodies, [&](const Body& body) {
        isAny = isAny || (body.isMet && !isFree(world, travellerOf(body, body.way)));
    });
    return isAny;
}

// One mover with its next offset.
struct Move {
    const World& world;
    const Mover& mover;
    Coordinate offset;

    // Sets the body's push, and isMet if the mover must not get into it.
    void meet(Body& body) const;
    void meetUpright(Body& body) const;
    void meetShaft(Body& body, const Shaft& shaft, int x, int y) const;
    void meetSideways(Body& body) const;
    void meetLine(Body& body, const Shaft& shaft, int across, int level) const;
};

void Move::meet(Body& body) const {
    body.push = {};
    body.way = {};
    // Water pushes and carries only floating bodies.
    const bool isWater = world.blueprints[mover.shafts.front().firstPart].isWater;
    body.isMet = (body.floats || !isWater) && isFree(world, travellerOf(body));
    if (!body.isMet || body.map != mover.map) return;
    if (motionOf(world, mover).isSideways()) {
        meetSideways(body);
    } else {
        meetUpright(body);
    }
}

// ---- Up and down

// The shafts that the body may be on: those of the cells below its feet and around it.
void Move::meetUpright(Body& body) const {
    const Map& map = world.maps[static_cast<std::size_t>(mover.map)];
    const Box& box = body.box;
    if (motionOf(world, mover).edges == MovingEdges::low) return;
    const int west = std::max(mover.west, box.west.tile());
    const int east = std::min(mover.east, Coordinate{box.east.raw - 1}.tile());
    const int north = std::max(mover.north, box.north.tile());
    const int south = std::min(mover.south, Coordinate{box.south.raw - 1}.tile());
    const int lowest = std::max(0, Coordinate{box.bottom.raw - 1}.tile());
    const int highest = std::min(map.levels - 1, box.top.tile());
    for (int y = north; y <= south; ++y) {
        for (int x = west; x <= east; ++x) {
            const Shaft* last = nullptr;
            for (int level = lowest; level <= highest; ++level) {
                const Shaft* const shaft =
                    shaftOf(world, mover, map.cells[map.cellIndex(x, y, level)]);
                if (shaft != nullptr && shaft != last) meetShaft(body, *shaft, x, y);
                last = shaft;
            }
        }
    }
}

void Move::meetShaft(Body& body, const Shaft& shaft, int x, int y) const {
    const Box& box = body.box;
    const MovingEdges edges = motionOf(world, mover).edges;
    const Plan& plan = world.blueprints[shaft.firstPart].plan;
    if (!isOver(plan, x, y, box)) return;
    Extent before = extentOf(shaft, edges, mover.offset);
    Extent after = extentOf(shaft, edges, offset);
    if (shaft.slopes.any()) {
        const Extent shared = sharedAlong(shaft.slopes, plan, x, y, box);
        const Coordinate top =
            tileEdge(shaft.low.tile()) + topBetween(shaft.slopes.top, shared.low, shared.high);
        before.high = top + mover.offset;
        after.high = top + offset;
    }
    const Coordinate rise = groundOf(after) - groundOf(before);
    const Coordinate above = box.bottom - groundOf(before);
    if (rise > Coordinate{0} && above >= Coordinate{0} && above < rise)
        body.push = std::max(body.push, rise - above);
    const bool stands = body.rides && above == Coordinate{0} && !before.isEmpty();
    if (rise < Coordinate{0} && stands && body.push <= Coordinate{0})
        body.push = std::min(body.push, rise);
}

// How far a met body gets up, after the mover has moved.
Coordinate liftOf(const World& world, const Body& body) {
    return body.push < Coordinate{0} ? sweepZ(world, travellerOf(body), body.push) : body.push;
}

// ---- Sideways

// The lines of the shafts, that is their runs, that the body is beside or on.
void Move::meetSideways(Body& body) const {
    const Map& map = world.maps[static_cast<std::size_t>(mover.map)];
    const bool alongX = motionOf(world, mover).axis == Axis::x;
    const Box& box = body.box;
    const Coordinate from = alongX ? box.north : box.west;
    const Coordinate to = alongX ? box.south : box.east;
    const int first = std::max(alongX ? mover.north : mover.west, from.tile());
    const int last = std::min(alongX ? mover.south : mover.east, Coordinate{to.raw - 1}.tile());
    const int lowest = std::max(0, Coordinate{box.bottom.raw - 1}.tile());
    const int highest = std::min(map.levels - 1, box.top.tile());
    const int begin = std::max(alongX ? mover.west : mover.north,
                               Coordinate{(alongX ? box.west : box.north).raw - 1}.tile());
    const int end =
        std::min(alongX ? mover.east : mover.south, (alongX ? box.east : box.south).tile());
    for (int across = first; across <= last; ++across) {
        for (int level = lowest; level <= highest; ++level) {
            const Shaft* before = nullptr;
            for (int place = begin; place <= end; ++place) {
                const std::size_t cell = alongX ? map.cellIndex(place, across, level)
                                                : map.cellIndex(across, place, level);
                const Shaft* const shaft = shaftOf(world, mover, map.cells[cell]);
                if (shaft != nullptr && shaft != before) meetLine(body, *shaft, across, level);
                before = shaft;
            }
        }
    }
}

// A line of cells in that row, or column, of tiles. A push outdoes the way of what rests on it.
void Move::meetLine(Body& body, const Shaft& shaft, int across, int level) const {
    const Motion& motion = motionOf(world, mover);
    const bool alongX = motion.axis == Axis::x;
    const CellBlueprint& part = world.blueprints[shaft.firstPart];
    const Box& box = body.box;
    const Extent side =
        alongX ? Extent{part.plan.north, part.plan.south} : Extent{part.plan.west, part.plan.east};
    if (tileEdge(across) + side.low >= (alongX ? box.south : box.east) ||
        tileEdge(across) + side.high <= (alongX ? box.north : box.west))
        return;
    const Extent self = alongX ? Extent{box.west, box.east} : Extent{box.north, box.south};
    Extent before = extentOf(shaft, motion.edges, mover.offset);
    Extent after = extentOf(shaft, motion.edges, offset);
    const bool isOnLine = before.low < self.high && before.high > self.low;
    Coordinate top = tileEdge(level) + part.top;
    Coordinate bottom = tileEdge(level) + part.bottom;
    const Slopes& slopes = shaft.slopes;
    const bool risesAlong = slopes.any() && slopes.alongX == alongX;
    if (risesAlong && isOnLine) {
        const Coordinate start = tileEdge(shaft.low.tile()) + mover.offset;
        top = tileEdge(level) + topBetween(slopes.top, std::max(self.low, before.low) - start,
                                           std::min(self.high, before.high) - start);
    } else if (slopes.any() && !risesAlong) {
        const Extent shared = sharedAlong(slopes, part.plan, across, across, box);
        top = tileEdge(level) + topBetween(slopes.top, shared.low, shared.high);
        bottom = tileEdge(level) + bottomBetween(slopes.bottom, shared.low, shared.high);
    }
    if (box.bottom == top) {
        const bool rests = body.rides && isOnLine;
        if (rests && motion.edges == MovingEdges::both && body.push == Coordinate{0})
            body.push = offset - mover.offset;
        if (rests || !risesAlong) return;
    }
    if (risesAlong) {
        const Coordinate way = offset - mover.offset;
        cutToHeights(before, shaft, mover.offset, box.bottom - tileEdge(level),
                     box.top - tileEdge(level));
        after = {before.low + way, before.high + way};
        top = tileEdge(level) + part.top;
    }
    if (box.bottom >= top || box.top <= bottom || after.isEmpty()) return;
    if (self.low >= before.high && self.low < after.high)
        body.push = std::max(body.push, after.high - self.low);
    if (self.high <= before.low && self.high > after.low)
        body.push = std::min(body.push, after.low - self.high);
}

Offset alongAxis(Axis axis, Coordinate way) {
    return {.x = axis == Axis::x ? way : Coordinate{},
            .y = axis == Axis::y ? way : Coordinate{},
            .z = axis == Axis::z ? way : Coordinate{}};
}

// The mover is not there while the bodies go: it goes at the same time.
void moveSideways(World& world, const Mover& mover, std::span<Body> bodies) {
    const Axis axis = motionOf(world, mover).axis;
    const auto setPassable = [&](bool passable) {
        for (const Shaft& shaft : mover.shafts) {
            for (CellBlueprint& part : partsOf(world, shaft)) part.passable = passable;
        }
    };
    setPassable(true);
    eachBody(world, mover, bodies, [&](Body& body) {
        if (body.isMet && body.push != Coordinate{0} && !body.straddles)
            body.way = alongAxis(axis, sweepSideways(world, travellerOf(body), axis, body.push));
    });
    setPassable(false);
}

// ---- All of them

void stepMover(World& world, Mover& mover, std::span<Body> bodies) {
    const Motion& motion = motionOf(world, mover);
    const int clock = nextStep(motion, mover.clock);
    if (moveTo(world, mover, offsetAt(motion, clock), bodies)) mover.clock = clock;
}

}  // namespace

bool moveTo(World& world, Mover& mover, Coordinate offset, std::span<Body> bodies) {
    if (offset == mover.offset) return true;
    const bool isSideways = motionOf(world, mover).isSideways();
    // Try: move it with all bodies on it
    eachBody(world, mover, bodies, [&](Body& body) { Move{world, mover, offset}.meet(body); });
    if (isSideways) moveSideways(world, mover, bodies);
    place(world, mover, offset, offset, mover.offset);
    if (!isSideways) {
        eachBody(world, mover, bodies, [&](Body& body) {
            if (body.isMet) body.way = alongAxis(Axis::z, liftOf(world, body));
        });
    }
    if (isAnyInTheWay(world, mover, bodies)) {
        place(world, mover, mover.offset, offset, mover.offset);
        return false;
    }
    eachBody(world, mover, bodies, [&](Body& body) {
        if (!body.isMet || body.push == Coordinate{0}) return;
        const Traveller there = travellerOf(body, body.way);
        body.shift = {.x = body.shift.x + body.way.x,
                      .y = body.shift.y + body.way.y,
                      .z = body.shift.z + body.way.z};
        body.box = there.box;
        body.eye = there.eye;
    });
    mover.offset = offset;
    return true;
}

void stepMovers(World& world, std::span<Body> bodies) {
    for (Mover& mover : world.movers) {
        mover.previousOffset = mover.offset;
        if (mover.gate < 0) stepMover(world, mover, bodies);
    }
}

void resetMovers(World& world) {
    for (Mover& mover : world.movers) {
        const Motion& motion = motionOf(world, mover);
        mover.clock = 0;
        mover.offset = mover.previousOffset =
            motion.hasPeriod() ? offsetAt(motion, 0) : motion.from;
        for (const Shaft& shaft : mover.shafts)
            placeShaft(world, mover, shaft, mover.offset, {shaft.first, shaft.last});
    }
}

std::vector<MoverMoment> momentOfMovers(const World& world) {
    std::vector<MoverMoment> moments;
    moments.reserve(world.movers.size());
    for (const Mover& mover : world.movers)
        moments.push_back({mover.clock, mover.offset, mover.previousOffset});
    return moments;
}

void restoreMovers(World& world, std::span<const MoverMoment> moments) {
    for (std::size_t i = 0; i < moments.size(); ++i) {
        Mover& mover = world.movers[i];
        const bool isElsewhere = mover.offset != moments[i].offset;
        mover.clock = moments[i].clock;
        mover.offset = moments[i].offset;
        mover.previousOffset = moments[i].previousOffset;
        if (!isElsewhere) continue;
        for (const Shaft& shaft : mover.shafts)
            placeShaft(world, mover, shaft, mover.offset, {shaft.first, shaft.last});
    }
}

void showMovers(World& world, double part) {
    for (const Mover& mover : world.movers) {
        if (mover.offset == mover.previousOffset) continue;
        place(world, mover, between(mover.previousOffset, mover.offset, part), mover.previousOffset,
              mover.offset);
    }
}

Box boundsOf(const World& world, const Mover& mover) {
    const Shaft& shaft = mover.shafts[0];
    const Motion& motion = motionOf(world, mover);
    const CellBlueprint& part = world.blueprints[shaft.firstPart];
    const int level = shaft.runs[0].level;
    Box box = {tileEdge(mover.west),          tileEdge(mover.east + 1),
               tileEdge(mover.north),         tileEdge(mover.south + 1),
               tileEdge(level) + part.bottom, tileEdge(level) + part.top};
    const Extent extent = extentOf(shaft, motion.edges, mover.offset);
    (motion.axis == Axis::x   ? box.west
     : motion.axis == Axis::y ? box.north
                              : box.bottom) = extent.low;
    (motion.axis == Axis::x   ? box.east
     : motion.axis == Axis::y ? box.south
                              : box.top) = extent.high;
    return box;
}

}  // namespace slicecast

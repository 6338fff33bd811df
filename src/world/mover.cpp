#include "world/mover.h"

#include "world/body.h"
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
    return {edges == MovingEdges::top ? shaft.low : shaft.low + offset,
            edges == MovingEdges::bottom ? shaft.high : shaft.high + offset};
}

// The height at which bodies stand on the shaft, even while it is empty. A top that does not move
// carries nothing.
Coordinate groundOf(const Extent& extent) {
    return std::max(extent.low, extent.high);
}

constexpr Coordinate withinLevel(Coordinate height, int level) {
    return std::clamp(height - tileEdge(level), Coordinate{0}, tileEdge(1));
}

// Updates a shaft's parts; the textures of the sides move with it.
void placeShaft(World& world, Map& map, const Shaft& shaft, const Extent& extent,
                Coordinate offset) {
    for (int level = shaft.firstLevel; level <= shaft.lastLevel; ++level) {
        CellBlueprint& part =
            world
                .blueprints[static_cast<std::size_t>(shaft.firstPart + (level - shaft.firstLevel))];
        const bool wasEmpty = part.top <= part.bottom;
        part.bottom = withinLevel(extent.low, level);
        part.top = withinLevel(extent.high, level);
        part.textureRise = {offset.raw & 0xffff};
        const bool isEmpty = part.top <= part.bottom;
        if (isEmpty == wasEmpty) continue;
        for (const std::size_t tile : shaft.tiles) map.occupied[tile] ^= 1u << level;
    }
}

void place(World& world, const Mover& mover, Coordinate offset) {
    const MovingEdges edges = world.motions[static_cast<std::size_t>(mover.motion)].edges;
    Map& map = world.maps[static_cast<std::size_t>(mover.map)];
    for (const Shaft& shaft : mover.shafts)
        placeShaft(world, map, shaft, extentOf(shaft, edges, offset), offset);
}

// One mover with its next offset.
struct Move {
    const World& world;
    const Mover& mover;
    Coordinate offset;

    // Sets the body's push, and isMet if the mover must not get into it.
    void meet(Body& body) const;
};

void Move::meet(Body& body) const {
    body.push = {};
    // Water pushes and carries only floating bodies.
    const bool isWater = world.blueprints[mover.shafts.front().firstPart].isWater;
    body.isMet = (body.floats || !isWater) && isFree(world, travellerOf(body));
    if (!body.isMet) return;
    const Map& map = world.maps[static_cast<std::size_t>(mover.map)];
    const Box& box = body.box;
    if (body.map == mover.map) {
        const MovingEdges edges = world.motions[static_cast<std::size_t>(mover.motion)].edges;
        const int west = std::max(mover.west, box.west.tile());
        const int east = std::min(mover.east, Coordinate{box.east.raw - 1}.tile());
        const int north = std::max(mover.north, box.north.tile());
        const int south = std::min(mover.south, Coordinate{box.south.raw - 1}.tile());
        for (int y = north; y <= south; ++y) {
            for (int x = west; x <= east; ++x) {
                for (const Shaft& shaft : mover.shafts) {
                    if (map.cells[map.cellIndex(x, y, shaft.firstLevel)] != shaft.firstPart)
                        continue;
                    if (edges == MovingEdges::bottom ||
                        !isOver(world.blueprints[shaft.firstPart].plan, x, y, box))
                        continue;
                    const Extent before = extentOf(shaft, edges, mover.offset);
                    const Extent after = extentOf(shaft, edges, offset);
                    const Coordinate rise = groundOf(after) - groundOf(before);
                    const Coordinate above = box.bottom - groundOf(before);
                    if (rise > Coordinate{0} && above >= Coordinate{0} && above < rise)
                        body.push = std::max(body.push, rise - above);
                    const bool stands = body.rides && above == Coordinate{0} && !before.isEmpty();
                    if (rise < Coordinate{0} && stands && body.push <= Coordinate{0})
                        body.push = std::min(body.push, rise);
                }
            }
        }
    }
}

// How far a met body gets up, after the mover has moved.
Coordinate liftOf(const World& world, const Body& body) {
    return body.push < Coordinate{0} ? sweepZ(world, travellerOf(body), body.push) : body.push;
}

void stepMover(World& world, Mover& mover, std::span<Body> bodies) {
    mover.previousOffset = mover.offset;
    const Motion& motion = world.motions[static_cast<std::size_t>(mover.motion)];
    const int clock = (mover.clock + 1) % motion.periodSteps;
    const Coordinate offset = offsetAt(motion, clock);
    if (offset == mover.offset) {
        mover.clock = clock;
        return;
    }
    // Try: move it with all bodies on it
    const auto eachBody = [&](auto action) {
        eachEncounter(world.encounters, mover.firstEncounter,
                      [&](int body) { action(bodies[static_cast<std::size_t>(body)]); });
    };
    eachBody([&](Body& body) { Move{world, mover, offset}.meet(body); });
    place(world, mover, offset);
    bool isInTheWay = false;
    eachBody([&](const Body& body) {
        isInTheWay =
            isInTheWay || (body.isMet && !isFree(world, travellerOf(body, liftOf(world, body))));
    });
    if (isInTheWay) {
        place(world, mover, mover.offset);
        return;
    }
    eachBody([&](Body& body) {
        if (!body.isMet || body.push == Coordinate{0}) return;
        const Traveller lifted = travellerOf(body, liftOf(world, body));
        body.lift = body.lift + (lifted.box.bottom - body.box.bottom);
        body.box = lifted.box;
        body.eye = lifted.eye;
    });
    mover.clock = clock;
    mover.offset = offset;
}

}  // namespace

void stepMovers(World& world, std::span<Body> bodies) {
    for (Mover& mover : world.movers) stepMover(world, mover, bodies);
}

void resetMovers(World& world) {
    for (Mover& mover : world.movers) {
        mover.clock = 0;
        mover.offset = mover.previousOffset =
            offsetAt(world.motions[static_cast<std::size_t>(mover.motion)], 0);
        place(world, mover, mover.offset);
    }
}

void showMovers(World& world, double fraction) {
    const double part = fraction < 1.0 ? std::max(fraction, 0.0) : 1.0;
    for (const Mover& mover : world.movers) {
        if (mover.offset == mover.previousOffset) continue;
        const Coordinate way = mover.offset - mover.previousOffset;
        place(world, mover, mover.previousOffset + toCoordinate(way.value() * part));
    }
}

}  // namespace slicecast

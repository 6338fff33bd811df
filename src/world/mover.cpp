#include "world/mover.h"

#include "world/body.h"
#include "world/world.h"

#include <algorithm>
#include <utility>
#include <vector>

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

// Finds the bodies that each mover may touch, once a step: bodies keep their tiles while movers
// lift them. So a step takes a time that grows with bodies plus movers, not with their product.
class Encounters {
public:
    Encounters(const World& world, std::span<Body> bodies) : bodies_(bodies) {
        if (bodies.empty() || world.movers.empty()) return;
        std::vector<int> moverOf(world.blueprints.size(), -1);
        for (std::size_t mover = 0; mover < world.movers.size(); ++mover) {
            for (const Shaft& shaft : world.movers[mover].shafts)
                moverOf[shaft.firstPart] = static_cast<int>(mover);
        }
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const int body = static_cast<int>(i);
            if (bodies[i].straddles) {
                straddling_.push_back(body);
            } else {
                addColumns(world, moverOf, body);
            }
        }
        std::sort(pairs_.begin(), pairs_.end());
        pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    }

    // Calls action(body) for each body that the mover may touch. Call it with rising movers: it
    // goes on where the one before has ended.
    template <typename Action>
    void each(int mover, Action action) {
        while (next_ < pairs_.size() && pairs_[next_].first < mover) ++next_;
        for (std::size_t i = next_; i < pairs_.size() && pairs_[i].first == mover; ++i)
            action(bodies_[static_cast<std::size_t>(pairs_[i].second)]);
        for (const int body : straddling_) action(bodies_[static_cast<std::size_t>(body)]);
    }

private:
    // All levels of the tiles that a body stands on.
    void addColumns(const World& world, const std::vector<int>& moverOf, int index) {
        const Body& body = bodies_[static_cast<std::size_t>(index)];
        const Map& map = world.maps[static_cast<std::size_t>(body.map)];
        const Box& box = body.box;
        const int west = std::max(0, box.west.tile());
        const int east = std::min(map.width - 1, Coordinate{box.east.raw - 1}.tile());
        const int north = std::max(0, box.north.tile());
        const int south = std::min(map.depth - 1, Coordinate{box.south.raw - 1}.tile());
        for (int y = north; y <= south; ++y) {
            for (int x = west; x <= east; ++x) {
                for (int level = 0; level < map.levels; ++level) {
                    const int mover = moverOf[map.cells[map.cellIndex(x, y, level)]];
                    if (mover >= 0) pairs_.emplace_back(mover, index);
                }
            }
        }
    }

    std::span<Body> bodies_;
    std::vector<std::pair<int, int>> pairs_;  // mover, body
    std::vector<int> straddling_;             // bodies in portals: any mover may touch them
    std::size_t next_ = 0;
};

// One mover with its next offset.
struct Move {
    const World& world;
    const Mover& mover;
    Coordinate offset;

    // Sets the body's push, and isMet if the mover may touch it.
    void meet(Body& body) const;
};

void Move::meet(Body& body) const {
    body.isMet = body.straddles;
    body.push = {};
    // Water pushes and carries only floating bodies.
    if (world.blueprints[mover.shafts.front().firstPart].isWater && !body.floats) {
        body.isMet = false;
        return;
    }
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
                    body.isMet = true;
                    if (edges == MovingEdges::bottom) continue;
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
    body.isMet = body.isMet && isFree(world, travellerOf(body));
}

// How far a met body gets up, after the mover has moved.
Coordinate liftOf(const World& world, const Body& body) {
    return body.push < Coordinate{0} ? sweepZ(world, travellerOf(body), body.push) : body.push;
}

void stepMover(World& world, int index, Encounters& encounters) {
    Mover& mover = world.movers[static_cast<std::size_t>(index)];
    mover.previousOffset = mover.offset;
    const Motion& motion = world.motions[static_cast<std::size_t>(mover.motion)];
    const int clock = (mover.clock + 1) % motion.periodSteps;
    const Coordinate offset = offsetAt(motion, clock);
    if (offset == mover.offset) {
        mover.clock = clock;
        return;
    }
    // Try: move it with all bodies on it
    encounters.each(index, [&](Body& body) { Move{world, mover, offset}.meet(body); });
    place(world, mover, offset);
    bool isInTheWay = false;
    encounters.each(index, [&](const Body& body) {
        isInTheWay =
            isInTheWay || (body.isMet && !isFree(world, travellerOf(body, liftOf(world, body))));
    });
    if (isInTheWay) {
        place(world, mover, mover.offset);
        return;
    }
    encounters.each(index, [&](Body& body) {
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
    Encounters encounters(world, bodies);
    for (std::size_t i = 0; i < world.movers.size(); ++i)
        stepMover(world, static_cast<int>(i), encounters);
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

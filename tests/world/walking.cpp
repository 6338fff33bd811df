#include "walking.h"

#include "world/water.h"

#include <algorithm>
#include <utility>

namespace slicecast {

World emptyWorld(int width, int depth, int levels) {
    World world;
    world.maps.push_back(makeMap("test", width, depth, levels, kNoTexture));
    return world;
}

void putBlock(World& world, int x, int y, Coordinate bottom, Coordinate top) {
    const int level = bottom.tile();
    CellBlueprint block;
    block.bottom = bottom - tileEdge(level);
    block.top = top - tileEdge(level);
    BlueprintId id = 0;
    for (std::size_t i = 1; i < world.blueprints.size(); ++i) {
        if (world.blueprints[i].bottom == block.bottom && world.blueprints[i].top == block.top &&
            world.blueprints[i].isBox())
            id = static_cast<BlueprintId>(i);
    }
    if (id == kEmptyCell) {
        id = static_cast<BlueprintId>(world.blueprints.size());
        world.blueprints.push_back(block);
    }
    world.maps[0].setCell(x, y, level, id);
}

void putCeiling(World& world, Coordinate height) {
    Map& map = world.maps[0];
    map.ceiling.height = height;
    map.ceiling.tiles.assign(map.occupied.size(), 0);
}

World lowPassage(Coordinate height) {
    World world = emptyWorld(8, 1, 2);
    for (int x = 2; x < 6; ++x) putBlock(world, x, 0, height, 1.0_u);
    return world;
}

// What a block fills of its tile; often all of it along an axis, or a half.
Plan randomPlan(Random& random) {
    Plan plan;
    if (random.oneIn(3)) {
        plan.half = static_cast<Half>(random.between(1, 4));
        return plan;
    }
    const auto edges = [&random](Coordinate& low, Coordinate& high) {
        if (random.oneIn(3)) return;
        do {
            low = {random.oneIn(3) ? 0 : random.below(65536)};
            high = {random.oneIn(3) ? 65536 : random.below(65536)};
        } while (high - low < kThinnest);
    };
    edges(plan.west, plan.east);
    edges(plan.north, plan.south);
    return plan;
}

void incline(Random& random, CellBlueprint& block) {
    const auto height = [&] { return Coordinate{random.between(block.bottom.raw, block.top.raw)}; };
    Slant bottom;
    Slant top;
    do {
        bottom = {block.bottom, random.oneIn(2) ? block.bottom : height()};
        top = {block.top, random.oneIn(4) ? block.top : height()};
        if (random.oneIn(2)) std::swap(bottom.from, bottom.to);
        if (random.oneIn(2)) std::swap(top.from, top.to);
    } while (bottom.from > top.from || bottom.to > top.to ||
             (bottom.from == top.from && bottom.to == top.to));
    block.slopes = slopesTo(static_cast<Face>(random.below(4)), bottom, top);
}

World randomWorld(std::uint64_t seed) {
    Random random(seed);
    const int width = random.between(1, 10);
    const int depth = random.between(1, 10);
    const int levels = random.oneIn(8) ? kMaxLevels : random.between(1, 5);
    World world = emptyWorld(width, depth, levels);

    // Half of the blocks come from a few common shapes, the others are of any height.
    const auto shape = [&random]() -> std::pair<int, int> {
        constexpr int kQuarter = 65536 / 4;
        if (random.oneIn(2)) {
            const int bottom = random.between(0, 3);
            return {bottom * kQuarter, random.between(bottom + 1, 4) * kQuarter};
        }
        if (random.oneIn(2)) return {0, 65536};
        const int bottom = random.below(65536);
        return {bottom, random.between(bottom + 1, 65536)};
    };
    const double density = random.between(0.05, 0.6);
    for (int y = 0; y < depth; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int level = 0; level < levels; ++level) {
                if (random.unit() >= density) continue;
                const auto [bottom, top] = shape();
                putBlock(world, x, y, tileEdge(level) + Coordinate{bottom},
                         tileEdge(level) + Coordinate{top});
            }
        }
    }
    if (random.oneIn(3)) {
        putCeiling(world, Coordinate{random.between(1, levels * 65536 + 65536)});
        for (TextureId& tile : world.maps[0].ceiling.tiles)
            tile = random.oneIn(3) ? kNoTexture : TextureId{0};
    }
    for (CellBlueprint& block : world.blueprints) {
        if (random.oneIn(3)) block.plan = randomPlan(random);
    }
    world.blueprints[kEmptyCell].plan = {};
    Random slopes(seed ^ 0x736c6f70u);
    const bool hasSlopes = slopes.oneIn(2);
    for (std::size_t i = 1; hasSlopes && i < world.blueprints.size(); ++i) {
        if (world.blueprints[i].plan.half == Half::none && slopes.oneIn(2))
            incline(slopes, world.blueprints[i]);
    }
    return world;
}

World randomWaterWorld(std::uint64_t seed) {
    World world = randomWorld(seed);
    Random random(seed + 77);
    Map& map = world.maps[0];
    map.floor.water = 1;
    for (TextureId& tile : map.floor.tiles) tile = random.oneIn(2) ? TextureId{1} : TextureId{0};
    // Floods most empty cells up to the surface in level `flooded`; adds water here and there.
    const auto water = [&](Coordinate top) {
        CellBlueprint block;
        block.isWater = true;
        block.top = top;
        world.blueprints.push_back(block);
        return static_cast<BlueprintId>(world.blueprints.size() - 1);
    };
    const BlueprintId whole = water(tileEdge(1));
    const BlueprintId surface = water({random.between(1, 65536)});
    const int flooded = random.below(map.levels);
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            for (int level = 0; level < map.levels; ++level) {
                const bool isEmpty = map.cell(x, y, level) == kEmptyCell;
                if (isEmpty && level <= flooded && !random.oneIn(8)) {
                    map.setCell(x, y, level, level == flooded ? surface : whole);
                } else if (random.oneIn(12)) {
                    map.setCell(x, y, level, surface);
                }
            }
        }
    }
    return world;
}

bool isOverPart(const Plan& plan, int x, int y, const Box& box) {
    // In the tile; a box may be a point
    const int west = box.west.raw - x * 65536;
    const int east = box.east.raw - x * 65536;
    const int north = box.north.raw - y * 65536;
    const int south = box.south.raw - y * 65536;
    if (east <= plan.west.raw || west >= plan.east.raw || south <= plan.north.raw ||
        north >= plan.south.raw)
        return false;
    const int fromWest = std::max(west, 0);
    const int fromNorth = std::max(north, 0);
    const int toEast = std::min(east, 65536);
    const int toSouth = std::min(south, 65536);
    switch (plan.half) {
        case Half::northEast:
            return toEast > fromNorth;
        case Half::southEast:
            return toEast + toSouth > 65536;
        case Half::southWest:
            return toSouth > fromWest;
        case Half::northWest:
            return fromWest + fromNorth < 65536;
        case Half::none:
            break;
    }
    return true;
}

bool placeRandomly(const World& world, Random& random, Player& player) {
    const Map& map = world.maps[0];
    for (int attempt = 0; attempt < 100; ++attempt) {
        player = Player{};
        player.x = Coordinate{random.between(0, map.width * 65536)};
        player.y = Coordinate{random.between(0, map.depth * 65536)};
        player.z = Coordinate{random.between(0, (map.levels + 1) * 65536)};
        player.headingDegrees = random.between(0.0, 360.0);
        player.flying = random.oneIn(3);
        player.crouched = !player.flying && random.oneIn(3);
        if (!reachesIntoSomething(world, bodyBox(player))) return true;
    }
    return false;
}

// The sizes are exact in doubles. Over a part of the tile the heights of the slopes are extreme at
// its ends.
bool reachesBetweenSlopes(const Box& box, const CellBlueprint& block, int x, int y, int level) {
    if (!block.slopes.any()) return true;
    const bool alongX = block.slopes.alongX;
    const Plan& plan = block.plan;
    const Coordinate tile = tileEdge(alongX ? x : y);
    const double low =
        (std::max(alongX ? box.west : box.north, tile + (alongX ? plan.west : plan.north)) - tile)
            .value();
    const double high =
        (std::min(alongX ? box.east : box.south, tile + (alongX ? plan.east : plan.south)) - tile)
            .value();
    const auto heightAt = [&](const Slant& slant, double at) {
        return level + slant.from.value() +
               (slant.to.value() - slant.from.value()) * (at - slant.shift.value());
    };
    const auto [least, most] =
        std::pair(std::min(heightAt(block.slopes.bottom, low), heightAt(block.slopes.bottom, high)),
                  std::max(heightAt(block.slopes.top, low), heightAt(block.slopes.top, high)));
    return box.bottom.value() < most && box.top.value() > least;
}

bool reachesIntoSomething(const World& world, const Box& box) {
    const Map& map = world.maps[0];
    if (box.west < tileEdge(0) || box.north < tileEdge(0) || box.bottom.raw < -kFloorWade.raw)
        return true;
    if (box.east > tileEdge(map.width) || box.south > tileEdge(map.depth)) return true;
    for (int y = box.north.tile(); y <= box.south.tile() && y < map.depth; ++y) {
        for (int x = box.west.tile(); x <= box.east.tile() && x < map.width; ++x) {
            if (!(box.west < tileEdge(x + 1) && box.east > tileEdge(x) &&
                  box.north < tileEdge(y + 1) && box.south > tileEdge(y)))
                continue;
            if (!map.isWaterFloor(map.tileIndex(x, y)) && box.bottom < tileEdge(0)) return true;
            for (int level = 0; level < map.levels; ++level) {
                const BlueprintId id = map.cell(x, y, level);
                if (id == kEmptyCell) continue;
                const CellBlueprint& block = world.blueprints[id];
                if (block.isWater) continue;
                if (!isOverPart(block.plan, x, y, box)) continue;
                if (box.bottom < tileEdge(level) + block.top &&
                    box.top > tileEdge(level) + block.bottom &&
                    reachesBetweenSlopes(box, block, x, y, level))
                    return true;
            }
            const bool ceiling =
                !map.ceiling.tiles.empty() && map.ceiling.tiles[map.tileIndex(x, y)] != kNoTexture;
            if (ceiling && box.bottom < map.ceiling.height && box.top > map.ceiling.height)
                return true;
        }
    }
    return false;
}

Walker::Walker(World where, double x, double y, double feet, double headingDegrees)
    : world(std::move(where)) {
    world.start = {.map = 0,
                   .x = toCoordinate(x),
                   .y = toCoordinate(y),
                   .z = toCoordinate(feet),
                   .headingDegrees = headingDegrees,
                   .look = 0.0};
    player = playerAtStart(world);
}

void Walker::step(const PlayerInput& input, int steps) {
    for (int i = 0; i < steps; ++i) stepPlayer(world, player, input);
}

}  // namespace slicecast

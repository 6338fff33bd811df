// No pit without a way out: from wherever a player can get to, the start can be reached again, on
// foot and by jumping.
//
// The world is looked at as a graph of places: one for each tile and each height in it at which a
// player can stand. From a place one gets to those of the four tiles beside it that are no higher
// than a jump, if there is room for the head above the higher of the two.
#include "scenes/shipped.h"

#include "world/player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

constexpr Coordinate kJump = toCoordinate(0.75);
constexpr Coordinate kOpenAir = tileEdge(1024);

// Room to stand: from the ground to what is above the head.
struct Gap {
    Coordinate ground;
    Coordinate above;
};

struct Spot {
    int x, y;
    Gap gap;
};

// Every gap of a tile, from below.
std::vector<Gap> gapsOf(const World& world, const Map& map, int x, int y) {
    std::vector<Gap> solid;
    for (int level = 0; level < map.levels; ++level) {
        const BlueprintId cell = map.cell(x, y, level);
        if (cell == kEmptyCell) continue;
        const CellBlueprint& block = world.blueprints[cell];
        if (block.gate >= 0) continue;  // it opens
        solid.push_back({tileEdge(level) + block.bottom, tileEdge(level) + block.top});
    }
    const bool covered =
        !map.ceiling.tiles.empty() && map.ceiling.tiles[map.tileIndex(x, y)] != kNoTexture;
    if (covered) solid.push_back({map.ceiling.height, map.ceiling.height});
    std::sort(solid.begin(), solid.end(),
              [](const Gap& a, const Gap& b) { return a.ground.raw < b.ground.raw; });

    std::vector<Gap> gaps;
    Coordinate ground = {};
    for (const Gap& block : solid) {
        if (block.ground - ground >= kStandingHeight) gaps.push_back({ground, block.ground});
        ground = std::max(ground, block.above);
    }
    gaps.push_back({ground, kOpenAir});
    return gaps;
}

bool leadsTo(const Gap& from, const Gap& to) {
    return to.ground - from.ground <= kJump &&
           std::max(from.ground, to.ground) + kStandingHeight <= std::min(from.above, to.above);
}

using Steps = std::vector<std::vector<std::size_t>>;  // from each spot to others

// Which spots can be reached from one.
std::vector<bool> reachable(const Steps& steps, std::size_t start) {
    std::vector<bool> reached(steps.size());
    std::vector<std::size_t> open = {start};
    reached[start] = true;
    while (!open.empty()) {
        const std::size_t at = open.back();
        open.pop_back();
        for (const std::size_t next : steps[at]) {
            if (reached[next]) continue;
            reached[next] = true;
            open.push_back(next);
        }
    }
    return reached;
}

// The spots that one gets to and not back from.
std::vector<Spot> trapsOf(const World& world) {
    const Map& map = world.maps[static_cast<std::size_t>(world.start.map)];
    std::vector<Spot> spots;
    std::vector<std::size_t> first;  // of a tile's spots, by tile
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            first.push_back(spots.size());
            for (const Gap& gap : gapsOf(world, map, x, y)) spots.push_back({x, y, gap});
        }
    }
    first.push_back(spots.size());

    Steps there(spots.size());
    Steps back(spots.size());
    std::size_t start = spots.size();
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const Spot& from = spots[i];
        if (from.x == world.start.x.tile() && from.y == world.start.y.tile() &&
            from.gap.ground == world.start.z)
            start = i;
        constexpr std::pair<int, int> kBeside[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
        for (const auto& [dx, dy] : kBeside) {
            if (!map.contains(from.x + dx, from.y + dy)) continue;
            const std::size_t tile = map.tileIndex(from.x + dx, from.y + dy);
            for (std::size_t to = first[tile]; to < first[tile + 1]; ++to) {
                if (!leadsTo(from.gap, spots[to].gap)) continue;
                there[i].push_back(to);
                back[to].push_back(i);
            }
        }
    }

    if (start == spots.size()) {
        ADD_FAILURE() << world.title << ": the start is no place to stand at";
        return {};
    }

    const std::vector<bool> reached = reachable(there, start);
    const std::vector<bool> returns = reachable(back, start);
    std::vector<Spot> traps;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        if (reached[i] && !returns[i]) traps.push_back(spots[i]);
    }
    return traps;
}

TEST(Traps, ThereIsAWayBackFromEverywhere) {
    for (const std::string& scene : shippedScenes()) {
        for (const Spot& spot : trapsOf(shippedWorld(scene))) {
            ADD_FAILURE() << scene << ": no way out of tile " << spot.x << ", " << spot.y
                          << " at height " << spot.gap.ground.value();
        }
    }
}

}  // namespace
}  // namespace slicecast

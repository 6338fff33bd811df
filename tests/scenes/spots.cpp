#include "scenes/spots.h"

#include <algorithm>
#include <utility>

namespace slicecast {
namespace {

constexpr Coordinate kJump = toCoordinate(0.75);
constexpr Coordinate kOpenAir = kMaxBodyHeight;

// Every gap of a tile, from below.
std::vector<Gap> gapsOf(const World& world, const Map& map, int x, int y) {
    std::vector<Gap> solid;
    for (int level = 0; level < map.levels; ++level) {
        const BlueprintId cell = map.cell(x, y, level);
        if (cell == kEmptyCell) continue;
        const CellBlueprint& block = world.blueprints[cell];
        if (block.gate >= 0) continue;  // it opens
        solid.push_back(
            {tileEdge(level) + block.bottom, tileEdge(level) + block.top, block.isWater});
    }
    const bool covered =
        !map.ceiling.tiles.empty() && map.ceiling.tiles[map.tileIndex(x, y)] != kNoTexture;
    if (covered) solid.push_back({map.ceiling.height, map.ceiling.height, false});
    std::sort(solid.begin(), solid.end(),
              [](const Gap& a, const Gap& b) { return a.ground.raw < b.ground.raw; });

    std::vector<Gap> gaps;
    Coordinate ground = {};
    bool isWater = false;
    for (const Gap& block : solid) {
        if (block.ground - ground >= kStandingHeight)
            gaps.push_back({ground, block.ground, isWater});
        if (block.above <= ground) continue;
        ground = block.above;
        isWater = block.isWater;
    }
    gaps.push_back({ground, kOpenAir, isWater});
    return gaps;
}

bool leadsTo(const Gap& from, const Gap& to) {
    return to.ground - from.ground <= (from.isWater ? kClimbOut : kJump) &&
           std::max(from.ground, to.ground) + kStandingHeight <= std::min(from.above, to.above);
}

}  // namespace

Spots spotsOf(const World& world, const Map& map) {
    Spots spots;
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            spots.firsts.push_back(spots.all.size());
            for (const Gap& gap : gapsOf(world, map, x, y)) spots.all.push_back({x, y, gap});
        }
    }
    spots.firsts.push_back(spots.all.size());
    spots.there.resize(spots.all.size());
    spots.back.resize(spots.all.size());
    for (std::size_t i = 0; i < spots.all.size(); ++i) {
        const Spot& from = spots.all[i];
        constexpr std::pair<int, int> kBeside[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
        for (const auto& [dx, dy] : kBeside) {
            const int x = from.x + dx;
            const int y = from.y + dy;
            if (!map.contains(x, y)) continue;
            for (std::size_t to = spots.first(map, x, y); to < spots.last(map, x, y); ++to) {
                if (!leadsTo(from.gap, spots.all[to].gap)) continue;
                spots.there[i].push_back(to);
                spots.back[to].push_back(i);
            }
        }
    }
    return spots;
}

std::size_t startSpot(const World& world, const Spots& spots) {
    for (std::size_t i = 0; i < spots.all.size(); ++i) {
        const Spot& spot = spots.all[i];
        if (spot.x == world.start.x.tile() && spot.y == world.start.y.tile() &&
            spot.gap.ground == world.start.z)
            return i;
    }
    return spots.all.size();
}

std::vector<bool> reachable(const Steps& steps, std::vector<std::size_t> open) {
    std::vector<bool> reached(steps.size());
    for (const std::size_t at : open) reached[at] = true;
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

}  // namespace slicecast

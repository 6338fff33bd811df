#include "world/line_of_sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicecast {
namespace {

constexpr double kFarthest = 32768.0;  // units, the limit of coordinates

// The tile borders that the way crosses along one axis, as parts of the way's length.
struct Borders {
    int tile;
    int step;
    double next;
    double every;

    Borders(double from, double difference)
        : tile(static_cast<int>(std::floor(from))), step(difference < 0.0 ? -1 : 1) {
        const double rest = difference < 0.0 ? from - tile : tile + 1.0 - from;
        every = difference != 0.0 ? 1.0 / std::abs(difference)
                                  : std::numeric_limits<double>::infinity();
        next = difference != 0.0 ? rest * every : std::numeric_limits<double>::infinity();
    }
    void cross() {
        tile += step;
        next += every;
    }
};

// True if a block hides a part of the way, in one tile.
bool blockCovers(const World& world, const Map& map, int x, int y, const Place& from,
                 const Place& to, WayPart part) {
    if (!map.contains(x, y)) return false;
    const auto heightAt = [&](double share) { return from.z + share * (to.z - from.z); };
    const auto [low, high] = std::minmax({heightAt(part.from), heightAt(part.to)});
    const int last = std::min(map.levels - 1, static_cast<int>(std::floor(high)));
    for (int level = std::max(0, static_cast<int>(std::floor(low))); level <= last; ++level) {
        const BlueprintId id = map.cell(x, y, level);
        if (id == kEmptyCell) continue;
        const CellBlueprint& block = world.blueprints[id];
        if (block.seeThrough || block.passable) continue;
        const std::optional<WayPart> over =
            block.plan.isWhole()
                ? part
                : wayOver(block.plan, x, y, from.x, from.y, to.x - from.x, to.y - from.y, part);
        if (!over) continue;
        if (block.slopes.any()) {
            if (wayBetween(block.slopes, x, y, level, {from.x, from.y, from.z},
                           {to.x - from.x, to.y - from.y, to.z - from.z}, *over))
                return true;
            continue;
        }
        const auto [lowest, highest] = std::minmax({heightAt(over->from), heightAt(over->to)});
        if (lowest < level + block.top.value() && highest > level + block.bottom.value())
            return true;
    }
    return false;
}

bool ceilingCovers(const World& world, const Map& map, int x, int y, double low, double high) {
    const Ceiling& ceiling = map.ceiling;
    if (ceiling.tiles.empty() || !map.contains(x, y)) return false;
    const TextureId texture = ceiling.tiles[map.tileIndex(x, y)];
    return texture != kNoTexture && !world.textures[texture].seeThrough &&
           low < ceiling.height.value() && high > ceiling.height.value();
}

bool isOnGround(const Place& place) {
    return std::abs(place.x) < kFarthest && std::abs(place.y) < kFarthest && place.z >= 0.0 &&
           place.z < kFarthest;
}

}  // namespace

bool isInSight(const World& world, const Map& map, const Place& from, const Place& to,
               double ignored) {
    if (!isOnGround(from) || !isOnGround(to)) return false;
    const double length =
        std::sqrt((to.x - from.x) * (to.x - from.x) + (to.y - from.y) * (to.y - from.y) +
                  (to.z - from.z) * (to.z - from.z));
    if (!(length > ignored)) return true;
    const double most = 1.0 - ignored / length;
    Borders alongX(from.x, to.x - from.x);
    Borders alongY(from.y, to.y - from.y);
    const auto heightAt = [&](double share) { return from.z + share * (to.z - from.z); };
    double entered = 0.0;
    while (true) {
        Borders& crossed = alongX.next < alongY.next ? alongX : alongY;
        const double left = std::min(crossed.next, most);
        const auto [low, high] = std::minmax({heightAt(entered), heightAt(left)});
        if (entered > 0.0 && map.tilePortal(alongX.tile, alongY.tile) != kNoPortal) return false;
        if (blockCovers(world, map, alongX.tile, alongY.tile, from, to, {entered, left}) ||
            ceilingCovers(world, map, alongX.tile, alongY.tile, low, high))
            return false;
        if (!(crossed.next < most)) return true;
        entered = crossed.next;
        crossed.cross();
    }
}

}  // namespace slicecast

#include "world/collision.h"

#include "world/solids.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace slicecast {
namespace {

const Map* findMap(const World& world, int map) {
    return map >= 0 && static_cast<std::size_t>(map) < world.maps.size()
               ? &world.maps[static_cast<std::size_t>(map)]
               : nullptr;
}

bool isInsideOutline(const Map& map, const Box& box) {
    return box.west.raw >= 0 && box.north.raw >= 0 && box.east <= tileEdge(map.width) &&
           box.south <= tileEdge(map.depth);
}

}  // namespace

bool isFree(const World& world, int map, const Box& box, bool floats) {
    const Map* where = findMap(world, map);
    if (where == nullptr || !isInsideOutline(*where, box)) return false;
    return isFreeAmong(MapSolids(world, *where, floats), box);
}

Coordinate sweepX(const World& world, int map, const Box& box, Coordinate distance) {
    const Map* where = findMap(world, map);
    return where != nullptr ? sweepXAmong(MapSolids(world, *where), box, distance) : Coordinate{};
}

Coordinate sweepY(const World& world, int map, const Box& box, Coordinate distance) {
    const Map* where = findMap(world, map);
    return where != nullptr ? sweepYAmong(MapSolids(world, *where), box, distance) : Coordinate{};
}

Coordinate sweepZ(const World& world, int map, const Box& box, Coordinate distance, bool floats) {
    const Map* where = findMap(world, map);
    if (where == nullptr || !isInsideOutline(*where, box)) return {};
    return sweepZAmong(MapSolids(world, *where, floats), box, distance);
}

bool isSupported(const World& world, int map, const Box& box) {
    return sweepZ(world, map, box, {-1}).raw == 0;
}

std::optional<Coordinate> leastRise(const World& world, int map, const Box& box, Coordinate limit) {
    const Map* where = findMap(world, map);
    if (where == nullptr || !isInsideOutline(*where, box)) return std::nullopt;
    return leastRiseAmong(MapSolids(world, *where), box, limit);
}

std::int64_t partsOf(Coordinate distanceX, Coordinate distanceY) {
    const std::int64_t longest =
        std::max(std::abs(std::int64_t{distanceX.raw}), std::abs(std::int64_t{distanceY.raw}));
    return (longest + kLongestSlide.raw - 1) / kLongestSlide.raw;
}

Slide slide(const World& world, int map, const Box& box, Coordinate distanceX, Coordinate distanceY,
            Coordinate step, bool floats) {
    Slide state;
    state.box = box;
    const Map* where = findMap(world, map);
    if (where == nullptr) return state;
    const MapSolids solids(world, *where, floats);
    const auto go = [&](Coordinate Offset::*axis, Coordinate distance, bool& stopped) {
        const Box from = state.box;
        if (distance.raw == 0 || advanceAmong(solids, state, axis, distance, step)) return;
        const int slip = slipAmong(solids, state.box, axis, distance.raw > 0);
        stopped = stopped || slip == 0 || state.slip == -slip;
        if (slip == 0) return;
        state.slip = slip;
        const bool alongX = axis == &Offset::x;
        const Coordinate done = alongX ? state.box.west - from.west : state.box.north - from.north;
        const Coordinate half = {(distance - done).raw / 2};
        advanceAmong(solids, state, alongX ? &Offset::y : &Offset::x, {slip * half.raw}, step);
        advanceAmong(solids, state, axis, half, step);
    };
    const std::int64_t parts = partsOf(distanceX, distanceY);
    for (std::int64_t i = 0; i < parts; ++i) {
        go(&Offset::x, partOf(distanceX, i, parts), state.stoppedX);
        go(&Offset::y, partOf(distanceY, i, parts), state.stoppedY);
    }
    return state;
}

}  // namespace slicecast

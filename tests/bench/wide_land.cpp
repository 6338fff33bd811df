#include "wide_land.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace slicecast {

World stonesOnLand(World world, int size) {
    constexpr int kStones = 60;
    constexpr int kBlueprints = 3;  // that are whole blocks
    const Map& like = world.maps.front();
    Map land = makeMap("land", size, size, 4, like.floor.texture);
    land.light = like.light;
    land.haze = like.haze;
    // In a spiral, so that they stand alone.
    for (int n = 4; n < kStones; ++n) {
        const double turn = n * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double distance = 3.4 * std::sqrt(n);
        const auto tile = [&](double offset) { return size / 2 + static_cast<int>(offset); };
        for (int level = 0; level <= n % 3; ++level)
            land.setCell(tile(distance * std::cos(turn)), tile(distance * std::sin(turn)), level,
                         static_cast<BlueprintId>(1 + n % kBlueprints));
    }
    const Coordinate middle = toCoordinate(size / 2 + 0.5);
    world.maps.assign(1, std::move(land));
    world.start = {0, middle, middle, {0}, 30.0, 0.0};
    return world;
}

}  // namespace slicecast

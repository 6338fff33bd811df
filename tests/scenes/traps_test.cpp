// No pit without a way out: from wherever a player can get to, the start can be reached again, on
// foot and by jumping.
#include "scenes/shipped.h"
#include "scenes/spots.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slicecast {
namespace {

// The spots that one gets to and not back from.
std::vector<Spot> trapsOf(const World& world) {
    const Spots spots = spotsOf(world, world.maps[static_cast<std::size_t>(world.start.map)]);
    const std::size_t start = startSpot(world, spots);
    if (start == spots.all.size()) {
        ADD_FAILURE() << world.title << ": the start is no place to stand at";
        return {};
    }
    const std::vector<bool> reached = reachable(spots.there, {start});
    const std::vector<bool> returns = reachable(spots.back, {start});
    std::vector<Spot> traps;
    for (std::size_t i = 0; i < spots.all.size(); ++i) {
        if (reached[i] && !returns[i]) traps.push_back(spots.all[i]);
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

// Something visible ends each world: on foot, by jumping or in water, the player never gets to a
// border of a shipped map where only the end of the grid stops them.
#include "scenes/shipped.h"
#include "scenes/spots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace slicecast {
namespace {

// Where one comes into a map: the start, and the ground of the tiles that portals lead to.
std::vector<std::size_t> entrances(const World& world, int map, const Spots& spots) {
    const Map& m = world.maps[static_cast<std::size_t>(map)];
    std::vector<std::size_t> found;
    if (world.start.map == map) {
        const std::size_t start = startSpot(world, spots);
        EXPECT_LT(start, spots.all.size()) << world.title << ": no place to stand at the start";
        if (start < spots.all.size()) found.push_back(start);
    }
    for (const Portal& portal : world.portals) {
        if (portal.toMap == map && m.contains(portal.toX, portal.toY))
            found.push_back(spots.first(m, portal.toX, portal.toY));
    }
    // A map that is there to be chosen begins where the start's map does.
    const Map& home = world.maps[static_cast<std::size_t>(world.start.map)];
    if (found.empty() && m.width == home.width && m.depth == home.depth)
        found.push_back(spots.first(m, world.start.x.tile(), world.start.y.tile()));
    return found;
}

// From the tile of a portal one does not go on in this map.
void takeAwayAtPortals(const Map& map, Spots& spots) {
    for (std::size_t i = 0; i < spots.all.size(); ++i) {
        if (map.tilePortal(spots.all[i].x, spots.all[i].y) != kNoPortal) spots.there[i].clear();
    }
}

bool hasPortal(const World& world, const Map& map, int mapIndex, int x, int y) {
    if (map.tilePortal(x, y) != kNoPortal) return true;
    return std::any_of(world.portals.begin(), world.portals.end(), [&](const Portal& portal) {
        return (portal.fromMap == mapIndex && portal.fromX == x && portal.fromY == y) ||
               (portal.toMap == mapIndex && portal.toX == x && portal.toY == y);
    });
}

TEST(WorldEnds, NobodyGetsToTheBorderOfAMap) {
    int maps = 0;
    for (const std::string& name : shippedScenes()) {
        const World world = shippedWorld(name);
        for (int i = 0; i < static_cast<int>(world.maps.size()); ++i) {
            const Map& map = world.maps[static_cast<std::size_t>(i)];
            Spots spots = spotsOf(world, map);
            takeAwayAtPortals(map, spots);
            const std::vector<bool> reached = reachable(spots.there, entrances(world, i, spots));
            std::vector<std::string> plan(static_cast<std::size_t>(map.depth),
                                          std::string(static_cast<std::size_t>(map.width), '.'));
            int atTheBorder = 0;
            std::string heights;
            for (std::size_t s = 0; s < spots.all.size(); ++s) {
                if (!reached[s]) continue;
                const Spot& spot = spots.all[s];
                const bool isBorder = spot.x == 0 || spot.y == 0 || spot.x == map.width - 1 ||
                                      spot.y == map.depth - 1;
                const bool isFault = isBorder && !hasPortal(world, map, i, spot.x, spot.y);
                plan[static_cast<std::size_t>(spot.y)][static_cast<std::size_t>(spot.x)] =
                    isFault                       ? 'X'
                    : spot.gap.ground.raw == 0    ? '0'
                    : spot.gap.ground.tile() < 10 ? static_cast<char>('0' + spot.gap.ground.tile())
                                                  : '9';
                if (!isFault) continue;
                ++atTheBorder;
                heights += " " + std::to_string(spot.x) + "," + std::to_string(spot.y) + ":" +
                           std::to_string(spot.gap.ground.value());
            }
            maps += std::count(reached.begin(), reached.end(), true) > 1 ? 1 : 0;
            std::string picture;
            for (const std::string& row : plan) picture += row + "\n";
            EXPECT_EQ(atTheBorder, 0)
                << name << ", " << map.name << ": where one gets to (X: a border without an end)\n"
                << picture << "x,y:height" << heights;
        }
    }
    EXPECT_GE(maps, 18) << "maps that can be walked in";
}

}  // namespace
}  // namespace slicecast

#include "world/way_out.h"

#include "world/player.h"
#include "world/traveller.h"
#include "world/world.h"

namespace slicecast {
namespace {

// True if a block in that tile or beside it moves or opens.
bool somethingMoves(const World& world, const Map& map, GridTile tile) {
    for (int y = tile.y - 1; y <= tile.y + 1; ++y) {
        for (int x = tile.x - 1; x <= tile.x + 1; ++x) {
            if (!map.contains(x, y)) continue;
            for (int level = 0; level < map.levels; ++level) {
                // Moving blocks that are elsewhere at present count too
                if (!world.blueprints[map.cells[map.cellIndex(x, y, level)]].isStill()) return true;
            }
        }
    }
    return false;
}

}  // namespace

bool hasWayOut(const World& world, int map, Coordinate x, Coordinate y, Coordinate feet) {
    Traveller body = {.map = map,
                      .box = bodyBox(x, y, feet, kCrouchedHeight),
                      .eye = {x, y, feet + kCrouchedEye},
                      .behind = {}};
    // The body can cross water like ground, unless it starts in water
    body.floats = true;
    body.floats = isFree(world, body);
    const GridTile startTile = {x.tile(), y.tile()};
    const Map& here = world.maps[static_cast<std::size_t>(map)];
    if ((here.width == 1 && here.depth == 1) || somethingMoves(world, here, startTile)) return true;
    const auto isElsewhere = [&](const Traveller& there) {
        return there.leaps > 0 || there.eye.x.tile() != startTile.x ||
               there.eye.y.tile() != startTile.y;
    };
    rise(world, body, {-kMaxBodyHeight.raw});

    // To the middle of the tile, then in all four directions
    const Coordinate half = {tileEdge(1).raw / 2};
    slide(world, body, tileEdge(startTile.x) + half - x, tileEdge(startTile.y) + half - y,
          kJumpHeight);
    if (isElsewhere(body)) return true;
    constexpr int kEast[] = {1, 0, -1, 0};
    constexpr int kSouth[] = {0, 1, 0, -1};
    for (int i = 0; i < 4; ++i) {
        Traveller walker = body;
        slide(world, walker, tileEdge(kEast[i]), tileEdge(kSouth[i]), kJumpHeight);
        if (isElsewhere(walker)) return true;
    }
    return false;
}

}  // namespace slicecast

#include "moving.h"

#include <string>

namespace slicecast {

BlueprintId addMoving(World& world, Coordinate bottom, Coordinate top, const Motion& motion) {
    CellBlueprint block;
    block.name = "moving " + std::to_string(world.motions.size());
    block.bottom = bottom;
    block.top = top;
    block.motion = static_cast<int>(world.motions.size());
    world.motions.push_back(motion);
    world.blueprints.push_back(block);
    return static_cast<BlueprintId>(world.blueprints.size() - 1);
}

BlueprintId addGate(World& world, const GateKind& kind) {
    CellBlueprint block;
    block.name = "gate " + std::to_string(world.gateKinds.size());
    block.gate = static_cast<int>(world.gateKinds.size());
    world.gateKinds.push_back(kind);
    world.blueprints.push_back(block);
    return static_cast<BlueprintId>(world.blueprints.size() - 1);
}

void shift(Player& player, const Body& body) {
    player.x = player.x + body.shift.x;
    player.y = player.y + body.shift.y;
    player.z = player.z + body.shift.z;
}

void stepBoth(World& world, Player& player, const PlayerInput& input, const GateAsk& ask) {
    Body body = bodyOf(travellerOf(player), player.onGround);
    stepWorld(world, {&body, 1}, ask);
    shift(player, body);
    stepPlayer(world, player, input);
}

GateAsk asks(const Player& player, GateAsk::Wish wish) {
    return {.wish = wish, .map = player.map, .x = player.x, .y = player.y, .z = eyeHeight(player)};
}

bool reachesIntoSolid(const World& world, int mapIndex, const Box& box) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    for (int x = 0; x < map.width; ++x) {
        for (int y = 0; y < map.depth; ++y) {
            if (box.east <= tileEdge(x) || box.west >= tileEdge(x + 1) ||
                box.south <= tileEdge(y) || box.north >= tileEdge(y + 1))
                continue;
            for (int level = 0; level < map.levels; ++level) {
                const CellBlueprint& block =
                    world.blueprints[map.cells[map.cellIndex(x, y, level)]];
                if (map.cells[map.cellIndex(x, y, level)] == kEmptyCell || block.passable ||
                    block.top <= block.bottom || block.plan.east <= block.plan.west ||
                    block.plan.south <= block.plan.north)
                    continue;
                if (!isOverPart(block.plan, x, y, box)) continue;
                if (box.bottom < tileEdge(level) + block.top &&
                    box.top > tileEdge(level) + block.bottom &&
                    reachesBetweenSlopes(box, block, x, y, level))
                    return true;
            }
        }
    }
    return false;
}

}  // namespace slicecast

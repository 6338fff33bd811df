#include "world/water.h"

#include "world/traveller.h"
#include "world/world.h"

namespace slicecast {

WaterAt waterAt(const World& world, const Map& map, int tileX, int tileY, Coordinate z) {
    int level = z.tile();
    const CellBlueprint* block = &world.blueprints[map.cell(tileX, tileY, level)];
    const Coordinate base = tileEdge(level);
    if (!block->isWater || z < base + block->bottom || z >= base + block->top) return {};
    WaterAt found = {block, base + block->top};
    while (found.surface == tileEdge(level + 1)) {
        block = &world.blueprints[map.cell(tileX, tileY, ++level)];
        if (!block->isWater || block->bottom.raw != 0) break;
        found.surface = tileEdge(level) + block->top;
    }
    return found;
}

Coordinate waterDepth(const World& world, const Traveller& body) {
    const Coordinate feet = body.box.bottom;
    const Map& map = world.maps[static_cast<std::size_t>(body.map)];
    // Below the floor there is only water
    const WaterAt here = waterAt(world, map, body.eye.x.tile(), body.eye.y.tile(),
                                 feet.raw < 0 ? Coordinate{0} : feet);
    return here.water != nullptr || feet.raw < 0 ? here.surface - feet : Coordinate{0};
}

void floatObjects(World& world) {
    for (Map& map : world.maps) {
        for (Object& object : map.objects) {
            if (!object.floats) continue;
            const WaterAt here = waterAt(world, map, object.x.tile(), object.y.tile(), object.z);
            if (here.water != nullptr) object.z = here.surface;
        }
    }
}

}  // namespace slicecast

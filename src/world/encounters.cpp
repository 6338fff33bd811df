#include "world/encounters.h"

#include "world/body.h"
#include "world/solids.h"
#include "world/world.h"

#include <algorithm>
#include <bit>

namespace slicecast {
namespace {

// How far from a body a portal face may be, in levels: movers may lift the body towards it.
constexpr int kNearLevels = 2;

struct Finder {
    World& world;
    std::span<const Body> bodies;

    void addBody(int body);
    void addTile(const Map& map, GridTile tile, int body);
    void addThrough(PortalId id, GridTile tile, int body);
    void addTo(int& first, int body);
};

// Adds the body to a list, unless it is there already.
void Finder::addTo(int& first, int body) {
    if (first >= 0 && world.encounters[static_cast<std::size_t>(first)].body == body) return;
    world.encounters.push_back({body, first});
    first = static_cast<int>(world.encounters.size()) - 1;
}

// All movers and gates of a tile.
void Finder::addTile(const Map& map, GridTile tile, int body) {
    if (map.changing.empty() || !map.contains(tile.x, tile.y)) return;
    for (std::uint32_t levels = map.changing[map.tileIndex(tile.x, tile.y)]; levels != 0;
         levels &= levels - 1) {
        const CellBlueprint& block =
            world.blueprints[map.cells[map.cellIndex(tile.x, tile.y, std::countr_zero(levels))]];
        if (block.mover >= 0)
            addTo(world.movers[static_cast<std::size_t>(block.mover)].firstEncounter, body);
        if (block.gateIndex >= 0)
            addTo(world.gates[static_cast<std::size_t>(block.gateIndex)].firstEncounter, body);
    }
}

// Those where a portal of the tile leads to.
void Finder::addThrough(PortalId id, GridTile tile, int body) {
    if (id == kNoPortal) return;
    const Portal& portal = world.portals[id];
    addTile(world.maps[static_cast<std::size_t>(portal.toMap)], carried(portal, tile), body);
}

void Finder::addBody(int index) {
    const Body& body = bodies[static_cast<std::size_t>(index)];
    const Map& map = world.maps[static_cast<std::size_t>(body.map)];
    const SolidRange columns = reached(body.box.west, body.box.east);
    const SolidRange rows = reached(body.box.north, body.box.south);
    const int lowest = std::max(0, body.box.bottom.tile() - kNearLevels);
    const int highest = std::min(map.levels - 1, body.box.top.tile() + kNearLevels);
    for (int y = rows.first; y <= rows.last; ++y) {
        for (int x = columns.first; x <= columns.last; ++x) {
            addTile(map, {x, y}, index);
            if (!body.straddles) continue;
            if (body.behind.isOn) {
                const Portal& back = body.behind.back;
                addTile(world.maps[static_cast<std::size_t>(back.toMap)],
                        carried(back, GridTile{x, y}), index);
            }
            addThrough(map.tilePortal(x, y), {x, y}, index);
            for (int level = lowest; level <= highest; ++level) {
                const CellBlueprint& block = world.blueprints[map.cell(x, y, level)];
                if (!block.hasPortals) continue;
                for (const FaceBlueprint& face : block.faces)
                    addThrough(face.portal, {x, y}, index);
            }
        }
    }
}

}  // namespace

void findEncounters(World& world, std::span<const Body> bodies) {
    for (Mover& mover : world.movers) mover.firstEncounter = -1;
    for (Gate& gate : world.gates) gate.firstEncounter = -1;
    world.encounters.clear();
    // Hardly any body reaches into more tiles, so later steps take no memory.
    world.encounters.reserve(bodies.size() * 4);
    Finder finder{world, bodies};
    for (std::size_t i = 0; i < bodies.size(); ++i) finder.addBody(static_cast<int>(i));
}

}  // namespace slicecast

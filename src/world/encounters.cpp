#include "world/encounters.h"

#include "world/body.h"
#include "world/player.h"
#include "world/solids.h"
#include "world/world.h"

#include <algorithm>
#include <bit>

namespace slicecast {
namespace {

// How far from a body a portal face may be, in levels: movers may lift the body towards it.
constexpr int kNearLevels = 2;
// How far from a body a block may be. A step moves a block by at most 1/30 unit, but several may
// take a body along, one after another.
constexpr Coordinate kNear = tileEdge(1);
static_assert(kFastestMotion * kStepSeconds < 1.0 / 29.0);

struct Finder {
    World& world;
    std::span<const Body> bodies;

    void addBody(int body);
    void addTile(const Map& map, GridTile tile, const Box& near, int body);
    void addThrough(const Portal& portal, GridTile tile, const Box& near, int body);
    void addTo(int& first, int body);
};

// What is near a body.
Box around(const Box& body) {
    return {body.west - kNear,  body.east + kNear,   body.north - kNear,
            body.south + kNear, body.bottom - kNear, body.top + kNear};
}

// A box of the entry map in the exit map.
Box carried(const Portal& portal, const Box& box) {
    const Position a = carried(portal, Position{box.west, box.north, box.bottom});
    const Position b = carried(portal, Position{box.east, box.south, box.top});
    return {
        std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y), a.z, b.z};
}

// Adds the body to a list, unless it is there already.
void Finder::addTo(int& first, int body) {
    if (first >= 0 && world.encounters[static_cast<std::size_t>(first)].body == body) return;
    world.encounters.push_back({body, first});
    first = static_cast<int>(world.encounters.size()) - 1;
}

// All movers and gates of a tile that are near.
void Finder::addTile(const Map& map, GridTile tile, const Box& near, int body) {
    if (map.changing.empty() || !map.contains(tile.x, tile.y)) return;
    const int lowest = std::clamp(near.bottom.tile(), 0, kMaxLevels - 1);
    const int highest = std::clamp(near.top.tile(), 0, kMaxLevels - 1);
    const std::uint32_t reached = ~0u << lowest & ~0u >> (kMaxLevels - 1 - highest);
    for (std::uint32_t levels = map.changing[map.tileIndex(tile.x, tile.y)] & reached; levels != 0;
         levels &= levels - 1) {
        const int level = std::countr_zero(levels);
        const CellBlueprint& block =
            world.blueprints[map.cells[map.cellIndex(tile.x, tile.y, level)]];
        if (tileEdge(level) + block.bottom > near.top ||
            tileEdge(level) + block.top < near.bottom ||
            tileEdge(tile.x) + block.plan.west > near.east ||
            tileEdge(tile.x) + block.plan.east < near.west ||
            tileEdge(tile.y) + block.plan.north > near.south ||
            tileEdge(tile.y) + block.plan.south < near.north)
            continue;
        if (block.mover >= 0)
            addTo(world.movers[static_cast<std::size_t>(block.mover)].firstEncounter, body);
        if (block.gateIndex >= 0)
            addTo(world.gates[static_cast<std::size_t>(block.gateIndex)].firstEncounter, body);
    }
}

// Those where a portal of the tile leads to.
void Finder::addThrough(const Portal& portal, GridTile tile, const Box& near, int body) {
    addTile(world.maps[static_cast<std::size_t>(portal.toMap)], carried(portal, tile),
            carried(portal, near), body);
}

void Finder::addBody(int index) {
    const Body& body = bodies[static_cast<std::size_t>(index)];
    const Map& map = world.maps[static_cast<std::size_t>(body.map)];
    const Box surroundings = around(body.box);
    const SolidRange columns = reached(surroundings.west, surroundings.east);
    const SolidRange rows = reached(surroundings.north, surroundings.south);
    // What reaches into a portal may meet blocks at any height
    const Coordinate least = {-kBoundless.raw};
    const Box near = body.straddles ? Box{least, kBoundless, least, kBoundless, least, kBoundless}
                                    : surroundings;
    const int lowest = std::max(0, body.box.bottom.tile() - kNearLevels);
    const int highest = std::min(map.levels - 1, body.box.top.tile() + kNearLevels);
    for (int y = rows.first; y <= rows.last; ++y) {
        for (int x = columns.first; x <= columns.last; ++x) {
            addTile(map, {x, y}, near, index);
            if (!body.straddles) continue;
            const auto addPortal = [&](PortalId id) {
                if (id != kNoPortal) addThrough(world.portals[id], {x, y}, near, index);
            };
            if (body.behind.isOn) addThrough(body.behind.back, {x, y}, near, index);
            addPortal(map.tilePortal(x, y));
            for (int level = lowest; level <= highest; ++level) {
                const CellBlueprint& block = world.blueprints[map.cell(x, y, level)];
                if (!block.hasPortals) continue;
                for (const FaceBlueprint& face : block.faces) addPortal(face.portal);
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

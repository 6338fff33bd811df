#include "world/world_step.h"

#include "base/hash.h"
#include "world/encounters.h"
#include "world/world.h"

#include <algorithm>

namespace slicecast {
namespace {

// True if the body reaches into a tile with a portal, so that a part of it may be elsewhere.
bool reachesIntoPortal(const World& world, const Body& body) {
    if (body.behind.isOn) return true;
    const Map& map = world.maps[static_cast<std::size_t>(body.map)];
    for (int y = body.box.north.tile(); y <= body.box.south.tile(); ++y) {
        for (int x = body.box.west.tile(); x <= body.box.east.tile(); ++x) {
            if (map.tilePortal(x, y) != kNoPortal) return true;
            const int last = std::min(map.levels - 1, body.box.top.tile());
            for (int level = std::max(0, body.box.bottom.tile()); level <= last; ++level) {
                if (world.blueprints[map.cell(x, y, level)].hasPortals) return true;
            }
        }
    }
    return false;
}

}  // namespace

bool isStill(const World& world) {
    return world.movers.empty() && world.gates.empty();
}

void stepWorld(World& world, std::span<Body> bodies, const GateAsk& ask) {
    if (isStill(world)) return;
    for (Body& body : bodies) {
        body.shift = {};
        body.straddles = !world.portals.empty() && reachesIntoPortal(world, body);
    }
    findEncounters(world, bodies);
    stepMovers(world, bodies);
    stepGates(world, bodies, ask);
}

void showBetween(World& world, double fraction) {
    const double part = fraction < 1.0 ? std::max(fraction, 0.0) : 1.0;
    showMovers(world, part);
    showObjects(world, part);
}

void resetWorld(World& world) {
    resetMovers(world);
    resetGates(world);
}

void addTo(Hash& hash, const World& world) {
    for (const Mover& mover : world.movers) hash.add(std::int64_t{mover.clock});
    if (world.nextLookout > 0) hash.add(static_cast<std::int64_t>(world.nextLookout));
    for (const Gate& gate : world.gates) {
        for (const int number :
             {gate.progress, int{gate.wantsOpen}, int{gate.isNear}, gate.awaySteps})
            hash.add(std::int64_t{number});
        const GateKind& kind = world.gateKinds[static_cast<std::size_t>(gate.kind)];
        if (kind.everySteps > 0) hash.add(std::int64_t{gate.waitSteps});
        if (!kind.follows.empty()) hash.add(std::int64_t{gate.isLed});
    }
}

}  // namespace slicecast

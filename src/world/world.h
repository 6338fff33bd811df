// A world: everything that a scene file describes.
#pragma once

#include "base/coordinate.h"
#include "world/blueprint.h"
#include "world/encounters.h"
#include "world/gate.h"
#include "world/map.h"
#include "world/motion.h"
#include "world/mover.h"
#include "world/object_motion.h"
#include "world/portal.h"
#include "world/quest.h"
#include "world/sprite.h"
#include "world/texture.h"

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace slicecast {

// Where the player starts: the point under the feet, and the view.
struct Start {
    int map = 0;  // index into World::maps
    Coordinate x;
    Coordinate y;
    Coordinate z;                 // height of the feet
    double headingDegrees = 0.0;  // 0 = east, 90 = south
    double look = 0.0;            // screen heights, positive up
};

// May take hundreds of megabytes, so it moves; only copy() copies it.
struct World {
    World() = default;
    World(World&&) = default;
    World& operator=(World&&) = default;
    ~World() = default;
    World copy() const { return World(*this); }

    std::string title;
    std::vector<Texture> textures;
    std::vector<Sprite> sprites;
    std::vector<CellBlueprint> blueprints = {
        CellBlueprint{}};  // [0] is the empty cell, never drawn
    std::vector<Map> maps;
    MovingObjects movingObjects;
    std::vector<Portal> portals;
    int portalLimit = kDefaultPortalLimit;  // the most portals that a ray passes
    std::vector<LampKind> lampKinds;        // of faces
    std::vector<Motion> motions;
    std::vector<Mover> movers;  // see makeMovers
    std::vector<GateKind> gateKinds;
    std::vector<Gate> gates;            // see makeGates
    std::size_t nextLookout = 0;        // of the gates that open on approach, see stepGates
    std::vector<Encounter> encounters;  // of the present step, see findEncounters
    Quest quest;
    Start start;
    std::int64_t steps = 0;  // since the world began; drive what is animated
    bool hasPlans = false;   // a blueprint fills only a part of its tile; set by markPlans

private:
    World(const World&) = default;
};
static_assert(!std::is_copy_constructible_v<World> && !std::is_copy_assignable_v<World>);

// A copy of a blueprint for a block that moves, opens, has portals or looks different.
CellBlueprint instanceOf(const World& world, BlueprintId id);

// Whether two see-through blocks are of one kind, so that there are no faces between them.
bool areJoined(const World& world, const CellBlueprint& a, const CellBlueprint& b);

// Whether two side by side along an axis are see-through parts of one block that moves along it.
// They join whatever `join` says, so that no face stands still while the block goes through a
// border.
bool areOneAlong(const World& world, const CellBlueprint& a, const CellBlueprint& b, Axis axis);

// Parts of one mover that a border between levels separates count as one block.
inline bool areOneMover(const CellBlueprint& a, const CellBlueprint& b) {
    return a.mover >= 0 && a.mover == b.mover;
}

// Sets CellBlueprint::seeThrough; water always is. Textures and faces must be complete.
void markSeeThrough(World& world);

// Sets CellBlueprint::hasPortals. Portals must be complete.
void markPortals(World& world);

// Whether a block moves along x or y, so that it may fill only a part of its tile at times.
bool movesSideways(const World& world, const CellBlueprint& block);

// Sets World::hasPlans. Blueprints must be complete.
void markPlans(World& world);

}  // namespace slicecast

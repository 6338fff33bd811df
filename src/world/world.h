// A world: everything that a scene file describes.
#pragma once

#include "base/coordinate.h"
#include "world/blueprint.h"
#include "world/gate.h"
#include "world/map.h"
#include "world/motion.h"
#include "world/mover.h"
#include "world/object_motion.h"
#include "world/portal.h"
#include "world/sprite.h"
#include "world/texture.h"

#include <string>
#include <type_traits>
#include <vector>

namespace slicecast {

// Where the player starts: the middle of the feet, and where they look.
struct Start {
    int map = 0;  // index into World::maps
    Coordinate x;
    Coordinate y;
    Coordinate z;                 // height of the feet
    double headingDegrees = 0.0;  // 0 = east, 90 = south
    double look = 0.0;            // screen heights, positive up
};

// It may be hundreds of megabytes: it is moved, and copied by copy() alone.
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
        CellBlueprint{}};  // [0] stands for the empty cell and is never drawn
    std::vector<Map> maps;
    MovingObjects movingObjects;
    std::vector<Portal> portals;
    int portalLimit = kDefaultPortalLimit;  // a ray passes at most that many
    std::vector<Motion> motions;
    std::vector<Mover> movers;  // see makeMovers
    std::vector<GateKind> gateKinds;
    std::vector<Gate> gates;  // see makeGates
    Start start;
    double seconds = 0.0;  // since the world began; animated textures follow it

private:
    World(const World&) = default;
};
static_assert(!std::is_copy_constructible_v<World> && !std::is_copy_assignable_v<World>);

// A copy of a blueprint for a block that moves, opens or has portals.
CellBlueprint instanceOf(const World& world, BlueprintId id);

// Whether two see-through blocks are of one kind, so that where they touch there are no faces
// between them.
bool areJoined(const World& world, const CellBlueprint& a, const CellBlueprint& b);

// Parts of one thing that moves, which a border between levels has cut, are one block where they
// touch.
inline bool areOneMover(const CellBlueprint& a, const CellBlueprint& b) {
    return a.mover >= 0 && a.mover == b.mover;
}

// Finds out which blueprints are see-through; water always is. For a world whose textures and faces
// are complete.
void markSeeThrough(World& world);

// Finds out which blueprints have portals. For a world whose portals are complete.
void markPortals(World& world);

}  // namespace slicecast

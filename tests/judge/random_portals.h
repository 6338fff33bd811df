// What random worlds have beyond blocks, planes and objects: portals, mirrors, and what moving
// blocks leave behind.
#pragma once

#include "base/random.h"
#include "world/world.h"

namespace slicecast::judge {

// Portals on faces and on whole tiles, between all maps and within each, at any turn and shifted by
// whole levels; exits anywhere, within blocks too, often in loops. A ray may pass 0 to 5. For a
// world whose maps and blueprints are complete.
void addPortals(Random& random, World& world);

// Whether a portal in a roof or an underside leads to a tile of a map.
bool isExitFromLevelFace(const World& world, int map, int x, int y);

// Mirrors of any strength on floors and roofs.
void addMirrors(Random& random, World& world);

// Blocks as moving ones are at some moment: pillars whose parts on several levels move as one, and
// cells that are empty just now.
void addMovers(Random& random, World& world);

// Beside see-through blocks with portals, blocks of the same blueprint without.
void addKin(Random& random, World& world);

// Some of what moves does not join, and most has carried its textures up.
void changeMovers(Random& random, World& world);

// Beside see-through blocks, others of the same blueprint that move, and now reach from and up to
// other heights.
void addUneven(Random& random, World& world, bool coarse);

// Blocks as those that move along x or y are at some moment: rows, on a level or two, that stand
// between tiles. In the place of blocks without portals.
void addSliders(Random& random, World& world, bool coarse);

// Beside some of them, more rows of the same mover, where cells are empty.
void widenSliders(World& world);

// Blocks with slopes as those that move are at some moment, up, east or south, in one or two tiles
// or levels. In the place of blocks without portals. With `wedges`, only those that lie on the
// floor and move along their slope.
void addRamps(Random& random, World& world, bool coarse, bool wedges = false);

}  // namespace slicecast::judge

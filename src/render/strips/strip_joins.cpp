// Which see-through blocks join: faces between touching ones of one kind are left out, also if a
// portal lies between.
#include "render/strips/strip_meet.h"

#include "render/spans/plan_walk.h"

namespace slicecast {
namespace {

// Only a block that reaches the end of its level can touch the one above it, or below.
bool reachesEnd(const CellBlueprint& blueprint, int up) {
    return up > 0 ? blueprint.fillsUp() : blueprint.fillsDown();
}

// The block of a cell if it joins `block`, else null.
__attribute__((noinline)) const CellBlueprint* joinedAt(const StripTile& tile, const Block& block,
                                                        const Map& map, int x, int y, int level) {
    const World& world = *tile.view.frame.world;
    const CellBlueprint& neighbour = world.blueprints[map.cell(x, y, level)];
    return areJoined(world, *block.blueprint, neighbour) ? &neighbour : nullptr;
}

// Whether the part's height clip ends the block above, or below.
bool isClipped(const StripTile& tile, const Block& block, int up) {
    const HeightClip& clip = tile.view.clip;
    return up > 0 ? block.top == clip.high : block.bottom == clip.low;
}

}  // namespace

const CellBlueprint* joinedBeyond(const StripTile& tile, const Block& block, const Map& map, int x,
                                  int y, int level) {
    const CellBlueprint* const joined = joinedAt(tile, block, map, x, y, level);
    return joined != nullptr && joined->isBox() && block.blueprint->isBox() ? joined : nullptr;
}

const CellBlueprint* joinedBeyond(const StripTile& tile, const Block& block, const Portal& portal,
                                  int level) {
    const Map& map = tile.view.frame.world->maps[static_cast<std::size_t>(portal.toMap)];
    return joinedBeyond(tile, block, map, portal.toX, portal.toY, level + portal.levels);
}

const CellBlueprint* joinedBefore(const StripTile& tile, const Block& block,
                                  const CrossingLanes& at, Lanes& lanes) {
    if (tile.stretch.enters == End::edge) return nullptr;
    const Before& before = tile.view.before;
    if (tile.isArrival())
        return joinedBeyond(tile, block, *before.map, before.x, before.y,
                            block.level - before.levels);
    return joinedNear(tile, block, at, Border::enter, lanes);
}

const CellBlueprint* joinedNear(const StripTile& tile, const Block& block, const CrossingLanes& at,
                                Border border, Lanes& lanes) {
    const PartView& view = tile.view;
    const World& world = *view.frame.world;
    const bool isAhead = border == Border::leave;
    const auto place = tile.beyond(at, border);
    const int x = place.first;
    const int y = place.second;
    const CellBlueprint* joined = joinedAt(tile, block, *view.map, x, y, block.level);
    if (joined == nullptr && block.blueprint->mover >= 0) {
        const CellBlueprint& next = view.blueprintAt(x, y, block.level);
        if (areOneAlong(world, *block.blueprint, next, at.alongX ? Axis::x : Axis::y))
            joined = &next;
    }
    if (joined == nullptr || joined->plan.isWhole()) return joined;
    unsigned touched = 0;
    eachLane(bitsOf(lanes), [&](int i) {
        const SliceColumn& column = tile.columns[indexOf(i)];
        const PlanWalk plans(column.walk, view.vista->viewpoint, column.ray);
        if (plans.touches(joined->plan, x, y, tile.crossingOf(i, border), isAhead))
            touched |= 1u << i;
    });
    lanes = maskOf(touched);
    return joined;
}

bool goesOn(const StripTile& tile, const Block& block, int up) {
    const auto reaches = [](const CellBlueprint& blueprint, int end) {
        return end > 0 ? blueprint.goesUp() : blueprint.goesDown();
    };
    if (block.blueprint->mover < 0 || !reaches(*block.blueprint, up) ||
        tile.isAbsent(block.level + up) || isClipped(tile, block, up))
        return false;
    const CellBlueprint& next = tile.view.blueprintAt(tile.tileX(), tile.tileY(), block.level + up);
    return areOneMover(*block.blueprint, next) && reaches(next, -up);
}

bool joinsNext(const StripTile& tile, const Block& block, int up, bool leaving) {
    if (goesOn(tile, block, up)) return true;
    if (!reachesEnd(*block.blueprint, up) || !block.blueprint->join) return false;
    const auto touches = [&](const CellBlueprint* joined) {
        return joined != nullptr && reachesEnd(*joined, -up);
    };
    const PartView& view = tile.view;
    const int level = block.level + up;
    if (view.clipped && isClipped(tile, block, up)) {
        const Before& before = view.before;
        return tile.isArrival() && touches(joinedBeyond(tile, block, *before.map, before.x,
                                                        before.y, level - before.levels));
    }
    if (tile.isAbsent(level)) return false;
    const CellBlueprint& next = view.blueprintAt(tile.tileX(), tile.tileY(), level);
    const PortalId portal =
        reachesEnd(next, -up) ? next.face(up > 0 ? Face::bottom : Face::top).portal : kNoPortal;
    if (!leaving || !view.acts(portal, false))
        return touches(joinedAt(tile, block, *view.map, tile.tileX(), tile.tileY(), level));
    return touches(joinedBeyond(tile, block, view.frame.world->portals[portal], level));
}

}  // namespace slicecast

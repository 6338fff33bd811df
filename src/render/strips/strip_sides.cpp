// The sides of blocks.
#include "render/strips/strip_meet.h"

namespace slicecast {
namespace {

// Closes the rows of a side of columns that cross a border alike.
__attribute__((noinline)) void takeSide(StripTile& tile, Lanes lanes, const Block& block, Face face,
                                        Border at, Lanes first, Lanes last) {
    const std::span<const LaneRows> taken = tile.open.take(lanes, first, last);
    if (taken.empty()) return;
    const StripTile::SideViews& views = tile.viewsAt(at);
    const BlockSide side = sideOf(tile.view, block, face, tile.here(), false);
    for (const auto& [i, from, to] : taken)
        tile.column(i).addSide(side, views[indexOf(i)], from, to);
}

__attribute__((noinline)) void seeRows(StripTile& tile, Lanes lanes, const BlockSide& side,
                                       Border at, Lanes first, Lanes last) {
    const unsigned bits = bitsOf(lanes & (first < last));
    if (bits == 0) return;
    const StripTile::SideViews& views = tile.viewsAt(at);
    const LaneValues from(first);
    const LaneValues to(last);
    eachLane(bits, [&](int i) {
        if (tile.column(i).isFull()) return;
        tile.open.write(i);
        tile.column(i).seeThroughSide(side, views[indexOf(i)], from.at[i], to.at[i]);
        // Opaque texels have closed rows
        tile.open.read(i);
    });
}

// Adds layers of a side by which columns enter or leave a see-through block, except where it
// touches a joined block.
void seeUnjoined(StripTile& tile, const CrossingLanes& crossing, const Block& block,
                 const CellBlueprint* joined, Lanes touching, Border at, Lanes first, Lanes last) {
    const CellBlueprint& own = *block.blueprint;
    const bool entering = at == Border::enter;
    const Face face = entering ? enteredFace(crossing.crossing()) : leftFace(crossing.crossing());
    const BlockSide side = sideOf(tile.view, block, face, tile.here(), true);
    if (joined == nullptr) return seeRows(tile, crossing.lanes, side, at, first, last);
    seeRows(tile, crossing.lanes & ~touching, side, at, first, last);
    if (joined->slopes.any() || own.slopes.any()) {
        const auto [x, y] = tile.beyond(crossing, at);
        const Lanes top = rowsOfFace(tile, *joined, Face::top, x, y, block.level, at);
        const Lanes bottom = rowsOfFace(tile, *joined, Face::bottom, x, y, block.level, at);
        const Lanes isHidden = top < bottom;
        seeRows(tile, touching & ~isHidden, side, at, first, last);
        seeRows(tile, touching & isHidden, side, at, first, lesser(last, top));
        return seeRows(tile, touching & isHidden, side, at, greater(first, bottom), last);
    }
    const std::int32_t base = tile.view.baseOf(block.level);
    if (joined->top < own.top)
        seeRows(tile, touching, side, at, first,
                lesser(last, tile.rowsBelow(base + joined->top.raw, at)));
    if (joined->bottom > own.bottom)
        seeRows(tile, touching, side, at,
                greater(first, tile.rowsBelow(base + joined->bottom.raw, at)), last);
}

void enterThroughSide(StripTile& tile, const CrossingLanes& crossing, const Block& block,
                      Lanes first, Lanes last) {
    Lanes touching = crossing.lanes;
    const CellBlueprint* const joined = joinedBefore(tile, block, crossing, touching);
    seeUnjoined(tile, crossing, block, joined, touching, Border::enter, first, last);
}

// Behind the side there may be a portal of the whole tile, or of a block's face, which may be
// smaller than the side.
void leaveThroughSide(StripTile& tile, const CrossingLanes& crossing, const Block& block,
                      Lanes first, Lanes last) {
    const PartView& view = tile.view;
    const World& world = *view.frame.world;
    Lanes touching = crossing.lanes;
    const auto see = [&](const CellBlueprint* joined, Lanes from, Lanes to) {
        seeUnjoined(tile, crossing, block, joined, touching, Border::leave, from, to);
    };
    if (tile.stretch.leaves == End::edge) return see(nullptr, first, last);
    const auto [x, y] = tile.beyond(crossing, Border::leave);
    const bool mayPass = view.portals < world.portalLimit;
    const auto joinedThrough = [&](PortalId portal) {
        return joinedBeyond(tile, block, world.portals[portal], block.level);
    };
    if (const PortalId portal = view.map->tilePortal(x, y); portal != kNoPortal)
        return see(mayPass ? joinedThrough(portal) : nullptr, first, last);
    const CellBlueprint& behind = view.blueprintAt(x, y, block.level);
    const PortalId portal = behind.face(enteredFace(crossing.crossing())).portal;
    if (portal == kNoPortal || !mayPass) {
        const CellBlueprint* const joined =
            joinedNear(tile, block, crossing, Border::leave, touching);
        return see(joined, first, last);
    }
    const CellBlueprint* const joined = joinedThrough(portal);
    if (joined == nullptr) return see(nullptr, first, last);
    const std::int32_t base = view.baseOf(block.level);
    const Lanes top = tile.rowsBelow(base + behind.top.raw, Border::leave);
    const Lanes bottom = tile.rowsBelow(base + behind.bottom.raw, Border::leave);
    see(nullptr, first, lesser(last, top));
    see(joined, greater(first, top), lesser(last, bottom));
    see(nullptr, greater(first, bottom), last);
}

}  // namespace

void enterSide(StripTile& tile, const Block& block, Lanes first, Lanes last) {
    if (!tile.entersAt(block.level)) return;
    const Lanes seen = tile.seen(first, last);
    if (bitsOf(seen) == 0) return;
    for (CrossingLanes crossing : tile.crossings(Border::enter)) {
        crossing.lanes = crossing.lanes & seen;
        if (bitsOf(crossing.lanes) == 0) continue;
        const Face face = enteredFace(crossing.crossing());
        const PortalId portal = block.blueprint->face(face).portal;
        if (tile.view.acts(portal, tile.isArrival())) {
            sendThrough(tile, portal, crossing.lanes, first, last, {});
        } else if (!tile.stretch.entersAhead) {
            continue;
        } else if (!block.blueprint->seeThrough) {
            takeSide(tile, crossing.lanes, block, face, Border::enter, first, last);
        } else if (tile.view.isThere(block, face)) {
            enterThroughSide(tile, crossing, block, first, last);
        }
    }
}

void leaveSide(StripTile& tile, const Block& block, Lanes first, Lanes last) {
    if (!tile.leavesAt(block.level) || !tile.stretch.leavesAhead) return;
    const Lanes seen = tile.seen(first, last);
    if (bitsOf(seen) == 0) return;
    for (CrossingLanes crossing : tile.crossings(Border::leave)) {
        crossing.lanes = crossing.lanes & seen;
        if (bitsOf(crossing.lanes) == 0) continue;
        const Face face = leftFace(crossing.crossing());
        if (block.blueprint->face(face).portal != kNoPortal) continue;
        if (!block.blueprint->seeThrough) {
            takeSide(tile, crossing.lanes, block, face, Border::leave, first, last);
        } else if (tile.view.isThere(block, face)) {
            leaveThroughSide(tile, crossing, block, first, last);
        }
    }
}

}  // namespace slicecast

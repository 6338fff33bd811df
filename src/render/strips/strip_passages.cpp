// Where columns continue elsewhere: behind portals. A portal acts only on rays that enter the
// block; seen from inside the block, its face shows nothing.
#include "render/strips/strip_meet.h"

namespace slicecast {

bool actsAtTop(const StripTile& tile, const Block& block) {
    return tile.view.acts(block.blueprint->face(Face::top).portal,
                          tile.isArrival() && block.top == tile.view.clip.high);
}

bool actsAtBottom(const StripTile& tile, const Block& block) {
    return tile.view.acts(block.blueprint->face(Face::bottom).portal,
                          tile.isArrival() && block.bottom == tile.view.clip.low);
}

void sendThrough(StripTile& tile, PortalId id, Lanes mask, Lanes first, Lanes last,
                 const HeightClip& clip) {
    const PartView& view = tile.view;
    const Portal& portal = view.frame.world->portals[id];
    const std::int32_t floorRise = -throughPortal(view.vista->viewpoint, portal).z;
    const bool isSide = !clip.any();
    // Rays through a roof or an underside all come out at the height of the clip
    const std::int32_t height = clip.high != HeightClip{}.high ? clip.high : clip.low;
    const bool isBelow = height < floorRise || (height == 0 && floorRise == 0);
    const LaneValues hazeRows(isSide ? tile.rowsBelow(floorRise, Border::enter)
                                     : inAllLanes(isBelow ? 0 : view.projection->height));
    Vista* beyond = nullptr;
    for (const auto& [i, from, to] : tile.open.take(mask, first, last)) {
        if (beyond == nullptr) beyond = &view.frame.vistas.through(*view.vista, portal);
        SliceColumn& column = tile.column(i);
        tile.place(i);
        Before before = {view.map, tile.tileX(), tile.tileY(), portal.levels};
        const Crossing enter = tile.crossingOf(i, Border::enter);
        if (isSide && enter.border)
            (enter.alongX ? before.x : before.y) -=
                enter.alongX ? column.walk.stepX : column.walk.stepY;
        column.sendThrough(id, *beyond, from, to, hazeRows.at[i], clip, before);
    }
}

void enterPortalTile(StripTile& tile) {
    const PartView& view = tile.view;
    endCeiling(tile, tile.mask, Border::enter);
    takeFloor(tile, tile.mask, Border::enter);
    const PortalId id = view.map->tilePortal(tile.tileX(), tile.tileY());
    // Rays that have met the floor beyond `far` do not get here
    if (view.acts(id, tile.isArrival()))
        sendThrough(tile, id, tile.mask, inAllLanes(0),
                    tile.rowsBelow(view.floorRise, Border::enter), {});
    for (const auto& [i, first, last] :
         tile.open.take(tile.mask, inAllLanes(0), inAllLanes(view.projection->height)))
        tile.column(i).add(SliceColumn::What::haze, first, last);
    eachLane(bitsOf(tile.mask), [&](int i) { tile.column(i).endInPortal(); });
}

}  // namespace slicecast

// Floor and ceiling, which continue from tile to tile until they change.
#include "render/slice_walk.h"

#include <algorithm>

namespace slicecast {

// Closes the rows that have met the floor before a border; the floor continues behind it. Leaves
// rows beyond the map's `far` to the haze.
void SliceWalk::takeFloor(Border upTo) {
    const TileRange tiles = {floor_.fromX, floor_.fromY, beforeX(upTo), beforeY(upTo), false};
    takeFloorRows(rowBelow(floorRise_, upTo), tiles);
    floor_.fromX = behindX(upTo);
    floor_.fromY = behindY(upTo);
}

// The endless floor from the current tile on, down to `row`, the first one below the floor.
void SliceWalk::takeFloorBeyond(int row) {
    takeFloorRows(row, {floor_.fromX, floor_.fromY, walk_.tileX, walk_.tileY, true});
}

void SliceWalk::takeFloorRows(int row, const TileRange& tiles) {
    for (const auto& [first, last] :
         open_.take(std::max(row, vista_->firstFloorRow), projection_->height))
        addFloor(first, last, tiles);
}

// Floor that continues from tile to tile is one span.
void SliceWalk::addFloor(int first, int last, const TileRange& tiles) {
    if (floorMirror_ > 0) mirror(floorRise_, first, last, floorMirror_, map_->floor.ripples);
    if (Span* const before = floorSpan_ == kNone ? nullptr : &found_->spans[floorSpan_];
        before != nullptr && before->first == last &&
        before->look->plane.texture == floor_.texture) {
        before->first = first;
        before->tiles.toX = tiles.toX;
        before->tiles.toY = tiles.toY;
        before->tiles.endless = tiles.endless;
        return;
    }
    floorSpan_ = found_->spans.count();
    PlaneLook& look = lookOf(
        {floorRise_, floor_.texture, map_->floor.light, map_->floor.glow, false, floorMirror_ > 0});
    addPlane(What::floor, look, first, last, tiles);
}

// Starts a run of ceiling at the current tile.
void SliceWalk::startCeiling(TextureId texture) {
    ceiling_.texture = texture;
    ceiling_.row = rowBelow(ceilingRise_, enter_);
    ceiling_.fromX = walk_.tileX;
    ceiling_.fromY = walk_.tileY;
}

// Closes the rows that have met the run of ceiling up to a border, if there is one. A ceiling at
// the eye's own height is invisible.
void SliceWalk::endCeiling(Border at) {
    if (ceiling_.texture != kNoTexture && ceilingRise_ != 0) {
        const int row = rowBelow(ceilingRise_, at);
        const int firstRow = std::min(ceiling_.row, row);
        const int lastRow = std::max(ceiling_.row, row);
        const Plane plane = {
            ceilingRise_, ceiling_.texture, map_->ceiling.light, map_->ceiling.glow, true, false};
        const TileRange tiles = {ceiling_.fromX, ceiling_.fromY, beforeX(at), beforeY(at), false};
        if (frame_.textures[ceiling_.texture].seeThrough) {
            seeThroughPlane(What::ceiling, plane, firstRow, lastRow, tiles);
        } else {
            for (const auto& [first, last] : open_.take(firstRow, lastRow))
                addPlane(What::ceiling, lookOf(plane), first, last, tiles);
        }
    }
    ceiling_.texture = kNoTexture;
}

}  // namespace slicecast

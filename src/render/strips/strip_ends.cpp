// What columns meet outside the grid, and how their parts end there, or where nothing more can be
// met: there is only the floor, for ever, with objects on it, and the sky.
#include "render/strips/strip_walk.h"

#include <algorithm>

namespace slicecast {

// Whether only the floor and the sky can be met from there on: see PartView::whereToStop.
bool StripWalk::isBeyond(double along) const {
    return along > view_.whereToStop(open_.first(), open_.last());
}

// Whether a column does not touch the grid in the slab.
bool StripWalk::isOutside(int i) const {
    const int near = nearV_.at[i];
    const int far = farV_.at[i];
    return tile_.u < 0 || tile_.u >= rays_.sizeU || (near < 0 && far < 0) ||
           (near >= rays_.sizeV && far >= rays_.sizeV);
}

// The columns that leave the grid within the slab, or go away from it.
unsigned StripWalk::leavingSideways() const {
    unsigned bits = 0;
    eachLane(open_.live(), [&](int i) {
        const int far = farV_.at[i];
        const int step = rays_.stepV[indexOf(i)];
        if ((far < 0 && step <= 0) || (far >= rays_.sizeV && step >= 0)) bits |= 1u << i;
    });
    return bits;
}

// The floor of a column from where its run began, for ever: at least to the tile behind its last
// one of the slab.
TileRange StripWalk::endlessFrom(int i) const {
    const int fromU = tile_.cover.floorFromU.at[i];
    const int fromV = tile_.cover.floorFromV.at[i];
    int u = fromU;
    int v = fromV;
    if (!isOutside(i)) {
        const bool isU = farV_.at[i] >= 0 && farV_.at[i] < rays_.sizeV;
        u = tile_.u + (isU ? rays_.stepU : 0);
        v = farV_.at[i];
    }
    return rays_.alongX ? TileRange{fromU, fromV, u, v, true} : TileRange{fromV, fromU, v, u, true};
}

// Ends the parts of some columns behind their last tile of the slab; `isOut` if they leave the
// grid there.
void StripWalk::endBeyond(unsigned bits, bool isOut) {
    if (bits == 0) return;
    for (unsigned rest = bits; rest != 0;) {
        const int lead = __builtin_ctz(rest);
        const auto lastOf = [&](int i) { return std::clamp<int>(farV_.at[i], 0, rays_.sizeV - 1); };
        unsigned together = 0;
        eachLane(rest, [&](int i) {
            if (lastOf(i) == lastOf(lead) && isOutside(i) == isOutside(lead)) together |= 1u << i;
        });
        rest &= ~together;
        if (!isOutside(lead)) endCover(together, lastOf(lead), isOut);
        eachLane(together, [&](int i) {
            SliceColumn& column = columns_[indexOf(i)];
            open_.write(i);
            column.endBeyond(static_cast<TextureId>(tile_.cover.floor.at[i]), endlessFrom(i));
        });
    }
    open_.close(bits);
    open_.findEnds();
    tile_.cover.changed = true;
}

// The ceiling ends with the grid; the floor goes on as the map's own.
void StripWalk::endCover(unsigned bits, int v, bool isOut) {
    crossing(v);
    tile_.enter(bits);
    endCeiling(tile_, tile_.mask, Border::leave);
    const Lanes ground = inAllLanes(view_.map->floor.texture);
    const Lanes other = tile_.mask & ~(tile_.cover.floor.lanes() == ground);
    if (isOut && bitsOf(other) != 0) {
        takeFloor(tile_, other, Border::leave);
        tile_.cover.floor = LaneValues(chosen(other, ground, tile_.cover.floor.lanes()));
    }
    eachLane(bits, [&](int i) { countTiles(i, v); });
}

// Meets the objects of the slab that stand outside the grid, on the way to it.
void StripWalk::meetObjectsOutside() {
    if (!(tile_.far * rays_.alongPerUMost > nextObject_)) return;
    eachLane(open_.live(), [&](int i) {
        const int near = nearV_.at[i];
        const bool isInGrid = tile_.u >= 0 && tile_.u < rays_.sizeU;
        if (isInGrid && near >= 0 && near < rays_.sizeV) return;
        SliceColumn& column = columns_[indexOf(i)];
        double to = tile_.far / rays_.speedU[indexOf(i)];
        if (isInGrid && !isOutside(i))
            to = std::min(to, rays_.entersV(near < 0 ? 0 : rays_.sizeV - 1, near < 0) /
                                  rays_.speedV[indexOf(i)]);
        if (!(column.objects.nextAlong() < to)) return;
        open_.write(i);
        column.meetObjectsBefore(to, static_cast<TextureId>(tile_.cover.floor.at[i]),
                                 endlessFrom(i));
        open_.read(i);
        tile_.cover.changed = true;
    });
    noticeChange(open_.live());
}

}  // namespace slicecast

// Floor and ceiling, which continue from tile to tile until they change.
#include "render/strips/strip_meet.h"

namespace slicecast {
namespace {

// From a tile to the one before a border of the current one.
TileRange rangeTo(const StripTile& tile, int lane, Border at, int fromU, int fromV) {
    int u = tile.u;
    int v = tile.v;
    if (at == Border::enter && tile.stretch.enters == End::border) {
        if (bitsOf(tile.enteredAlongU) >> lane & 1) {
            u -= tile.rays.stepU;
        } else {
            v -= tile.rays.stepV[indexOf(lane)];
        }
    }
    return tile.rays.alongX ? TileRange{fromU, fromV, u, v, false}
                            : TileRange{fromV, fromU, v, u, false};
}

void startCeiling(StripTile& tile, Lanes mask, TextureId texture, Lanes rows) {
    StripCover& cover = tile.cover;
    cover.ceiling = LaneValues(chosen(mask, inAllLanes(texture), cover.ceiling.lanes()));
    cover.ceilingRow = LaneValues(chosen(mask, rows, cover.ceilingRow.lanes()));
    cover.ceilingFromU = LaneValues(chosen(mask, inAllLanes(tile.u), cover.ceilingFromU.lanes()));
    cover.ceilingFromV = LaneValues(chosen(mask, inAllLanes(tile.v), cover.ceilingFromV.lanes()));
}

// Closes the rows that have met the runs of ceiling of some columns up to a border; `rows` are the
// ceiling's rows there. A ceiling at the eye's own height is invisible.
__attribute__((noinline)) void takeCeiling(StripTile& tile, Lanes mask, Lanes rows, Border at) {
    const PartView& view = tile.view;
    const StripCover& cover = tile.cover;
    const unsigned bits = bitsOf(mask & ~(cover.ceiling.lanes() == inAllLanes(kNoTexture)));
    if (bits == 0 || view.ceilingRise == 0) return;
    const Lanes first = lesser(cover.ceilingRow.lanes(), rows);
    const Lanes last = greater(cover.ceilingRow.lanes(), rows);
    const auto planeOf = [&](int i) {
        return Plane{view.ceilingRise,
                     static_cast<TextureId>(cover.ceiling.at[i]),
                     view.map->ceiling.light,
                     view.map->ceiling.glow,
                     true,
                     false};
    };
    const auto tilesOf = [&](int i) {
        return rangeTo(tile, i, at, cover.ceilingFromU.at[i], cover.ceilingFromV.at[i]);
    };
    unsigned layers = 0;
    eachLane(bits, [&](int i) {
        if (!view.frame.textures[static_cast<TextureId>(cover.ceiling.at[i])].seeThrough) return;
        layers |= 1u << i;
        tile.open.write(i);
        tile.column(i).seeThroughPlane(SliceColumn::What::ceiling, planeOf(i),
                                       LaneValues(first).at[i], LaneValues(last).at[i], tilesOf(i));
    });
    for (const auto& [i, from, to] : tile.open.take(maskOf(bits & ~layers), first, last))
        tile.column(i).addPlane(SliceColumn::What::ceiling, view.lookOf(planeOf(i)), from, to,
                                tilesOf(i));
}

}  // namespace

// Where floor or ceiling changes, its run ends at the border: the ceiling's before the floor's.
void changeCover(StripTile& tile, TextureId floor, TextureId ceiling) {
    StripCover& cover = tile.cover;
    const Lanes otherFloor = tile.mask & ~(cover.floor.lanes() == inAllLanes(floor));
    const Lanes changed =
        otherFloor | (tile.mask & ~(cover.ceiling.lanes() == inAllLanes(ceiling)));
    if (bitsOf(changed) == 0) return;
    cover.changed = true;
    if (ceiling != kNoTexture || cover.onlyCeiling != kNoTexture) {
        const Lanes rows = tile.rowsBelow(tile.view.ceilingRise, Border::enter);
        takeCeiling(tile, changed, rows, Border::enter);
        startCeiling(tile, changed, ceiling, rows);
    }
    if (bitsOf(otherFloor) == 0) return;
    takeFloor(tile, otherFloor, Border::enter);
    cover.floor = LaneValues(chosen(otherFloor, inAllLanes(floor), cover.floor.lanes()));
}

// Closes the rows that have met the floor before a border; the floor continues behind it. Leaves
// rows beyond the map's `far` to the haze.
__attribute__((noinline)) void takeFloor(StripTile& tile, Lanes mask, Border at) {
    const PartView& view = tile.view;
    StripCover& cover = tile.cover;
    const Lanes rows =
        greater(tile.rowsBelow(view.floorRise, at), inAllLanes(view.vista->firstFloorRow));
    for (const auto& [i, first, last] :
         tile.open.take(mask, rows, inAllLanes(view.projection->height)))
        tile.column(i).addFloor(
            static_cast<TextureId>(cover.floor.at[i]), first, last,
            rangeTo(tile, i, at, cover.floorFromU.at[i], cover.floorFromV.at[i]));
    Lanes nextU = inAllLanes(tile.u);
    Lanes nextV = inAllLanes(tile.v);
    if (at == Border::leave && tile.stretch.leaves == End::border) {
        const Lanes alongU = tile.leftAlongU;
        nextU = chosen(alongU, inAllLanes(tile.u + tile.rays.stepU), nextU);
        nextV = chosen(alongU, nextV, nextV + tile.rays.stepsV);
    }
    cover.floorFromU = LaneValues(chosen(mask, nextU, cover.floorFromU.lanes()));
    cover.floorFromV = LaneValues(chosen(mask, nextV, cover.floorFromV.lanes()));
}

void endCeiling(StripTile& tile, Lanes mask, Border at) {
    StripCover& cover = tile.cover;
    const Lanes there = mask & ~(cover.ceiling.lanes() == inAllLanes(kNoTexture));
    if (bitsOf(there) == 0) return;
    takeCeiling(tile, there, tile.rowsBelow(tile.view.ceilingRise, at), at);
    cover.ceiling = LaneValues(chosen(there, inAllLanes(kNoTexture), cover.ceiling.lanes()));
    cover.changed = true;
}

void takeCeilingHere(StripTile& tile, TextureId texture) {
    startCeiling(tile, tile.mask, texture, tile.rowsBelow(tile.view.ceilingRise, Border::enter));
    endCeiling(tile, tile.mask, Border::leave);
}

}  // namespace slicecast

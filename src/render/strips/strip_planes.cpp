// Roofs and undersides.
#include "render/strips/strip_meet.h"

namespace slicecast {
namespace {

// Closes the rows of a roof or an underside.
__attribute__((noinline)) void takePlane(StripTile& tile, const Block& block, Face face,
                                         Lanes first, Lanes last, bool fromInside = false) {
    const PartView& view = tile.view;
    const bool isTop = face == Face::top;
    const FaceBlueprint& shown = block.blueprint->face(face);
    const int strength = isTop && !fromInside ? view.mirrorStrength(shown.mirror) : 0;
    PlaneLook* look = nullptr;
    for (const auto& [i, from, to] : tile.open.take(tile.mask, first, last)) {
        SliceColumn& column = tile.column(i);
        if (look == nullptr) {
            Plane plane = view.planeOf(block, face);
            plane.mirror = strength > 0;
            look = &view.lookOf(plane);
        }
        if (strength > 0) column.mirror(block.top, from, to, strength, shown.ripples);
        column.addFace(isTop ? SliceColumn::What::roof : SliceColumn::What::underside, *look, from,
                       to, tile.here(), block.level);
    }
}

// Adds the layer of a roof or an underside.
__attribute__((noinline)) void seePlane(StripTile& tile, const Block& block, Face face, Lanes first,
                                        Lanes last, bool leaving) {
    const bool isTop = face == Face::top;
    const PartView& view = tile.view;
    if (!view.isThere(block, face) || joinsNext(tile, block, isTop ? 1 : -1, leaving)) return;
    const unsigned bits = bitsOf(tile.seen(first, last));
    if (bits == 0) return;
    const Plane plane = view.planeOf(block, face);
    const LaneValues from(first);
    const LaneValues to(last);
    eachLane(bits, [&](int i) {
        if (tile.column(i).isFull()) return;
        tile.open.write(i);
        tile.column(i).seeThroughPlane(
            isTop ? SliceColumn::What::roof : SliceColumn::What::underside, plane, from.at[i],
            to.at[i], tile.here(), block.level);
    });
}

}  // namespace

void enterTop(StripTile& tile, const Block& block, Lanes first, Lanes last) {
    const FaceBlueprint& look = block.blueprint->face(Face::top);
    if (actsAtTop(tile, block)) {
        HeightClip below;
        below.high = block.top;
        sendThrough(tile, look.portal, tile.mask, first, last, below);
    } else if (block.blueprint->seeThrough &&
               (tile.view.mirrorStrength(look.mirror) == 0 || joinsNext(tile, block, 1, false))) {
        seePlane(tile, block, Face::top, first, last, false);
    } else {
        takePlane(tile, block, Face::top, first, last);
    }
}

void enterBottom(StripTile& tile, const Block& block, Lanes first, Lanes last) {
    if (actsAtBottom(tile, block)) {
        HeightClip above;
        above.low = block.bottom;
        sendThrough(tile, block.blueprint->face(Face::bottom).portal, tile.mask, first, last,
                    above);
    } else if (block.blueprint->seeThrough) {
        seePlane(tile, block, Face::bottom, first, last, false);
    } else {
        takePlane(tile, block, Face::bottom, first, last);
    }
}

void leavePlane(StripTile& tile, const Block& block, Face face, Lanes first, Lanes last) {
    if (block.blueprint->face(face).portal != kNoPortal) return;
    if (block.blueprint->seeThrough) {
        seePlane(tile, block, face, first, last, true);
    } else if (!goesOn(tile, block, face == Face::top ? 1 : -1)) {
        takePlane(tile, block, face, first, last, true);
    }
}

}  // namespace slicecast

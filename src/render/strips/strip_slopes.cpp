// Blocks with slopes. Rays above a top that end up below it in the tile have entered the block, and
// rays that do the reverse have left it, whether they rise or fall: a block may show its roof and
// its underside.
//
// A mirror's rays are walked from the eye on. Below the mirror's height they are still on their way
// to it, and meet nothing; in the mirror's own tile, blocks are wholly above it or below.
#include "render/strips/strip_meet.h"

#include "render/spans/sloped_plane.h"

namespace slicecast {
namespace {

SlopedPlane planeOf(const StripTile& tile, const CellBlueprint& block, Face face, int x, int y,
                    int level, int lane) {
    const PartView& view = tile.view;
    return {block.slopes,
            block.slopes.of(face),
            x,
            y,
            view.baseOf(level),
            view.vista->viewpoint,
            tile.columns[indexOf(lane)].ray,
            *view.projection};
}

// Finds where a face is met: between its rows at the two borders.
__attribute__((noinline)) FaceOfSlopes faceOfSlopes(const StripTile& tile, const Block& block,
                                                    Face face) {
    FaceOfSlopes found;
    found.face = face;
    found.isSloped = !block.blueprint->slopes.of(face).isLevel();
    if (!found.isSloped) {
        const std::int32_t rise = face == Face::top ? block.top : block.bottom;
        found.atEnter = tile.rowsBelow(rise, Border::enter);
        found.atLeave = tile.rowsBelow(rise, Border::leave);
        return found;
    }
    LaneValues enter(inAllLanes(0));
    LaneValues leave(inAllLanes(0));
    eachLane(bitsOf(tile.mask), [&](int i) {
        const SlopedPlane plane =
            planeOf(tile, *block.blueprint, face, tile.tileX(), tile.tileY(), block.level, i);
        const Projection& projection = *tile.view.projection;
        found.height = plane.height;
        found.horizon[indexOf(i)] = plane.horizon;
        enter.at[i] = inLane(firstRowBelow(projection, plane, tile.crossingOf(i, Border::enter)));
        leave.at[i] = inLane(firstRowBelow(projection, plane, tile.crossingOf(i, Border::leave)));
    });
    found.atEnter = enter.lanes();
    found.atLeave = leave.lanes();
    return found;
}

// Rays that enter an opaque block end there.
bool mayBeInside(const StripTile& tile, const Block& block) {
    return block.blueprint->seeThrough || block.blueprint->mover >= 0 || block.cut ||
           tile.isAtEye(block.level);
}

Lanes firstRowsNotReflected(const StripTile& tile, Border at) {
    const HeightClip& clip = tile.view.clip;
    return clip.isMirror ? tile.rowsBelow(clip.low, at) : inAllLanes(tile.view.projection->height);
}

// The first rows below a side's upper or lower end at a border.
Lanes endOfSide(const StripTile& tile, const Block& block, const FaceOfSlopes& face, Border at) {
    const Lanes rows = at == Border::enter ? face.atEnter : face.atLeave;
    if (face.face == Face::top)
        return block.blueprint->isCutAbove() ? greater(rows, tile.rowsBelow(block.top, at)) : rows;
    return block.blueprint->isCutBelow() ? lesser(rows, tile.rowsBelow(block.bottom, at)) : rows;
}

// Leaves the rows in which a part of a moving block has a slope: elsewhere other parts have it.
void cutToPart(const StripTile& tile, const Block& block, Face face, bool isDownwards, Lanes& first,
               Lanes& last) {
    const Slant& slant = block.blueprint->slopes.of(face);
    const bool isCutAbove = slant.most() > block.blueprint->top;
    const bool isCutBelow = slant.least() < block.blueprint->bottom;
    if (!isCutAbove && !isCutBelow) return;
    LaneValues from(first);
    LaneValues to(last);
    eachLane(bitsOf(tile.mask), [&](int i) {
        const SlopedPlane plane =
            planeOf(tile, *block.blueprint, face, tile.tileX(), tile.tileY(), block.level, i);
        int begin = from.at[i];
        int end = to.at[i];
        const auto keep = [&](std::int32_t rise, bool keepsBelow) {
            keepRowsAt(*tile.view.projection, plane, rise / 65536.0, keepsBelow, isDownwards, begin,
                       end);
        };
        if (isCutAbove) keep(block.top, true);
        if (isCutBelow) keep(block.bottom, false);
        from.at[i] = inLane(begin);
        to.at[i] = inLane(end);
    });
    first = from.lanes();
    last = to.lanes();
}

void takeSlope(StripTile& tile, const Block& block, const FaceOfSlopes& at, Lanes first,
               Lanes last) {
    PlaneLook* look = nullptr;
    const bool isLayer = block.blueprint->seeThrough;
    const auto add = [&](int i, int from, int to) {
        if (look == nullptr) {
            Plane plane = tile.view.planeOf(block, at.face);
            plane.rise = 0;
            plane.sloped = true;
            look = &tile.view.lookOf(plane);
        }
        Span& span = tile.column(i).addPlane(
            at.face == Face::top ? SliceColumn::What::roof : SliceColumn::What::underside, *look,
            from, to, tile.here());
        span.face = at.face;
        span.level = block.level;
        span.layer = isLayer;
        span.slope = {at.height, at.horizon[indexOf(i)]};
    };
    if (!isLayer) {
        for (const auto& [i, from, to] : tile.open.take(tile.mask, first, last)) add(i, from, to);
        return;
    }
    const LaneValues from(first);
    const LaneValues to(last);
    eachLane(bitsOf(tile.seen(first, last)), [&](int i) {
        if (tile.column(i).isFull()) return;
        tile.open.write(i);
        for (const auto& [begin, end] : tile.column(i).open.within(from.at[i], to.at[i])) {
            if (!tile.column(i).countLayer()) return;
            add(i, begin, end);
        }
    });
}

// Takes the rows that enter a block through a face, or leave it.
__attribute__((noinline)) void passFace(StripTile& tile, const Block& block, const FaceOfSlopes& at,
                                        bool leaving) {
    const bool isTop = at.face == Face::top;
    const bool isDownwards = isTop != leaving;
    Lanes first = isDownwards ? at.atLeave : at.atEnter;
    Lanes last = isDownwards ? at.atEnter : at.atLeave;
    if (!at.isSloped) {
        const std::int32_t rise = isTop ? block.top : block.bottom;
        if (rise == 0 || isDownwards != (rise < 0)) return;
        const Lanes horizon = inAllLanes(tile.view.projection->firstFallingRow);
        (isDownwards ? first : last) =
            isDownwards ? greater(first, horizon) : lesser(last, horizon);
        if (goesOn(tile, block, isTop ? 1 : -1)) return;
    } else if (at.height == 0.0) {
        return;  // it is met at depth 0
    } else {
        cutToPart(tile, block, at.face, isDownwards, first, last);
    }
    last = lesser(last, firstRowsNotReflected(tile, Border::leave));
    if (bitsOf(tile.seen(first, last)) == 0) return;
    if (at.isSloped) return takeSlope(tile, block, at, first, last);
    if (leaving) return leavePlane(tile, block, at.face, first, last);
    if (isTop) return enterTop(tile, block, first, last);
    if (!block.cut) enterBottom(tile, block, first, last);
}

}  // namespace

Lanes rowsOfFace(const StripTile& tile, const CellBlueprint& block, Face face, int x, int y,
                 int level, Border at) {
    const Slant& slant = block.slopes.of(face);
    const Lanes ends = tile.rowsBelow(
        tile.view.baseOf(level) + (face == Face::top ? block.top : block.bottom).raw, at);
    if (slant.isLevel()) return ends;
    LaneValues rows(inAllLanes(0));
    eachLane(bitsOf(tile.mask), [&](int i) {
        rows.at[i] =
            inLane(firstRowBelow(*tile.view.projection, planeOf(tile, block, face, x, y, level, i),
                                 tile.crossingOf(i, at)));
    });
    if (face == Face::top) return block.isCutAbove() ? greater(rows.lanes(), ends) : rows.lanes();
    return block.isCutBelow() ? lesser(rows.lanes(), ends) : rows.lanes();
}

__attribute__((noinline)) MetSlopes enterSlopes(StripTile& tile, const Block& block) {
    const MetSlopes met = {faceOfSlopes(tile, block, Face::top),
                           faceOfSlopes(tile, block, Face::bottom)};
    enterSide(tile, block, endOfSide(tile, block, met.top, Border::enter),
              lesser(endOfSide(tile, block, met.bottom, Border::enter),
                     firstRowsNotReflected(tile, Border::enter)));
    if (!met.top.isSloped) passFace(tile, block, met.top, false);
    if (!met.bottom.isSloped) passFace(tile, block, met.bottom, false);
    return met;
}

void passSlopes(StripTile& tile, const Block& block, const MetSlopes& met) {
    if (met.top.isSloped) passFace(tile, block, met.top, false);
    if (met.bottom.isSloped) passFace(tile, block, met.bottom, false);
    if (!mayBeInside(tile, block)) return;
    passFace(tile, block, met.top, true);
    passFace(tile, block, met.bottom, true);
    leaveSide(tile, block, endOfSide(tile, block, met.top, Border::leave),
              lesser(endOfSide(tile, block, met.bottom, Border::leave),
                     firstRowsNotReflected(tile, Border::leave)));
}

}  // namespace slicecast

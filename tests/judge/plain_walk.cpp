#include "plain_walk.h"

#include "base/sort.h"

#include <algorithm>
#include <cstdlib>

namespace slicecast {

void PlainWalk::find(int column, SliceSpans& found) {
    column_ = column;
    found.column = column;
    found.upright.clear();
    found.reflected.clear();
    found_ = &found.upright;
    Vista& vista = frame_.vistas.ofEye();
    const GridWalk start({static_cast<std::int32_t>(vista.viewpoint.x)},
                         {static_cast<std::int32_t>(vista.viewpoint.y)}, vista.ray(column));
    Parts::addRows(found_->parts.find(vista, start, {}, {}, 0, 0), 0, vista.projection->height);
    walkParts();
    reflect(found);
}

// Walking a part may add more parts.
void PlainWalk::walkParts() {
    for (number_ = 0; number_ < static_cast<int>(found_->parts.count()); ++number_) {
        part_ = found_->parts[static_cast<std::size_t>(number_)];
        walkPart();
        Part& part = found_->parts[static_cast<std::size_t>(number_)];
        part.tiles = part_.tiles;
        part.endsInPortal = part_.endsInPortal;
    }
}

void PlainWalk::walkPart() {
    open_.openOnly(part_.rows, projection().height);
    walk_ = part_.walk;
    findObjects();
    for (;; walk_.advance()) {
        enter_ = walk_.enter();
        leave_ = walk_.leave();
        if (open_.none() || (isGridLeft() && objects_.empty())) break;
        ++part_.tiles;
        // A portal tile does not act on an eye inside it, nor on rays that arrive in it
        const PortalId portal = map().tilePortal(walk_.tileX, walk_.tileY);
        if (part_.tiles > 1 && portal != kNoPortal) {
            part_.endsInPortal = true;
            const Rows aboveFloor = {0, rowBelow(riseOf(0), enter_)};
            if (mayPass()) sendThrough(portal, aboveFloor, {});
            show(spanOf(What::haze), {0, projection().height});
            return;
        }
        meetTile();
    }
    meetBackground();
}

// Whether the tile is outside the grid and the ray moves away from it.
bool PlainWalk::isGridLeft() const {
    const auto isBehind = [](int tile, int tiles, int step) {
        return tile < 0 ? step <= 0 : tile >= tiles && step >= 0;
    };
    return isBehind(walk_.tileX, map().width, walk_.stepX) ||
           isBehind(walk_.tileY, map().depth, walk_.stepY);
}

// #region objects
// Each object splits the tile: things before its depth are met first, the others afterwards. So do
// the edges of blocks that fill only a part of the tile.
void PlainWalk::meetTile() {
    const Crossing leave = leave_;
    findEdges();
    begins_ = enter_.border ? kAllLevels : 0;
    for (;;) {
        const double edge = edges_.empty() ? kNever : edges_.front().at.along;
        const double object = objects_.empty() ? kNever : objects_.front()->along;
        if (!edges_.empty() && edge <= object) {
            meetEdge(edges_.front());
            edges_.erase(edges_.begin());
        } else if (object < leave.along) {
            leave_ = crossingAt(*objects_.front());
            ends_ = 0;
            meetStretch();
            meetObject(*objects_.front());
            objects_.erase(objects_.begin());
            begins_ = 0;
        } else {
            break;
        }
        enter_ = leave_;
    }
    leave_ = leave;
    ends_ = kAllLevels;
    meetStretch();
}
// #endregion

// The edges of the tile's blocks that the ray crosses within the tile, in their order, and the
// blocks that are there from the start.
void PlainWalk::findEdges() {
    edges_.clear();
    there_ = 0;
    for (int level = 0; level < map().levels; ++level) {
        const CellBlueprint& block = cell(map(), {walk_.tileX, walk_.tileY}, level);
        const PlanPassage passage = plansHere().passage(block.plan);
        const std::uint32_t bit = std::uint32_t{1} << level;
        if (!passage.isMet) continue;
        if (!passage.enter.inner) there_ |= bit;
        if (passage.enter.inner) edges_.push_back({passage.enter, bit});
        if (passage.leave.inner) edges_.push_back({passage.leave, bit});
    }
    mergeSort(edges_,
              [&](const Edge& a, const Edge& b) { return plansHere().isBefore(a.at, b.at); });
}

// Meets the stretch before an edge, where one block begins or ends.
void PlainWalk::meetEdge(const Edge& edge) {
    const bool isEnd = (there_ & edge.level) != 0;
    leave_ = edge.at;
    ends_ = isEnd ? edge.level : 0;
    meetStretch();
    there_ ^= edge.level;
    begins_ = isEnd ? 0 : edge.level;
}

// #region stretch
// Meets everything in the tile between `enter_` and `leave_`.
void PlainWalk::meetStretch() {
    findBlocks();
    findPlanes();
    for (const Block& block : blocks_) {
        if (begins_ >> block.level & 1) enterSide(block);
    }
    for (const LevelPlane& plane : planes_) meetPlane(plane);
    for (const Block& block : blocks_) {
        if ((ends_ >> block.level & 1) && leave_.along > 0.0) leaveSide(block);
    }
}
// #endregion

// Outside the grid the floor is endless.
void PlainWalk::meetBackground() {
    meetFloor({0, rowBelow(riseOf(0), enter_)}, true);
    show(spanOf(What::sky), {0, projection().firstFallingRow});
    show(spanOf(What::haze), {0, projection().height});
}

// ---- the contents of a tile

// #region blocks
// The blocks, cut to the heights of the part's rays.
void PlainWalk::findBlocks() {
    blocks_.clear();
    const HeightClip& clip = part_.clip;
    for (int level = 0; level < map().levels; ++level) {
        const BlueprintId id = map().cell(walk_.tileX, walk_.tileY, level);
        if (id == kEmptyCell) continue;
        const CellBlueprint& blueprint = frame_.world->blueprints[id];
        const std::int32_t bottom = riseOf(tileEdge(level).raw) + blueprint.bottom.raw;
        const std::int32_t top = riseOf(tileEdge(level).raw) + blueprint.top.raw;
        if (top <= clip.low || bottom >= clip.high || !(there_ >> level & 1)) continue;
        if (blueprint.slopes.any()) {  // what a mirror in its tile reflects is wholly above it
            const bool cut =
                clip.isMirror && bottom == clip.low && blueprint.slopes.bottom.isLevel();
            blocks_.push_back({&blueprint, level, bottom, top, cut});
            continue;
        }
        const bool cut =
            bottom < clip.low || top > clip.high || (clip.isMirror && bottom == clip.low);
        blocks_.push_back(
            {&blueprint, level, std::max(bottom, clip.low), std::min(top, clip.high), cut});
    }
}
// #endregion

// The horizontal planes, sorted by distance from the eye's height: a ray meets those in its
// direction in that order. At equal height the face of the block that is left comes first, then
// that of the block entered, then ceiling or floor. A block with slopes is entered at its end that
// is nearer to the eye's height (by a slope just behind it), and left at the other.
void PlainWalk::findPlanes() {
    planes_.clear();
    const auto add = [&](What what, std::int32_t rise, const Block& block, bool leaving) {
        planes_.push_back({what, rise, block, leaving, 2 * std::abs(std::int64_t{rise})});
    };
    const auto addBoth = [&](const Block& block, bool leaving, std::int32_t end) {
        const Slopes& slopes = block.blueprint->slopes;
        const auto away = [&](const Slant& slant) {
            return 2 * std::int64_t{end} + (leaving || slant.isLevel() ? 0 : 1);
        };
        planes_.push_back({What::roof, block.top, block, leaving, away(slopes.top)});
        planes_.push_back({What::underside, block.bottom, block, leaving, away(slopes.bottom)});
    };
    for (const Block& block : blocks_) {
        if (block.blueprint->slopes.any()) {
            addBoth(
                block, true,
                std::max({block.top > 0 && block.bottom < 0 ? 1 : 0,
                          block.bottom >= 0 ? block.top : 0, block.top <= 0 ? -block.bottom : 0}));
            continue;
        }
        if (block.top > 0) add(What::roof, block.top, block, true);
        if (block.bottom < 0) add(What::underside, block.bottom, block, true);
    }
    for (const Block& block : blocks_) {
        if (block.blueprint->slopes.any()) {
            addBoth(block, false, std::max({0, block.bottom, -block.top}));
            continue;
        }
        if (block.top <= 0) add(What::roof, block.top, block, false);
        if (block.bottom > 0) add(What::underside, block.bottom, block, false);
    }
    add(What::ceiling, riseOf(map().ceiling.height.raw), {}, false);
    add(What::floor, riseOf(0), {}, false);
    mergeSort(planes_, [](const LevelPlane& a, const LevelPlane& b) { return a.away < b.away; });
}

// A side at depth 0 is not drawn, but its portal acts. No portal acts on rays that have just come
// out of another one there.
void PlainWalk::enterSide(const Block& block) {
    const Face face = enteredFace(enter_);
    const PortalId portal = block.blueprint->face(face).portal;
    const Rows rows = rowsOf(block, enter_);
    if (portal != kNoPortal && mayPass() && !isArrival()) {
        sendThrough(portal, rows, {});
    } else if (enter_.along > 0.0) {
        showSideBut(block, face, enter_, rows, joinedBefore(block));
    }
}

// Seen from inside, a block's portals do not act, and their faces are not drawn.
void PlainWalk::leaveSide(const Block& block) {
    const Face face = leftFace(leave_);
    if (block.blueprint->face(face).portal != kNoPortal) return;
    const Rows rows = rowsOf(block, leave_);
    showSideBut(block, face, leave_, rows, joinedBehind(block));
}

// A side without the rows in which its block touches a joined one.
void PlainWalk::showSideBut(const Block& block, Face face, const Crossing& border, Rows rows,
                            Rows joined) {
    if (joined.first >= joined.last) return showSide(block, face, border, rows);
    showSide(block, face, border, {rows.first, std::min(rows.last, joined.first)});
    showSide(block, face, border, {std::max(rows.first, joined.last), rows.last});
}

// #region plane
// The rows whose rays cross the plane's height between the two borders: falling rays see it below
// the eye, rising rays above.
void PlainWalk::meetPlane(const LevelPlane& plane) {
    if (plane.block.blueprint != nullptr && plane.block.blueprint->slopes.any())
        return meetFaceOfSlopes(plane);
    const int atEnter = rowBelow(plane.rise, enter_);
    const int atLeave = rowBelow(plane.rise, leave_);
    const int horizon = projection().firstFallingRow;
    Rows rows = plane.rise < 0 ? Rows{std::max(atLeave, horizon), atEnter}
                               : Rows{atEnter, std::min(atLeave, horizon)};
    if (plane.what == What::floor) {
        meetFloor(rows, false);
    } else if (plane.what == What::ceiling) {
        meetCeiling(rows);
    } else {
        // An eye exactly on a portal looks through it at once
        if (plane.rise == 0 && !walk_.hasEntered() && acts(plane))
            rows = {horizon, projection().height};
        meetFace(plane, rows);
    }
}
// #endregion

// The same for the faces of a block with slopes, sloped and level ones. Rays above a top that end
// up below it enter the block; rays that do the reverse leave it.
void PlainWalk::meetFaceOfSlopes(const LevelPlane& plane) {
    const Block& block = plane.block;
    const bool isTop = plane.what == What::roof;
    const Face face = isTop ? Face::top : Face::bottom;
    const int atEnter = rowOf(*block.blueprint, face, here(), block.level, enter_);
    const int atLeave = rowOf(*block.blueprint, face, here(), block.level, leave_);
    const bool isDownwards = isTop != plane.leaving;
    Rows rows = isDownwards ? Rows{atLeave, atEnter} : Rows{atEnter, atLeave};
    if (block.blueprint->slopes.of(face).isLevel()) {
        const int horizon = projection().firstFallingRow;
        if (isDownwards != (plane.rise < 0)) return;
        (isDownwards ? rows.first : rows.last) =
            isDownwards ? std::max(rows.first, horizon) : std::min(rows.last, horizon);
    } else if (slopedPlane(*block.blueprint, face, here(), block.level).height == 0.0) {
        return;  // it is met at depth 0
    } else {
        rows = rowsOfPart(plane, rows);
    }
    rows.last = std::min(rows.last, firstRowNotReflected(leave_));
    meetFace(plane, rows);
}

// The rows in which a part of a moving block has a slope: elsewhere other parts have it.
PlainWalk::Rows PlainWalk::rowsOfPart(const LevelPlane& plane, Rows rows) const {
    const Block& block = plane.block;
    const Face face = plane.what == What::roof ? Face::top : Face::bottom;
    const Slant& slant = block.blueprint->slopes.of(face);
    const auto keep = [&](std::int32_t rise, bool keepsBelow) {
        keepRowsAt(projection(), slopedPlane(*block.blueprint, face, here(), block.level),
                   rise / 65536.0, keepsBelow, (face == Face::top) != plane.leaving, rows.first,
                   rows.last);
    };
    if (slant.most() > block.blueprint->top) keep(block.top, true);
    if (slant.least() < block.blueprint->bottom) keep(block.bottom, false);
    return rows;
}

SlopedPlane PlainWalk::slopedPlane(const CellBlueprint& blueprint, Face face, GridTile tile,
                                   int level) const {
    const Vista& vista = *part_.vista;
    return SlopedPlane(blueprint.slopes, blueprint.slopes.of(face), tile.x, tile.y,
                       riseOf(tileEdge(level).raw), vista.viewpoint, vista.ray(column_),
                       projection());
}

// The first row whose ray passes below a block's top or underside.
int PlainWalk::rowOf(const CellBlueprint& blueprint, Face face, GridTile tile, int level,
                     const Crossing& at) const {
    if (!blueprint.slopes.of(face).isLevel())
        return firstRowBelow(projection(), slopedPlane(blueprint, face, tile, level), at);
    const Coordinate height = face == Face::top ? blueprint.top : blueprint.bottom;
    return rowBelow(riseOf(tileEdge(level).raw) + height.raw, at);
}

// The same of the block's side, which ends with its part of a moving block.
int PlainWalk::endRow(const CellBlueprint& blueprint, Face face, GridTile tile, int level,
                      const Crossing& at) const {
    const int row = rowOf(blueprint, face, tile, level, at);
    const auto rowAt = [&](Coordinate height) {
        return rowBelow(riseOf(tileEdge(level).raw) + height.raw, at);
    };
    if (face == Face::top)
        return blueprint.isCutAbove() ? std::max(row, rowAt(blueprint.top)) : row;
    return blueprint.isCutBelow() ? std::min(row, rowAt(blueprint.bottom)) : row;
}

// The rows between the top and the bottom of a block at a border.
PlainWalk::Rows PlainWalk::rowsOf(const Block& block, const Crossing& border) const {
    if (!block.blueprint->slopes.any())
        return {rowBelow(block.top, border), rowBelow(block.bottom, border)};
    return {endRow(*block.blueprint, Face::top, here(), block.level, border),
            std::min(endRow(*block.blueprint, Face::bottom, here(), block.level, border),
                     firstRowNotReflected(border))};
}

// Rays below their mirror are still on their way to it.
int PlainWalk::firstRowNotReflected(const Crossing& at) const {
    return part_.clip.isMirror ? rowBelow(part_.clip.low, at) : projection().height;
}

// Whether a roof or an underside is a portal that acts on rays entering it. It does not act on rays
// that came out of another one at this height.
bool PlainWalk::acts(const LevelPlane& plane) const {
    const bool isTop = plane.what == What::roof;
    const Face face = isTop ? Face::top : Face::bottom;
    return plane.block.blueprint->face(face).portal != kNoPortal && mayPass() &&
           !isWhereItCameOut(plane.block, isTop ? 1 : -1);
}

// A roof or an underside. Rays that leave a block see nothing of its portals.
void PlainWalk::meetFace(const LevelPlane& plane, Rows rows) {
    const Block& block = plane.block;
    const bool isTop = plane.what == What::roof;
    const Face face = isTop ? Face::top : Face::bottom;
    const bool leaving = block.blueprint->slopes.any() ? plane.leaving : isTop == (plane.rise > 0);
    const FaceBlueprint& look = block.blueprint->face(face);
    const bool isCut = block.cut && (!isTop || !block.blueprint->slopes.any());
    if ((leaving && look.portal != kNoPortal) || (!leaving && isCut)) return;
    if (acts(plane)) {
        HeightClip beyond;
        (isTop ? beyond.high : beyond.low) = plane.rise;
        return sendThrough(look.portal, rows, beyond);
    }
    const bool isSloped = !block.blueprint->slopes.of(face).isLevel();
    if (look.texture == kNoTexture || (!isSloped && joinsLevel(block, isTop ? 1 : -1, leaving)))
        return;
    const int strength = leaving ? 0 : mirrorStrength(look.mirror);
    Span span = spanOf(plane.what);
    span.face = face;
    span.level = block.level;
    span.layer = block.blueprint->seeThrough && strength == 0;
    if (isSloped) {
        const SlopedPlane sloped = slopedPlane(*block.blueprint, face, here(), block.level);
        span.slope = {sloped.height, sloped.horizon};
        span.look = &lookOf({0, look.texture, look.light, look.glow, !isTop, false, true,
                             block.blueprint->textureEast, block.blueprint->textureSouth});
        return show(span, rows);
    }
    span.look = &lookOf({plane.rise, look.texture, look.light, look.glow, !isTop, strength > 0,
                         false, block.blueprint->textureEast, block.blueprint->textureSouth});
    showPlane(span, rows, strength, look.ripples);
}

// Leaves rows beyond the map's `far` to the haze.
void PlainWalk::meetFloor(Rows rows, bool endless) {
    const Floor& floor = map().floor;
    if (riseOf(0) >= 0) return;
    rows.first = std::max(rows.first, part_.vista->firstFloorRow);
    const int strength = mirrorStrength(floor.mirror);
    Span span = spanOf(What::floor);
    span.tiles.endless = endless;
    const TextureId texture = map().contains(walk_.tileX, walk_.tileY)
                                  ? floor.tiles[map().tileIndex(walk_.tileX, walk_.tileY)]
                                  : floor.texture;
    span.look = &lookOf({riseOf(0), texture, floor.light, floor.glow, false, strength > 0});
    showPlane(span, rows, strength, floor.ripples);
}

void PlainWalk::meetCeiling(Rows rows) {
    const Ceiling& ceiling = map().ceiling;
    const HeightClip& clip = part_.clip;
    const std::int32_t rise = riseOf(ceiling.height.raw);
    if (ceiling.tiles.empty() || !map().contains(walk_.tileX, walk_.tileY) || rise < clip.low ||
        rise > clip.high || (clip.isMirror && rise == clip.low))
        return;
    const TextureId texture = ceiling.tiles[map().tileIndex(walk_.tileX, walk_.tileY)];
    if (texture == kNoTexture) return;
    Span span = spanOf(What::ceiling);
    span.face = Face::bottom;
    span.layer = frame_.textures[texture].seeThrough;
    span.look = &lookOf({rise, texture, ceiling.light, ceiling.glow, true, false});
    show(span, rows);
}

// ---- spans

Span PlainWalk::spanOf(What what) const {
    Span span;
    span.what = what;
    span.part = number_;
    span.portals = part_.portals;
    span.vista = part_.vista;
    span.tiles = {walk_.tileX, walk_.tileY, walk_.tileX, walk_.tileY, false};
    return span;
}

// Adds a span for each run of open rows, completed by `finish`, and closes the rows unless it is a
// layer.
void PlainWalk::show(const Span& look, Rows rows, const Finish& finish) {
    for (const auto& [first, last] :
         look.layer ? open_.within(rows.first, rows.last) : open_.take(rows.first, rows.last)) {
        if (look.layer && found_->isFull()) return;
        if (look.layer) ++found_->layers;
        Span& span = found_->spans.add();
        span = look;
        span.first = first;
        span.last = last;
        if (finish) finish(span);
    }
}

// `mirror` is the strength of the reflection; 0 for none.
void PlainWalk::showPlane(const Span& look, Rows rows, int mirror, int ripples) {
    show(look, rows, [&](const Span& span) {
        if (mirror > 0)
            found_->mirrors.push_back({number_, span.look->plane.rise, span.first, span.last,
                                       static_cast<std::uint32_t>(mirror), ripples});
    });
}

}  // namespace slicecast

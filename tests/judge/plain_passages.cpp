// Part of the plain walk: which blocks join, and where rays continue through portals and off
// mirrors.
#include "plain_walk.h"

#include "world/world.h"

#include <algorithm>
#include <cmath>

namespace slicecast {

// The rows in which a block touches a block of its kind in a tile, both see-through: there are no
// faces between them.
PlainWalk::Rows PlainWalk::joinedRows(const Block& block, const CellBlueprint& other, GridTile tile,
                                      const Crossing& border) const {
    return {endRow(other, Face::top, tile, block.level, border),
            endRow(other, Face::bottom, tile, block.level, border)};
}

// The same for its neighbour beyond the border at which rays enter the tile, or leave it.
PlainWalk::Rows PlainWalk::joinedNear(const Block& block, const Crossing& border,
                                      bool isAhead) const {
    const GridTile tile = tileAcross(border, isAhead ? 1 : -1);
    const CellBlueprint& next = cell(map(), tile, block.level);
    const bool isOne =
        areOneAlong(*frame_.world, *block.blueprint, next, border.alongX ? Axis::x : Axis::y);
    if (!(isOne || areJoined(*frame_.world, *block.blueprint, next)) ||
        !plansHere().touches(next.plan, tile.x, tile.y, border, isAhead))
        return {0, 0};
    return joinedRows(block, next, tile, border);
}

// The same behind a portal, where two blocks join only if both fill their tiles and have no slopes.
PlainWalk::Rows PlainWalk::joinedBeyond(const Block& block, const CellBlueprint& neighbour,
                                        const Crossing& border) const {
    return block.blueprint->isBox() && neighbour.isBox() &&
                   areJoined(*frame_.world, *block.blueprint, neighbour)
               ? joinedRows(block, neighbour, here(), border)
               : Rows{0, 0};
}

// The block that rays have left; it may be in front of the portal that they came through.
PlainWalk::Rows PlainWalk::joinedBefore(const Block& block) const {
    if (enter_.inner) return {0, 0};
    if (isArrival()) return joinedBeyond(block, cellBeforePortal(block.level), enter_);
    return joinedNear(block, enter_, false);
}

// The block that rays are about to enter; it may be behind a portal of the whole tile, or of a
// block's face, which may be smaller than the side.
PlainWalk::Rows PlainWalk::joinedBehind(const Block& block) const {
    if (leave_.inner) return {0, 0};
    const GridTile tile = tileAcross(leave_, 1);
    const PortalId ofTile = map().tilePortal(tile.x, tile.y);
    if (ofTile != kNoPortal)
        return mayPass() ? joinedBeyond(block, exitCell(ofTile, block.level), leave_) : Rows{0, 0};
    const CellBlueprint& behind = cell(map(), tile, block.level);
    const PortalId portal = behind.face(enteredFace(leave_)).portal;
    if (portal == kNoPortal || !mayPass()) return joinedNear(block, leave_, true);
    const Rows window = {rowOf(behind, Face::top, tile, block.level, leave_),
                         rowOf(behind, Face::bottom, tile, block.level, leave_)};
    const Rows joined = joinedBeyond(block, exitCell(portal, block.level), leave_);
    return {std::max(window.first, joined.first), std::min(window.last, joined.last)};
}

// Whether there are no faces between a block and the one above it (`up` is 1) or below (-1). Both
// must reach the border between their levels. Parts of one mover are one block there. See-through
// blocks of one kind join, also through a portal there, by which rays leave the block or have come
// to it.
bool PlainWalk::joinsLevel(const Block& block, int up, bool leaving) const {
    const auto reaches = [](const CellBlueprint& blueprint, int end) {
        return end > 0 ? blueprint.fillsUp() : blueprint.fillsDown();
    };
    const CellBlueprint& own = *block.blueprint;
    const auto joins = [&](const CellBlueprint& other) {
        return reaches(other, -up) && areJoined(*frame_.world, own, other);
    };
    const auto goesOn = [](const CellBlueprint& blueprint, int end) {
        return end > 0 ? blueprint.goesUp() : blueprint.goesDown();
    };
    if (!reaches(own, up)) return false;
    const int level = block.level + up;
    const auto joinsBeyond = [&](const CellBlueprint& other) {
        return own.isBox() && other.isBox() && joins(other);
    };
    if (isWhereItCameOut(block, up)) return joinsBeyond(cellBeforePortal(level));
    const CellBlueprint& next = cell(map(), {walk_.tileX, walk_.tileY}, level);
    if (level < 0 || level >= map().levels || (there_ >> level & 1) == 0) return false;
    if (areOneMover(own, next) && goesOn(next, -up)) return true;
    if (!reaches(next, -up)) return false;
    const PortalId portal = next.face(up > 0 ? Face::bottom : Face::top).portal;
    if (leaving && portal != kNoPortal && mayPass()) return joinsBeyond(exitCell(portal, level));
    return joins(next);
}

// The cell where a portal leads, and the cell where rays were before their portal; `level` is that
// of the current tile.
const CellBlueprint& PlainWalk::exitCell(PortalId portal, int level) const {
    const Portal& to = frame_.world->portals[portal];
    return cell(frame_.world->maps[static_cast<std::size_t>(to.toMap)], {to.toX, to.toY},
                level + to.levels);
}
const CellBlueprint& PlainWalk::cellBeforePortal(int level) const {
    const Before& before = part_.before;
    return cell(*before.map, {before.x, before.y}, level - before.levels);
}

// Whether rays have come out of a portal in the current tile.
bool PlainWalk::isArrival() const {
    return part_.portals > 0 && walk_.tileX == part_.walk.tileX && walk_.tileY == part_.walk.tileY;
}

// Whether they came out exactly at the upper or lower end of the block.
bool PlainWalk::isWhereItCameOut(const Block& block, int up) const {
    return isArrival() && (up > 0 ? block.top == part_.clip.high : block.bottom == part_.clip.low);
}

// Closes rows here and opens them behind the portal; rays that come out below the floor end in the
// haze. Rays through a roof or an underside start at one height and meet nothing on its other side;
// `clip` is that height.
void PlainWalk::sendThrough(PortalId id, Rows rows, const HeightClip& clip) {
    const Portal& portal = frame_.world->portals[id];
    Vista& beyond = frame_.vistas.through(*part_.vista, portal);
    const std::int32_t floorRise = -beyond.viewpoint.z;
    GridTile from = {walk_.tileX, walk_.tileY};
    int hazeRow = 0;
    if (clip.any()) {
        const std::int32_t height = clip.high != HeightClip{}.high ? clip.high : clip.low;
        const bool isBelow = height < floorRise || (height == 0 && floorRise == 0);
        hazeRow = isBelow ? 0 : projection().height;
    } else {
        hazeRow = rowBelow(floorRise, enter_);
        from = tileAcross(enter_, -1);
    }
    const Before before = {&map(), from.x, from.y, portal.levels};
    const GridWalk onward = walk_.turned(portal.turn, portal.toX, portal.toY);
    const auto begun = static_cast<std::size_t>(number_) + 1;
    for (const auto& [first, last] : open_.take(rows.first, rows.last)) {
        if (first < hazeRow) {
            Part& part = found_->parts.find(beyond, onward, clip, before, part_.portals + 1, begun);
            Parts::addRows(part, first, std::min(last, hazeRow));
        }
        if (last > hazeRow) {
            Span& haze = found_->spans.add();
            haze = spanOf(What::haze);
            haze.first = std::max(first, hazeRow);
            haze.last = last;
            haze.vista = &beyond;
            ++haze.portals;
        }
        found_->portals.push_back(
            {id, part_.portals, walk_.entered * projection().distance, first, last});
    }
}

// Finds what mirrors show: repeats the walk that met the mirror, seen from as far below it as the
// eye is above (see vista.h).
void PlainWalk::reflect(SliceSpans& found) {
    found_ = &found.reflected;
    for (const MirrorSpan& span : found.upright.mirrors) {
        const Part& met = found.upright.parts[static_cast<std::size_t>(span.part)];
        const int height = met.vista->projection->height;
        Vista& vista = frame_.vistas.mirrored(*met.vista, met.vista->viewpoint.z + span.rise);
        HeightClip above;
        above.low = -span.rise;
        above.isMirror = true;
        Parts::addRows(found_->parts.find(vista, met.walk, above, met.before, met.portals, 0),
                       height - span.last, height - span.first);
    }
    walkParts();
}

int PlainWalk::mirrorStrength(std::uint8_t strength) const {
    return static_cast<int>(std::min(255.0, std::floor(strength * frame_.mirrors + 0.5)));
}

}  // namespace slicecast

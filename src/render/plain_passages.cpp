// Of the plain walk: which see-through blocks join, and where rays go on through portals and off
// mirrors.
#include "render/plain_walk.h"

#include <algorithm>
#include <cmath>

namespace slicecast {

bool PlainWalk::joins(const Block& block, BlueprintId other) const {
    return block.blueprint->seeThrough && block.blueprint->join &&
           &frame_.world->blueprints[other] == block.blueprint;
}

BlueprintId PlainWalk::exitCell(PortalId portal, int level) const {
    const Portal& to = frame_.world->portals[portal];
    return frame_.world->maps[static_cast<std::size_t>(to.toMap)].cell(to.toX, to.toY,
                                                                       level + to.levels);
}

bool PlainWalk::joinsTileBefore(const Block& block) const {
    const Before& before = part_.before;
    if (isArrival())
        return joins(block, before.map->cell(before.x, before.y, block.level - before.levels));
    const GridTile tile = tileAcross(enter_, -1);
    return joins(block, map().cell(tile.x, tile.y, block.level));
}

// Whether a block joins the one above it (`up` is 1) or below (-1): of its own blueprint, or of the
// same thing that moves. Rays that leave it may go through a portal there, and those that enter it
// may have come through one.
bool PlainWalk::joinsLevel(const Block& block, int up, bool leaving) const {
    const auto touches = [](const CellBlueprint& blueprint, bool above) {
        return above ? blueprint.top == tileEdge(1) : blueprint.bottom == Coordinate{0};
    };
    const CellBlueprint& own = *block.blueprint;
    if (!own.seeThrough || !own.join || !touches(own, up > 0)) return false;
    const int level = block.level + up;
    BlueprintId next = map().cell(walk_.tileX, walk_.tileY, level);
    const Before& before = part_.before;
    if (up > 0 ? block.top == part_.clip.high : block.bottom == part_.clip.low) {
        next =
            isArrival() ? before.map->cell(before.x, before.y, level - before.levels) : kEmptyCell;
    } else if (leaving && touches(frame_.world->blueprints[next], up < 0)) {
        const PortalId portal =
            frame_.world->blueprints[next].face(up > 0 ? Face::bottom : Face::top).portal;
        if (acts(portal)) next = exitCell(portal, level);
    }
    const CellBlueprint& other = frame_.world->blueprints[next];
    return next != kEmptyCell && touches(other, up < 0) &&
           (&other == &own || (other.mover >= 0 && other.mover == own.mover));
}

bool PlainWalk::isArrival() const {
    return part_.portals > 0 && walk_.tileX == part_.walk.tileX && walk_.tileY == part_.walk.tileY;
}

// The portals of the tile in which a ray has come out do not act on it.
bool PlainWalk::acts(PortalId portal) const {
    return portal != kNoPortal && part_.portals < frame_.world->portalLimit && !isArrival();
}

// Closes rows here and opens them on the portal's other side; those whose rays come out below the
// floor end in the haze there. Through a roof or an underside rays come at one height, and meet
// nothing on the other side of it: that is `clip`.
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
    open_.take(rows.first, rows.last, [&](int first, int last) {
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
    });
}

// What the mirrors show: for each, the walk that met it once more, seen from as far below the
// mirror as the eye is above (see vista.h).
void PlainWalk::reflect(SliceSpans& found) {
    found_ = &found.reflected;
    for (const MirrorSpan& span : found.upright.mirrors) {
        const Part& met = found.upright.parts[static_cast<std::size_t>(span.part)];
        const int height = met.vista->projection->height;
        Vista& vista = frame_.vistas.mirrored(*met.vista, met.vista->viewpoint.z + span.height);
        HeightClip above;
        above.low = -span.height;
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

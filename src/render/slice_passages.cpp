// Where a slice continues elsewhere: behind portals and in mirrors. The rows that do become parts
// of their own.
#include "render/slice_walk.h"

#include <algorithm>

namespace slicecast {

// The next six take the faces of blocks that are see-through, have portals, or are cut by the
// part's height clip. A portal acts only on rays that enter the block; seen from inside the block,
// its face shows nothing.
void SliceWalk::enterSide(const Block& block, int firstRow, int lastRow) {
    if (!entersAt(block.level) || !open_.mayHold(firstRow, lastRow)) return;
    const PortalId portal = block.blueprint->face(enteredFace(enter_)).portal;
    if (acts(portal, isArrival())) {
        sendThrough(portal, firstRow, lastRow, {});
    } else if (enter_.along > 0.0) {
        if (block.blueprint->seeThrough) {
            enterThroughSide(block, firstRow, lastRow);
        } else {
            takeEnteredSide(block, firstRow, lastRow);
        }
    }
}

void SliceWalk::enterTop(const Block& block, int firstRow, int lastRow) {
    const FaceBlueprint& look = block.blueprint->face(Face::top);
    if (actsAtTop(block)) {
        HeightClip below;
        below.high = block.top;
        sendThrough(look.portal, firstRow, lastRow, below);
    } else if (block.blueprint->seeThrough &&
               (mirrorStrength(look.mirror) == 0 || joinsNext(block, 1, false))) {
        passThroughPlane(block, Face::top, firstRow, lastRow, false);
    } else {
        takeRoof(block, firstRow, lastRow);
    }
}

void SliceWalk::enterBottom(const Block& block, int firstRow, int lastRow) {
    const PortalId portal = block.blueprint->face(Face::bottom).portal;
    if (actsAtBottom(block)) {
        HeightClip above;
        above.low = block.bottom;
        sendThrough(portal, firstRow, lastRow, above);
    } else if (block.blueprint->seeThrough) {
        passThroughPlane(block, Face::bottom, firstRow, lastRow, false);
    } else {
        takeUnderside(block, firstRow, lastRow);
    }
}

void SliceWalk::leaveSide(const Block& block, int firstRow, int lastRow) {
    if (!leavesAt(block.level) || leave_.along <= 0.0 ||
        block.blueprint->face(leftFace(leave_)).portal != kNoPortal)
        return;
    if (block.blueprint->seeThrough) {
        leaveThroughSide(block, firstRow, lastRow);
    } else {
        takeSide(sideOf(block, leftFace(leave_), false), sideView(leave_), firstRow, lastRow);
    }
}

void SliceWalk::leaveTop(const Block& block, int firstRow, int lastRow) {
    if (block.blueprint->face(Face::top).portal != kNoPortal) return;
    if (block.blueprint->seeThrough) {
        passThroughPlane(block, Face::top, firstRow, lastRow, true);
    } else if (!goesOn(block, 1)) {
        takeRoof(block, firstRow, lastRow, true);
    }
}

void SliceWalk::leaveBottom(const Block& block, int firstRow, int lastRow) {
    if (block.blueprint->face(Face::bottom).portal != kNoPortal) return;
    if (block.blueprint->seeThrough) {
        passThroughPlane(block, Face::bottom, firstRow, lastRow, true);
    } else if (!goesOn(block, -1)) {
        takeUnderside(block, firstRow, lastRow);
    }
}

// Cuts a block to the heights of the part's rays; false if nothing remains.
bool SliceWalk::cutToClip(Block& block) const {
    if (block.top <= clip_.low || block.bottom >= clip_.high) return false;
    if (block.blueprint->slopes.any()) {  // see firstRowNotReflected
        block.cut =
            clip_.isMirror && block.bottom == clip_.low && block.blueprint->slopes.bottom.isLevel();
        return true;
    }
    block.cut = block.bottom < clip_.low || block.top > clip_.high ||
                (clip_.isMirror && block.bottom == clip_.low);
    block.bottom = std::max(block.bottom, clip_.low);
    block.top = std::min(block.top, clip_.high);
    return true;
}

// Whether a portal acts on the present ray. With `atExit` it does not: it is where the ray has just
// come out of another one, as the exit tile's portal or a face in the same plane. Otherwise the ray
// could circle for ever.
bool SliceWalk::acts(PortalId portal, bool atExit) const {
    return portal != kNoPortal && portals_ < frame_.world->portalLimit && !atExit;
}

bool SliceWalk::actsAtTop(const Block& block) const {
    return acts(block.blueprint->face(Face::top).portal, isArrival() && block.top == clip_.high);
}

bool SliceWalk::actsAtBottom(const Block& block) const {
    return acts(block.blueprint->face(Face::bottom).portal,
                isArrival() && block.bottom == clip_.low);
}

// Closes rows here and opens them behind the portal, in a part that starts at its exit tile. Rays
// that come out below the floor there end in the haze.
void SliceWalk::sendThrough(PortalId id, int firstRow, int lastRow, const HeightClip& clip) {
    if (!open_.mayHold(firstRow, lastRow)) return;
    const Portal& portal = frame_.world->portals[id];
    Vista& beyond = frame_.vistas.through(*vista_, portal);
    const std::int32_t floorRise = -beyond.viewpoint.z;
    // Rays through a roof or an underside all come out at the height of the clip
    const std::int32_t height = clip.high != HeightClip{}.high ? clip.high : clip.low;
    const bool isBelow = height < floorRise || (height == 0 && floorRise == 0);
    const int hazeRow = !clip.any() ? rowBelow(floorRise, enter_)
                        : isBelow   ? 0
                                    : projection_->height;
    const GridWalk onward = walk_.turned(portal.turn, portal.toX, portal.toY);
    const Before before =
        clip.any() ? Before{map_, walk_.tileX, walk_.tileY, portal.levels}
                   : Before{map_, beforeX(Border::enter), beforeY(Border::enter), portal.levels};
    const auto begun = static_cast<std::size_t>(part_) + 1;
    for (const auto& [first, last] : open_.take(firstRow, lastRow)) {
        if (first < hazeRow) {
            Part& part = found_->parts.find(beyond, onward, clip, before, portals_ + 1, begun);
            Parts::addRows(part, first, std::min(last, hazeRow));
        }
        if (last > hazeRow) {
            Span& haze = add(What::haze, std::max(first, hazeRow), last);
            haze.vista = &beyond;
            ++haze.portals;
        }
        found_->portals.push_back(
            {id, portals_, walk_.entered * projection_->distance, first, last});
    }
}

// Sends all open rows through the tile's portal. If it does not act, they end in the haze of the
// present map.
void SliceWalk::enterPortalTile() {
    takeFloor(Border::enter);
    const PortalId id = map_->tilePortal(walk_.tileX, walk_.tileY);
    // Rays that have met the floor beyond `far` do not get here
    if (acts(id, isArrival())) sendThrough(id, 0, rowBelow(floorRise_, enter_), {});
    takeHaze(0);
}

void SliceWalk::mirror(std::int32_t rise, int first, int last, int strength, int ripples) {
    report_.mirroredRows += last - first;
    if (cuts_ && !found_->mirrors.empty()) {
        MirrorSpan& before = found_->mirrors.back();
        if (before.first == last && before.part == part_ && before.rise == rise &&
            before.strength == static_cast<std::uint32_t>(strength) && before.ripples == ripples) {
            before.first = first;
            return;
        }
    }
    found_->mirrors.push_back(
        {part_, rise, first, last, static_cast<std::uint32_t>(strength), ripples});
}

// Makes parts of what the slice's mirrors show: each mirror becomes one of an upside-down column.
// False without mirrors.
bool SliceWalk::beginReflection(SliceSpans& found) {
    if (found.upright.mirrors.empty()) return false;
    const int height = frame_.vistas.projection().height;
    found_ = &found.reflected;
    for (const MirrorSpan& span : found.upright.mirrors) {
        const Part& met = found.upright.parts[static_cast<std::size_t>(span.part)];
        HeightClip above;
        // Seen from as far below the mirror as the eye is above it
        above.low = -span.rise;
        above.isMirror = true;
        Vista& vista = frame_.vistas.mirrored(*met.vista, met.vista->viewpoint.z + span.rise);
        Parts::addRows(found_->parts.find(vista, met.walk, above, met.before, met.portals, 0),
                       height - span.last, height - span.first);
    }
    part_ = 0;
    return true;
}

}  // namespace slicecast

// Where a slice goes on elsewhere: rays that enter a portal, and rays that a mirror throws back.
// Their rows become parts of their own.
#include "render/slice.h"

#include <algorithm>
#include <utility>

namespace slicecast {

// The faces of blocks that are see-through, hold portals, or are cut by the part's height clip. A
// portal acts on what comes in through it; from inside the block nothing is drawn there.
void Slice::enterSide(const Block& block, int firstRow, int lastRow) {
    if (!enter_.border || !open_.mayHold(firstRow, lastRow)) return;
    const PortalId portal = block.blueprint->face(enteredFace(enter_)).portal;
    if (acts(portal, isArrival())) {
        sendThrough(frame_.world->portals[portal], firstRow, lastRow, {});
    } else if (walk_.entered > 0.0) {
        if (block.blueprint->seeThrough) {
            enterThroughSide(block, firstRow, lastRow);
        } else {
            drawEnteredSide(block, firstRow, lastRow);
        }
    }
}

void Slice::enterTop(const Block& block, int firstRow, int lastRow) {
    const FaceBlueprint& look = block.blueprint->face(Face::top);
    if (actsAtTop(block)) {
        HeightClip below;
        below.high = block.top;
        sendThrough(frame_.world->portals[look.portal], firstRow, lastRow, below);
    } else if (block.blueprint->seeThrough &&
               (mirrorStrength(look.mirror) == 0 || joinsNext(block, 1, false))) {
        passThroughTop(block, firstRow, lastRow, false);
    } else {
        drawRoof(block, firstRow, lastRow);
    }
}

void Slice::enterBottom(const Block& block, int firstRow, int lastRow) {
    const PortalId portal = block.blueprint->face(Face::bottom).portal;
    if (actsAtBottom(block)) {
        HeightClip above;
        above.low = block.bottom;
        sendThrough(frame_.world->portals[portal], firstRow, lastRow, above);
    } else if (block.blueprint->seeThrough) {
        passThroughBottom(block, firstRow, lastRow, false);
    } else {
        drawUnderside(block, firstRow, lastRow);
    }
}

void Slice::leaveSide(const Block& block, int firstRow, int lastRow) {
    if (!leave_.border || leave_.along <= 0.0 ||
        block.blueprint->face(leftFace(leave_)).portal != kNoPortal)
        return;
    if (block.blueprint->seeThrough) {
        leaveThroughSide(block, firstRow, lastRow);
    } else {
        drawSide(block, leftFace(leave_), leave_, sideView(leave_), firstRow, lastRow);
    }
}

void Slice::leaveTop(const Block& block, int firstRow, int lastRow) {
    if (block.blueprint->face(Face::top).portal != kNoPortal) return;
    if (block.blueprint->seeThrough) {
        passThroughTop(block, firstRow, lastRow, true);
    } else if (!goesOn(block, 1)) {
        drawRoof(block, firstRow, lastRow, true);
    }
}

void Slice::leaveBottom(const Block& block, int firstRow, int lastRow) {
    if (block.blueprint->face(Face::bottom).portal != kNoPortal) return;
    if (block.blueprint->seeThrough) {
        passThroughBottom(block, firstRow, lastRow, true);
    } else if (!goesOn(block, -1)) {
        drawUnderside(block, firstRow, lastRow);
    }
}

// What is left of a block between the heights at which this part's rays run; false if that is
// nothing.
bool Slice::cutToClip(Block& block) const {
    if (block.top <= clip_.low || block.bottom >= clip_.high) return false;
    block.cut = block.bottom < clip_.low || block.top > clip_.high ||
                (clip_.isMirror && block.bottom == clip_.low);
    block.bottom = std::max(block.bottom, clip_.low);
    block.top = std::min(block.top, clip_.high);
    return true;
}

// Where a ray has just come out of a portal no other acts on it: not that of the exit tile, and no
// face that lies in the very plane; else it might go round for ever without getting on.
bool Slice::acts(PortalId portal, bool atExit) const {
    return portal != kNoPortal && portals_ < frame_.world->portalLimit && !atExit;
}

bool Slice::actsAtTop(const Block& block) const {
    return acts(block.blueprint->face(Face::top).portal, isArrival() && block.top == clip_.high);
}

bool Slice::actsAtBottom(const Block& block) const {
    return acts(block.blueprint->face(Face::bottom).portal,
                isArrival() && block.bottom == clip_.low);
}

// Closes rows here and opens them behind the portal, in a part that goes on from this tile. Those
// whose rays come out below the floor end in the haze.
void Slice::sendThrough(const Portal& portal, int firstRow, int lastRow, const HeightClip& clip) {
    if (!open_.mayHold(firstRow, lastRow)) return;
    Vista& beyond = frame_.vistas.through(*vista_, portal);
    const std::int32_t floorRise = -beyond.viewpoint.z;
    // Through a roof or an underside all rays come at one height, that of the clip.
    const std::int32_t height = clip.high != HeightClip{}.high ? clip.high : clip.low;
    const bool isBelow = height < floorRise || (height == 0 && floorRise == 0);
    const int hazeRow = !clip.any() ? rowBelow(floorRise, enter_)
                        : isBelow   ? 0
                                    : projection_->height;
    const GridWalk onward = walk_.turned(portal.turn, portal.toX, portal.toY);
    const Before before =
        clip.any() ? Before{map_, walk_.tileX, walk_.tileY, portal.levels}
                   : Before{map_, beforeX(Border::enter), beforeY(Border::enter), portal.levels};
    open_.take(firstRow, lastRow, [&](int first, int last) {
        if (first < hazeRow) {
            Parts::addRows(parts_->find(beyond, onward, clip, before, portals_ + 1, part_ + 1),
                           first, std::min(last, hazeRow));
        }
        if (last > hazeRow) {
            std::fill(pixels_ + std::max(first, hazeRow), pixels_ + last, beyond.lighting.haze);
            count(std::max(first, hazeRow), last);
        }
        if (trace_) {
            if (last > hazeRow) {
                FilledRows& haze = traceRun(kNoLevel, FilledRows::What::haze, Face::top,
                                            std::max(first, hazeRow), last, kNoTexture, false);
                haze.map = portal.toMap;
                ++haze.portals;
            }
            const auto id = static_cast<PortalId>(&portal - frame_.world->portals.data());
            trace_->portals.push_back(
                {id, portals_, enter_.along * projection_->distance, first, last});
        }
    });
}

// All that is still open goes through; or, where a ray has passed as many portals as it may, ends
// in the haze of the map that it is in.
void Slice::enterPortalTile() {
    takeFloor(Border::enter);
    const PortalId id = map_->tilePortal(walk_.tileX, walk_.tileY);
    // Rays that have met the floor beyond `far` do not come here.
    if (acts(id, isArrival()))
        sendThrough(frame_.world->portals[id], 0, rowBelow(floorRise_, enter_), {});
    drawHaze(0);
}

void Slice::mirror(std::int32_t rise, int first, int last, int strength) {
    memory_.mirrors.push_back({part_, rise, first, last, static_cast<std::uint32_t>(strength)});
    report_.mirroredRows += last - first;
    if (trace_)
        trace_->mirrors.push_back({vista_->viewpoint.map, strength, {eyeZ_ + rise}, first, last});
}

// Draws what the mirrors of this slice show into a column that stands upside down, and blends it
// over them.
void Slice::reflect() {
    Pixel* const pixels = pixels_;
    SliceTrace* const trace = trace_;
    const int height = frame_.vistas.projection().height;
    memory_.reflected.resize(static_cast<std::size_t>(height));
    memory_.reflectedParts.clear();
    for (const MirrorRun& run : memory_.mirrors) {
        const Part& met = memory_.parts[run.part];
        HeightClip above;
        above.low = -run.height;
        above.isMirror = true;
        Vista& vista = frame_.vistas.mirrored(*met.vista, met.vista->viewpoint.z + run.height);
        Parts::addRows(
            memory_.reflectedParts.find(vista, met.walk, above, met.before, met.portals, 0),
            height - run.last, height - run.first);
    }
    const std::uint8_t* const waterFogs = std::exchange(waterFogs_, nullptr);
    pixels_ = memory_.reflected.data();
    layers_ = &memory_.reflectedLayers;
    parts_ = &memory_.reflectedParts;
    if (trace_) trace_ = &traceReflection();
    drawParts();
    if (!layers_->empty()) layOver();
    pixels_ = pixels;
    waterFogs_ = waterFogs;
    layers_ = &memory_.layers;
    trace_ = trace;
    if (trace_) turnUpright(trace_->reflection.back(), height);
    for (const MirrorRun& run : memory_.mirrors) {
        blendReversed(pixels_ + run.first, run.last - run.first,
                      memory_.reflected.data() + (height - run.last), run.strength);
    }
}

}  // namespace slicecast

#include "render/column/slice_column.h"

#include <algorithm>

namespace slicecast {

SliceColumn::SliceColumn(const PartView& view, OpenRows& rows, FrameReport& report)
    : objects(view), open(rows), view_(view), report_(report) {}

void SliceColumn::begin(int at, SliceSpans& found) {
    number = at;
    found.column = at;
    found.upright.clear();
    found.reflected.clear();
    found_ = &found.upright;
    Vista& vista = view_.frame.vistas.ofEye();
    const Viewpoint& eye = vista.viewpoint;
    const GridWalk start({static_cast<std::int32_t>(eye.x)}, {static_cast<std::int32_t>(eye.y)},
                         vista.ray(at));
    Part& whole = found_->parts.find(vista, start, {}, {}, 0, 0);
    whole.rows.assign(1, {0, vista.projection->height});
    part_ = 0;
}

bool SliceColumn::beginReflection(SliceSpans& found) {
    if (found.upright.mirrors.empty()) return false;
    const int height = view_.frame.vistas.projection().height;
    found_ = &found.reflected;
    for (const MirrorSpan& span : found.upright.mirrors) {
        const Part& met = found.upright.parts[static_cast<std::size_t>(span.part)];
        HeightClip above;
        // Seen from as far below the mirror as the eye is above it
        above.low = -span.rise;
        above.isMirror = true;
        Vista& vista = view_.frame.vistas.mirrored(*met.vista, met.vista->viewpoint.z + span.rise);
        Parts::addRows(found_->parts.find(vista, met.walk, above, met.before, met.portals, 0),
                       height - span.last, height - span.first);
    }
    part_ = 0;
    return true;
}

void SliceColumn::beginPart(double nearest) {
    const Part& part = this->part();
    ray = view_.vista->ray(number);
    open.openOnly(part.rows, view_.projection->height);
    walk = part.walk;
    tiles_ = 0;
    floorSpan_ = kNone;
    report_.deepestPortal = std::max(report_.deepestPortal, part.portals);
    if (part.portals > 0) ++report_.partsBehindPortals;
    objects.begin(number, nearest, walk.entered);
}

bool SliceColumn::endPart() {
    for (const auto& [first, last] : open.take(0, view_.projection->firstFallingRow))
        add(What::sky, first, last);
    for (const auto& [first, last] : open.take(0, view_.projection->height))
        add(What::haze, first, last);
    found_->parts[static_cast<std::size_t>(part_)].tiles = tiles_;
    return ++part_ < static_cast<int>(found_->parts.count());
}

// Counts the part's tiles so far.
void SliceColumn::countTiles(int tiles) {
    report_.tilesWalked += tiles - tiles_;
    tiles_ = tiles;
}

// Ends the part outside the grid, or where only the floor and the sky can be met: the floor goes on
// for ever, over `tiles`, and objects may stand on it.
void SliceColumn::endBeyond(TextureId floor, const TileRange& tiles) {
    meetObjectsBefore(kNever, floor, tiles);
    takeFloor(0, floor, tiles);
}

// Meets objects where there is only the floor.
void SliceColumn::meetObjectsBefore(double along, TextureId floor, const TileRange& tiles) {
    for (;;) {
        objects.skip(open.first(), open.last());
        if (open.none() || !(objects.nextAlong() < along)) return;
        if (!objects.any()) {
            objects.find(objects.knownTo(), along);
            continue;
        }
        takeFloor(firstRowBelow(*view_.projection, view_.floorRise, objects.crossing()), floor,
                  tiles);
        meetObject();
    }
}

// Closes rows here and opens them behind the portal, in a part that starts at its exit tile. Rays
// that come out below the floor there end in the haze: those from `hazeRow` on.
void SliceColumn::sendThrough(PortalId id, Vista& beyond, int first, int last, int hazeRow,
                              const HeightClip& clip, const Before& before) {
    if (first < hazeRow) {
        const Portal& portal = view_.frame.world->portals[id];
        const GridWalk onward = walk.turned(portal.turn, portal.toX, portal.toY);
        Part& part = found_->parts.find(beyond, onward, clip, before, view_.portals + 1,
                                        static_cast<std::size_t>(part_) + 1);
        Parts::addRows(part, first, std::min(last, hazeRow));
    }
    if (last > hazeRow) {
        Span& haze = add(What::haze, std::max(first, hazeRow), last);
        haze.vista = &beyond;
        ++haze.portals;
    }
    found_->portals.push_back(
        {id, view_.portals, walk.entered * view_.projection->distance, first, last});
}

void SliceColumn::takeFloor(int row, TextureId floor, const TileRange& tiles) {
    for (const auto& [first, last] :
         open.take(std::max(row, view_.vista->firstFloorRow), view_.projection->height))
        addFloor(floor, first, last, tiles);
}

// A roof or an underside. In a picture, rows that touch those of the last span are one run with it;
// a trace tells each tile.
void SliceColumn::addFace(What what, PlaneLook& look, int first, int last, const TileRange& tiles,
                          int level) {
    const bool isRoof = what == What::roof;
    if (SpanList& spans = found_->spans; view_.cuts && spans.count() > 0) {
        Span& before = spans[spans.count() - 1];
        if (before.what == what && !before.layer && before.look == &look && before.part == part_ &&
            before.level == level && (isRoof ? before.first == last : before.last == first)) {
            (isRoof ? before.first : before.last) = isRoof ? first : last;
            before.tiles.toX = tiles.toX;
            before.tiles.toY = tiles.toY;
            return;
        }
    }
    Span& span = addPlane(what, look, first, last, tiles);
    span.level = level;
    span.face = isRoof ? Face::top : Face::bottom;
}

// Floor that continues from tile to tile is one span.
void SliceColumn::addFloor(TextureId texture, int first, int last, const TileRange& tiles) {
    const Floor& ground = view_.map->floor;
    if (view_.floorMirror > 0)
        mirror(view_.floorRise, first, last, view_.floorMirror, ground.ripples);
    if (Span* const before = floorSpan_ == kNone ? nullptr : &found_->spans[floorSpan_];
        before != nullptr && before->first == last && before->look->plane.texture == texture) {
        before->first = first;
        before->tiles.toX = tiles.toX;
        before->tiles.toY = tiles.toY;
        before->tiles.endless = tiles.endless;
        return;
    }
    floorSpan_ = found_->spans.count();
    PlaneLook& look = view_.lookOf(
        {view_.floorRise, texture, ground.light, ground.glow, false, view_.floorMirror > 0});
    addPlane(What::floor, look, first, last, tiles);
}

void SliceColumn::mirror(std::int32_t rise, int first, int last, int strength, int ripples) {
    report_.mirroredRows += last - first;
    if (view_.cuts && !found_->mirrors.empty()) {
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

}  // namespace slicecast

#include "classic/column.h"

#include "base/sort.h"
#include "render/spans/ripples.h"
#include "render/view/frame.h"
#include "world/water.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace slicecast::classic {
namespace {

bool isOpaque(const Shown& shown) {
    return toColour(shown.colour).a == 255;
}

// A thing ready to be blended over the background, or over its reflection.
Pixel layerOf(const Shown& shown) {
    Colour colour = toColour(shown.colour);
    if (shown.mirror > 0) colour.a = static_cast<std::uint8_t>(255 - shown.mirror);
    return toPixel(colour);
}

EyeWater waterAround(const World& world, const Eye& eye) {
    const WaterAt here = waterAt(world, world.maps[static_cast<std::size_t>(eye.map)], eye.x.tile(),
                                 eye.y.tile(), eye.z);
    return {here.water, (here.surface - eye.z).raw};
}

bool isSame(const Mark& a, const Mark& b) {
    return a.part == b.part && a.surface == b.surface && a.shown.what == b.shown.what;
}

}  // namespace

bool Column::Place::isBefore(const Place& second) const {
    if (depth != second.depth) return depth < second.depth;
    if (surface->passing != second.surface->passing)
        return surface->passing < second.surface->passing;
    return surface < second.surface;
}

Column::Column(const World& world, const Eye& eye, const RenderOptions& options,
               const ClassicOptions& classic, LitMaps& lit, int width, int height)
    : world_(world),
      classic_(classic),
      map_(eye.map),
      rows_{classic.pixelSize, (height + classic.pixelSize - 1) / classic.pixelSize},
      view_(world, eye, options, classic, width, height),
      skies_(world, view_, rows_),
      palette_{world, options, classic, lit, skies_, waterAround(world, eye)},
      marks_(static_cast<std::size_t>(rows_.rows)),
      colours_(marks_.size()) {}

const std::vector<Pixel>& Column::draw(double x) {
    for (std::vector<Mark>& marks : marks_) marks.clear();
    used_ = 0;
    Part& part = nextPart();
    part.map = map_;
    part.view = view_;
    part.ray = view_.rayAt(x);
    part.start = {static_cast<int>(std::floor(view_.eyeX)),
                  static_cast<int>(std::floor(view_.eyeY)), 0.0};
    gather(part);
    if (classic_.paintersOrder) {
        paintFarToNear(part);
    } else {
        paintNearest(part);
    }
    colourRows();
    count();
    return colours_;
}

// ---- Parts

Part& Column::nextPart() {
    if (used_ == parts_.size()) parts_.push_back(std::make_unique<Part>());
    Part& part = *parts_[used_++];
    part.portals = 0;
    part.before = nullptr;
    part.door = nullptr;
    return part;
}

void Column::gather(Part& part) {
    const Map& map = world_.maps[static_cast<std::size_t>(part.map)];
    report_.tilesWalked +=
        classic_.march ? marchTiles(map, part.view, part.ray, part.start, classic_, part.spans)
                       : walkTiles(map, part.view, part.ray, part.start, part.spans);
    part.objects = gatherSurfaces(
        {.world = world_,
         .map = map,
         .view = part.view,
         .ray = part.ray,
         .rows = rows_,
         .classic = classic_,
         .isBeyondLimit = part.portals >= world_.portalLimit,
         .begins = part.isMirrored() ? 0.0 : part.start.along * part.ray.depthPerAlong},
        part.spans, part.blocks, part.surfaces);
    report_.blocksMet += static_cast<std::int64_t>(part.blocks.size());
    part.colouring.emplace(palette_, part.map, part.view, part.ray);
    part.overdrawn.clear();
    if (classic_.portalsOverdrawn) findOverdrawn(part);
}

Part& Column::beyond(const Part& from, const Surface& door) {
    for (std::size_t i = 0; i < used_; ++i) {
        if (parts_[i]->door == &door) return *parts_[i];
    }
    const Portal& portal = world_.portals[door.portal];
    Part& part = nextPart();
    part.before = &from;
    part.door = &door;
    part.map = portal.toMap;
    part.portals = from.portals + 1;
    part.view = from.view.beyond(portal);
    part.ray = classic::beyond(from.ray, portal);
    part.start = {portal.toX, portal.toY, door.nearest / from.ray.depthPerAlong};
    gather(part);
    ++report_.partsBehindPortals;
    report_.deepestPortal = std::max(report_.deepestPortal, part.portals);
    return part;
}

Part& Column::mirrored(const Part& from, double height) {
    for (std::size_t i = 0; i < used_; ++i) {
        const Part& part = *parts_[i];
        if (part.before == &from && part.door == nullptr && part.mirrorHeight == height)
            return *parts_[i];
    }
    Part& part = nextPart();
    part.before = &from;
    part.mirrorHeight = height;
    part.map = from.map;
    part.portals = from.portals;
    part.view = from.view.mirroredAt(height);
    part.ray = from.ray;
    part.start = from.start;
    gather(part);
    return part;
}

// ---- Meeting surfaces

Column::Place Column::nextBehind(const Part& part, const Place& last, int row,
                                 const Surface* over) const {
    const double y = rows_.middle(row);
    Place next;
    const auto search = [&](auto first, auto end) {
        // Both lists are sorted by depth: what is before the last place is skipped
        if (!classic_.seams) {
            first = std::partition_point(
                first, end, [&](const Surface& surface) { return surface.farthest < last.depth; });
        }
        for (; first != end; ++first) {
            const Surface& surface = *first;
            if (next.surface != nullptr && surface.nearest > next.depth) return;  // so are others
            if (row < surface.firstRow || row >= surface.lastRow) continue;
            if (over != nullptr && &surface != over && surface.what != FilledRows::What::object)
                continue;
            const Place place = {&surface, surface.depthAt(part.view, part.ray, y)};
            const bool isBehind =
                last.surface == nullptr ? place.depth > last.depth : last.isBefore(place);
            if (!(place.depth < std::numeric_limits<double>::infinity())) continue;
            if (isBehind && (next.surface == nullptr || place.isBefore(next))) next = place;
        }
    };
    const auto begin = part.surfaces.begin();
    const auto tiles = begin + static_cast<std::ptrdiff_t>(part.objects);
    search(begin, tiles);
    search(tiles, part.surfaces.end());
    return next;
}

Part* Column::meet(Part& part, const Surface& surface, int row) {
    std::vector<Mark>& marks = marks_[static_cast<std::size_t>(row)];
    const double y = rows_.middle(row);
    if (surface.portal != kNoPortal) {
        Part& next = beyond(part, surface);
        const double depth = surface.depthAt(part.view, part.ray, y);
        if (next.view.eyeZ + depth * next.view.upwardSlopeAt(y) > 0.0) return &next;
        marks.push_back({&next, nullptr, next.colouring->ofHaze()});
        return nullptr;
    }
    marks.push_back({&part, &surface, part.colouring->ofSurface(surface, y)});
    Shown& shown = marks.back().shown;
    if (part.isMirrored()) shown.mirror = 0;
    if (shown.mirror > 0) return &mirrored(part, surface.plane.height);
    return isOpaque(shown) ? nullptr : &part;
}

Part* Column::meetBackground(Part& part, int row) {
    std::vector<Mark>& marks = marks_[static_cast<std::size_t>(row)];
    marks.push_back({&part, nullptr, part.colouring->ofBackground(rows_.middle(row))});
    return marks.back().shown.mirror > 0 && !classic_.flippedMirrors && !part.isMirrored()
               ? &mirrored(part, 0.0)
               : nullptr;
}

// Follows a row's ray from where the part begins; a portal drawn over the things in front of it
// hides them.
void Column::follow(Part* part, int row) {
    const double y = rows_.middle(row);
    while (part != nullptr) {
        const int overdrawn =
            part->overdrawn.empty() ? -1 : part->overdrawn[static_cast<std::size_t>(row)];
        const Surface* over =
            overdrawn < 0 ? nullptr : &part->surfaces[static_cast<std::size_t>(overdrawn)];
        Place place = {nullptr, part->beginsAt(y)};
        Part* next = part;
        while (next == part) {
            place = marks(row).size() < kMostMarks ? nextBehind(*part, place, row, over) : Place();
            next = place.surface != nullptr ? meet(*part, *place.surface, row)
                                            : meetBackground(*part, row);
        }
        part = next;
    }
}

// ---- Portals drawn over the things in front of them

// Marks the rows of a portal from the first to the last visible one.
void Column::findOverdrawn(Part& part) {
    for (std::size_t i = 0; i < part.surfaces.size(); ++i) {
        const Surface& portal = part.surfaces[i];
        if (portal.portal == kNoPortal) continue;
        int first = portal.firstRow;
        int last = portal.lastRow;
        while (first < last && isMasked(part, portal, first)) ++first;
        while (first < last && isMasked(part, portal, last - 1)) --last;
        if (first == last) continue;
        part.overdrawn.resize(static_cast<std::size_t>(rows_.rows), -1);
        std::fill(part.overdrawn.begin() + first, part.overdrawn.begin() + last,
                  static_cast<int>(i));
    }
}

// Whether something opaque, or another portal, is in front of it. See-through things were drawn
// later, objects last.
bool Column::isMasked(const Part& part, const Surface& portal, int row) const {
    const double y = rows_.middle(row);
    Place place = {nullptr, part.beginsAt(y)};
    while (true) {
        place = nextBehind(part, place, row, nullptr);
        if (place.surface == &portal) return false;
        if (place.surface == nullptr || place.surface->portal != kNoPortal) return true;
        if (!part.colouring->isSeeThrough(*place.surface)) return true;
    }
}

// ---- Painting

void Column::paintNearest(Part& part) {
    for (int row = 0; row < rows_.rows; ++row) follow(&part, row);
    report_.rowsFilled += rows_.rows;
}

void Column::paintFarToNear(Part& part) {
    for (int row = 0; row < rows_.rows; ++row) {
        follow(meetBackground(part, row), row);
        ++report_.rowsFilled;
    }
    std::vector<std::size_t> order(part.surfaces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    mergeSort(order, [&](std::size_t a, std::size_t b) {
        const double distanceA = part.surfaces[a].thingDistance;
        const double distanceB = part.surfaces[b].thingDistance;
        return distanceA != distanceB ? distanceA > distanceB : a < b;
    });
    std::vector<Mark> behind;
    for (const std::size_t index : order) {
        const Surface& surface = part.surfaces[index];
        for (int row = surface.firstRow; row < surface.lastRow; ++row) {
            if (!surface.isMet(part.view, part.ray, rows_.middle(row))) continue;
            std::vector<Mark>& marks = marks_[static_cast<std::size_t>(row)];
            behind.swap(marks);
            marks.clear();
            Part* next = meet(part, surface, row);
            if (next == &part) {
                marks.insert(marks.end(), behind.begin(), behind.end());
            } else {
                follow(next, row);
            }
            ++report_.rowsFilled;
        }
    }
}

// Which of a row's marks is a mirror, or -1.
int Column::mirrorIn(int row) const {
    const std::vector<Mark>& marks = this->marks(row);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (marks[i].shown.mirror > 0) return static_cast<int>(i);
    }
    return -1;
}

// The row whose reflection a mirror's row shows: ripples lead to another one, as far as the same
// mirror goes on.
int Column::rippledRow(int row) const {
    const auto markOf = [&](int at) -> const Mark* {
        const int mirror = at >= 0 && at < rows_.rows ? mirrorIn(at) : -1;
        return mirror < 0 ? nullptr : &marks(at)[static_cast<std::size_t>(mirror)];
    };
    const Mark& mirror = *markOf(row);
    if (mirror.shown.ripples == 0) return row;
    const View& view = mirror.part->view;
    const auto heightOf = [](const Mark& mark) {
        return mark.surface != nullptr ? mark.surface->plane.height : 0.0;
    };
    const double y = rows_.middle(row);
    const double along = mirror.shown.texel.depth / mirror.part->ray.depthPerAlong;
    const auto place = [&](double eye, double direction) {
        return static_cast<int>(std::floor(256.0 * (eye + along * direction)));
    };
    const int moved =
        rippledBy({place(view.eyeX, mirror.part->ray.x), place(view.eyeY, mirror.part->ray.y),
                   static_cast<int>(world_.steps & 1023), mirror.shown.ripples, y - view.horizon,
                   (view.eyeZ - heightOf(mirror)) * view.distance},
                  mostRippleRows(static_cast<int>(view.height)));
    const int end = static_cast<int>(std::floor((y + moved) / rows_.pixelSize));
    const int way = end < row ? -1 : 1;
    const auto isSame = [&](const Mark* other) {
        return other != nullptr && other->part->map == mirror.part->map &&
               other->part->view.eyeX == view.eyeX && other->part->view.eyeY == view.eyeY &&
               other->part->view.eyeZ == view.eyeZ && heightOf(*other) == heightOf(mirror);
    };
    while (row != end && isSame(markOf(row + way))) row += way;
    return row;
}

// Blends each row from back to front. A flipping floor shows the row equally far above the upper
// end of its run.
void Column::colourRows() {
    // Lays some marks of a row over a colour
    const auto lay = [&](int row, std::size_t first, std::size_t last, Pixel colour) {
        while (last-- > first) colour = laidOver(layerOf(marks(row)[last].shown), colour);
        return colour;
    };
    int foot = 0;
    for (int row = 0; row < rows_.rows; ++row) {
        const Shown& last = marks(row).back().shown;
        const std::size_t behind = marks(row).size() - 1;
        const auto mirror = static_cast<std::size_t>(mirrorIn(row) + 1);
        if (last.what != FilledRows::What::floor) foot = row + 1;
        const int flipped = 2 * foot - 1 - row;
        Pixel& colour = colours_[static_cast<std::size_t>(row)];
        if (classic_.flippedMirrors && last.mirror > 0 && flipped >= 0) {
            colour = lay(row, 0, behind + 1, colours_[static_cast<std::size_t>(flipped)]);
        } else if (mirror > 0 && mirror <= behind) {
            const int from = rippledRow(row);
            const std::size_t end = marks(from).size() - 1;
            const auto begin = static_cast<std::size_t>(mirrorIn(from) + 1);
            colour = lay(row, 0, mirror, lay(from, begin, end, marks(from).back().shown.colour));
        } else {
            colour = lay(row, 0, behind, last.colour);
        }
    }
}

void Column::count() {
    for (std::size_t row = 0; row < marks_.size(); ++row) {
        const std::vector<Mark>& marks = marks_[row];
        for (std::size_t i = 0; i < marks.size(); ++i) {
            const Mark& mark = marks[i];
            if (mark.shown.mirror > 0) ++report_.mirroredRows;
            if (row > 0 && i < marks_[row - 1].size() && isSame(mark, marks_[row - 1][i])) continue;
            ++report_.spansDrawn;
            if (mark.shown.what == FilledRows::What::object) ++report_.objectSlices;
            if (i + 1 < marks.size() && mark.shown.mirror == 0) ++report_.layers;
        }
    }
}

}  // namespace slicecast::classic

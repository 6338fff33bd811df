#include "render/plain_walk.h"

#include "base/bits.h"
#include "base/sort.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace slicecast {
namespace {

// A point on the border of two texels may come out a rounding before it: positions are moved by
// this much of a tile.
constexpr double kSnap = 1.0 / 17179869184.0;

constexpr double kOne = 281474976710656.0;  // a tile as a texture position, 2^48

// The tile before a border that is crossed, and the tile behind it.
struct Neighbour {
    int x;
    int y;
};
Neighbour neighbour(const GridWalk& walk, const Crossing& border, int steps) {
    return {walk.tileX + (border.alongX ? steps * walk.stepX : 0),
            walk.tileY + (border.alongX ? 0 : steps * walk.stepY)};
}

// Where a column of texels begins and how far it goes from row to row; it stays in [lowest, end).
struct Positions {
    double start;
    double step;
    std::int64_t lowest;
    std::int64_t end;
};
void place(TexelColumn& column, const Positions& at, int rows) {
    const auto within = [&](double position) {
        return nearestInteger(std::clamp(position, 0.0, static_cast<double>(at.end)));
    };
    const std::int64_t start = std::clamp(within(at.start), at.lowest, at.end - 1);
    column.start = static_cast<std::uint64_t>(start);
    column.step = 0;
    if (rows > 1)
        column.step = static_cast<std::uint64_t>(
            std::min(within(at.step), (at.end - 1 - start) / (rows - 1)));
}

// The ray at an object's depth: no border of a tile.
Crossing crossingAt(const FrameObject& object, const Projection& projection) {
    Crossing at;
    at.along = object.along;
    at.distance = object.depth;
    at.speed = projection.distance;
    at.rowsPerRaw = projection.distance / object.depth * (1.0 / 65536.0);
    at.border = false;
    return at;
}

// Where a column's ray passes an object, as a share of its width from the left.
double across(const FrameObject& object, const Projection& projection, int column) {
    return (projection.sidewaysSlope(column) * object.depth - object.left) / object.width;
}

}  // namespace

// ---- the walk

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

// Each part may add further ones.
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
    objects_.clear();
    for (const int i : part_.vista->objects.inColumn(column_)) {
        const FrameObject& object = part_.vista->objects[i];
        const double share = across(object, projection(), column_);
        if (object.along >= walk_.entered && share >= 0.0 && share < 1.0)
            objects_.push_back(&object);
    }
    for (;; walk_.advance()) {
        enter_ = walk_.enter();
        leave_ = walk_.leave();
        if (open_.none() || (isGridLeft() && objects_.empty())) break;
        ++part_.tiles;
        // A portal tile does not act on an eye that is in it, nor on what arrives.
        const PortalId portal = map().tilePortal(walk_.tileX, walk_.tileY);
        if (part_.tiles > 1 && portal != kNoPortal) {
            part_.endsInPortal = true;
            const Rows aboveFloor = {0, rowBelow(riseOf(0), enter_)};
            if (acts(portal)) sendThrough(portal, aboveFloor, {});
            show(spanOf(What::haze), {0, projection().height}, [](Span&) {});
            return;
        }
        meetTile();
    }
    meetBackground();
}

// Whether the tile is outside the grid, and not on the way to it.
bool PlainWalk::isGridLeft() const {
    const auto isBehind = [](int tile, int tiles, int step) {
        return tile < 0 ? step <= 0 : tile >= tiles && step >= 0;
    };
    return isBehind(walk_.tileX, map().width, walk_.stepX) ||
           isBehind(walk_.tileY, map().depth, walk_.stepY);
}

// An object lies behind what is met before its depth, and before the rest.
void PlainWalk::meetTile() {
    const Crossing leave = leave_;
    while (!objects_.empty() && objects_.front()->along < leave.along) {
        const FrameObject& object = *objects_.front();
        objects_.erase(objects_.begin());
        leave_ = crossingAt(object, projection());
        meetStretch();
        meetObject(object);
        enter_ = leave_;
    }
    leave_ = leave;
    meetStretch();
}

// What lies in the tile between `enter_` and `leave_`.
void PlainWalk::meetStretch() {
    findBlocks();
    findPlanes();
    if (enter_.border) {
        for (const Block& block : blocks_) enterSide(block);
    }
    for (const LevelPlane& plane : planes_) meetPlane(plane);
    if (leave_.border && leave_.along > 0.0) {
        for (const Block& block : blocks_) leaveSide(block);
    }
}

// Beyond the grid the floor has no end.
void PlainWalk::meetBackground() {
    meetFloor({0, rowBelow(riseOf(0), enter_)}, true);
    show(spanOf(What::sky), {0, projection().firstFallingRow}, [](Span&) {});
    show(spanOf(What::haze), {0, projection().height}, [](Span&) {});
}

// ---- what a tile holds

// The blocks, as far as they lie between the heights of the part's rays.
void PlainWalk::findBlocks() {
    blocks_.clear();
    const HeightClip& clip = part_.clip;
    for (int level = 0; level < map().levels; ++level) {
        const BlueprintId id = map().cell(walk_.tileX, walk_.tileY, level);
        if (id == kEmptyCell) continue;
        const CellBlueprint& blueprint = frame_.world->blueprints[id];
        const std::int32_t bottom = riseOf(tileEdge(level).raw) + blueprint.bottom.raw;
        const std::int32_t top = riseOf(tileEdge(level).raw) + blueprint.top.raw;
        if (top <= clip.low || bottom >= clip.high) continue;
        const bool cut =
            bottom < clip.low || top > clip.high || (clip.isMirror && bottom == clip.low);
        blocks_.push_back(
            {&blueprint, level, std::max(bottom, clip.low), std::min(top, clip.high), cut});
    }
}

// The level planes, from the eye's height upwards and downwards: a ray meets those of its own
// direction in that order. At one height the face of the block that is left comes first, then that
// of the block entered, then ceiling or floor.
void PlainWalk::findPlanes() {
    planes_.clear();
    for (const Block& block : blocks_) {
        if (block.top > 0) planes_.push_back({What::roof, block.top, block});
        if (block.bottom < 0) planes_.push_back({What::underside, block.bottom, block});
    }
    for (const Block& block : blocks_) {
        if (block.top <= 0) planes_.push_back({What::roof, block.top, block});
        if (block.bottom > 0) planes_.push_back({What::underside, block.bottom, block});
    }
    planes_.push_back({What::ceiling, riseOf(map().ceiling.height.raw), {}});
    planes_.push_back({What::floor, riseOf(0), {}});
    mergeSort(planes_, [](const LevelPlane& a, const LevelPlane& b) {
        return std::abs(a.rise) < std::abs(b.rise);
    });
}

// A side at depth 0 is not drawn, but its portal acts.
void PlainWalk::enterSide(const Block& block) {
    const Face face = enteredFace(enter_);
    const Rows rows = {rowBelow(block.top, enter_), rowBelow(block.bottom, enter_)};
    if (acts(portalOf(block, face))) {
        sendThrough(portalOf(block, face), rows, {});
    } else if (enter_.along > 0.0 && !joinsTileBefore(block)) {
        showSide(block, face, enter_, rows);
    }
}

// Behind the side there may be another block that it joins, seen through a portal or not.
void PlainWalk::leaveSide(const Block& block) {
    const Face face = leftFace(leave_);
    const Rows rows = {rowBelow(block.top, leave_), rowBelow(block.bottom, leave_)};
    if (portalOf(block, face) != kNoPortal) return;
    const Neighbour next = neighbour(walk_, leave_, 1);
    const bool mayPass = part_.portals < frame_.world->portalLimit;
    if (const PortalId tile = map().tilePortal(next.x, next.y); tile != kNoPortal) {
        if (!mayPass || !isSame(block, exitCell(tile, block.level)))
            showSide(block, face, leave_, rows);
        return;
    }
    const BlueprintId behind = map().cell(next.x, next.y, block.level);
    const CellBlueprint& blueprint = frame_.world->blueprints[behind];
    const PortalId portal = blueprint.face(enteredFace(leave_)).portal;
    if (portal != kNoPortal && mayPass && isSame(block, exitCell(portal, block.level))) {
        // Beside the portal, which may be smaller than the side.
        const std::int32_t base = riseOf(tileEdge(block.level).raw);
        const int portalTop = rowBelow(base + blueprint.top.raw, leave_);
        const int portalBottom = rowBelow(base + blueprint.bottom.raw, leave_);
        showSide(block, face, leave_, {rows.first, std::min(rows.last, portalTop)});
        showSide(block, face, leave_, {std::max(rows.first, portalBottom), rows.last});
    } else if (!isSame(block, behind)) {
        showSide(block, face, leave_, rows);
    }
}

// Rows whose rays pass the plane's height between the two borders: falling ones see it if it is
// below the eye, rising ones if it is above.
void PlainWalk::meetPlane(const LevelPlane& plane) {
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
        // Whoever stands exactly on a portal falls in at once.
        if (plane.rise == 0 && !walk_.hasEntered() && acts(portalOf(plane.block, Face::top)))
            rows = {horizon, projection().height};
        meetFace(plane, rows);
    }
}

// A roof or an underside. A portal acts on what enters; what leaves sees nothing there.
void PlainWalk::meetFace(const LevelPlane& plane, Rows rows) {
    const Block& block = plane.block;
    const bool isTop = plane.what == What::roof;
    const bool leaving = isTop == (plane.rise > 0);
    const FaceBlueprint& look = block.blueprint->face(isTop ? Face::top : Face::bottom);
    if ((leaving && look.portal != kNoPortal) || (!leaving && block.cut)) return;
    if (acts(look.portal)) {
        HeightClip beyond;
        (isTop ? beyond.high : beyond.low) = plane.rise;
        return sendThrough(look.portal, rows, beyond);
    }
    if (look.texture == kNoTexture || joinsLevel(block, isTop ? 1 : -1, leaving)) return;
    const int strength = leaving ? 0 : mirrorStrength(look.mirror);
    Span span = spanOf(plane.what);
    span.face = isTop ? Face::top : Face::bottom;
    span.level = block.level;
    span.layer = block.blueprint->seeThrough && strength == 0;
    span.plane = {plane.rise, look.texture, look.light, look.glow, !isTop, strength > 0};
    show(span, rows, [&](const Span& seen) {
        if (strength > 0)
            found_->mirrors.push_back(
                {number_, plane.rise, seen.first, seen.last, static_cast<std::uint32_t>(strength)});
    });
}

// Rows that look beyond the map's `far` are left for the haze.
void PlainWalk::meetFloor(Rows rows, bool endless) {
    const Floor& floor = map().floor;
    if (riseOf(0) >= 0) return;
    rows.first = std::max(rows.first, part_.vista->firstFloorRow);
    const int strength = mirrorStrength(floor.mirror);
    Span span = spanOf(What::floor);
    span.tiles.endless = endless;
    span.plane = {riseOf(0), floor.texture, floor.light, floor.glow, false, strength > 0};
    if (map().contains(walk_.tileX, walk_.tileY))
        span.plane.texture = floor.tiles[map().tileIndex(walk_.tileX, walk_.tileY)];
    show(span, rows, [&](const Span& seen) {
        if (strength > 0)
            found_->mirrors.push_back(
                {number_, riseOf(0), seen.first, seen.last, static_cast<std::uint32_t>(strength)});
    });
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
    span.plane = {rise, texture, ceiling.light, ceiling.glow, true, false};
    show(span, rows, [](Span&) {});
}

// A row through the height of its lower edge is on the object, one through its upper edge is not.
void PlainWalk::meetObject(const FrameObject& object) {
    const auto rowAt = [&](std::int32_t rise, bool tieIsBelow) {
        return FrameObjects::firstRowBelow(projection(), rise, object.depth, tieIsBelow);
    };
    const HeightClip& clip = part_.clip;
    const Rows rows = {object.top <= clip.high ? object.firstRow : rowAt(clip.high, true),
                       object.bottom >= clip.low ? object.lastRow : rowAt(clip.low, false)};
    const SpriteLevel& level = *object.level;
    const double share = across(object, projection(), column_);
    const int u = std::min(level.width - 1, static_cast<int>(share * level.width));
    Span span = spanOf(What::object);
    span.layer = true;
    span.object = object.index;
    span.plane.texture = map().objects[static_cast<std::size_t>(object.index)].sprite;
    span.column = {.texels = level.texels.data() + static_cast<std::ptrdiff_t>(u) * level.height,
                   .shift = 32,
                   .detail = object.detail,
                   .start = 0,
                   .step = 0,
                   .factor = object.factor,
                   .fog = object.fog,
                   .depth = object.depth};
    const std::int64_t end = static_cast<std::int64_t>(level.height) << 32;
    const double perUnit = static_cast<double>(end) / ((object.top - object.bottom) / 65536.0);
    show(span, rows, [&](Span& seen) {
        const double down =
            object.top / 65536.0 - (projection().horizon - (seen.first + 0.5)) * object.along;
        place(seen.column, {down * perUnit, object.along * perUnit, 0, end},
              seen.last - seen.first);
    });
}

// ---- see-through blocks that join

bool PlainWalk::isSame(const Block& block, BlueprintId other) const {
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
        return isSame(block, before.map->cell(before.x, before.y, block.level - before.levels));
    const Neighbour tile = neighbour(walk_, enter_, -1);
    return isSame(block, map().cell(tile.x, tile.y, block.level));
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

// ---- portals and mirrors

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
    Neighbour from = {walk_.tileX, walk_.tileY};
    int hazeRow = 0;
    if (clip.any()) {
        const std::int32_t height = clip.high != HeightClip{}.high ? clip.high : clip.low;
        const bool isBelow = height < floorRise || (height == 0 && floorRise == 0);
        hazeRow = isBelow ? 0 : projection().height;
    } else {
        hazeRow = rowBelow(floorRise, enter_);
        from = neighbour(walk_, enter_, -1);
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

// Adds a span for each run of open rows, which `finish` completes, and closes them unless it is a
// layer.
template <typename Finish>
void PlainWalk::show(const Span& look, Rows rows, Finish finish) {
    const auto add = [&](int first, int last) {
        if (look.layer && ++found_->layers > kMaxLayers) {
            found_->layers = kMaxLayers;
            return;
        }
        Span& span = found_->spans.add();
        span = look;
        span.first = first;
        span.last = last;
        finish(span);
    };
    if (look.layer) {
        open_.each(rows.first, rows.last, add);
    } else {
        open_.take(rows.first, rows.last, add);
    }
}

void PlainWalk::showSide(const Block& block, Face face, const Crossing& border, Rows rows) {
    if (block.blueprint->face(face).texture == kNoTexture) return;
    Span span = spanOf(What::side);
    span.face = face;
    span.level = block.level;
    span.layer = block.blueprint->seeThrough;
    span.plane.texture = block.blueprint->face(face).texture;
    show(span, rows, [&](Span& seen) {
        seen.column = sideColumn(block, face, border, {seen.first, seen.last});
    });
}

// Which texels of a side the rows show, and in what light.
TexelColumn PlainWalk::sideColumn(const Block& block, Face face, const Crossing& border,
                                  Rows rows) const {
    const Vista& vista = *part_.vista;
    const FaceBlueprint& look = block.blueprint->face(face);
    const FrameTexture& texture = frame_.textures[look.texture];
    TexelColumn column;
    column.depth = border.along * projection().distance;
    column.detail = frame_.detail.levelAt(column.depth, texture.size, texture.last);
    column.factor = vista.lighting.factorAt(column.depth, look.light, look.glow);
    column.fog = vista.lighting.fogAt(column.depth);

    // Where the ray meets the border: how far from its northern or western end.
    const Viewpoint& eye = vista.viewpoint;
    const GroundDirection ray = vista.ray(column_);
    const double fraction = border.alongX ? eye.fractionY() + (eye.tileY() - walk_.tileY) +
                                                ray.y * border.distance / border.speed
                                          : eye.fractionX() + (eye.tileX() - walk_.tileX) +
                                                ray.x * border.distance / border.speed;
    const TextureLevel& level = texture.levels[column.detail];
    const double texel = std::max(0.0, fraction + kSnap) * level.size;
    int u = static_cast<int>(std::min(texel, level.size - 1.0));
    if (face == Face::north || face == Face::east) u = level.size - 1 - u;
    column.texels = level.texels.data() + static_cast<std::ptrdiff_t>(u) * level.size;
    column.shift = kTexturePositionBits - level.bits;

    // And how far below the level's upper edge; within what the block covers of the level.
    const double upperEdge = riseOf(tileEdge(block.level + 1).raw) / 65536.0;
    const double down =
        upperEdge + (rows.first + 0.5 - projection().horizon) * border.along + kSnap;
    const auto positionOf = [](Coordinate height) {
        return (std::int64_t{65536} - height.raw) << (kTexturePositionBits - 16);
    };
    place(column,
          {down * kOne, border.along * kOne, positionOf(block.blueprint->top),
           positionOf(block.blueprint->bottom)},
          rows.last - rows.first);
    return column;
}

}  // namespace slicecast

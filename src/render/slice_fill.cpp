// A slice's rows filled: which texels, which light.
#include "base/bits.h"
#include "render/column_fill.h"
#include "render/slice.h"

#include <algorithm>
#include <limits>

namespace slicecast {
namespace {

// A point that lies on the border of two texels exactly may come out a rounding before it:
// positions are moved by this much of a tile, far less than a pixel and far more than a rounding.
constexpr double kSnap = 1.0 / 17179869184.0;

// Half a step of the fraction that is kept; nearer to the end of a tile than that, it would round
// up to the next one.
constexpr double kHalfStep = 1.0 / 8589934592.0;

// Whether a position lies within a rounding before the border on which the eye is.
bool isRoundedToEye(double position) {
    return position < 0.0 && position >= -kHalfStep;
}

// The fraction of a tile at a position of a plane's row, in 1/2^32, held within [first, end). On a
// border between tiles within it is 0, or as far as it goes if the point belongs to the tile
// `before`; along a border on which the eye is, the ray's direction tells.
__attribute__((noinline)) std::uint32_t held(double first, double end, double start,
                                             double perInverse, double inverse, bool before) {
    constexpr std::uint32_t kEnd = ~std::uint32_t{0};
    const double position = start + perInverse * inverse;
    if (position < first + kHalfStep) return 0;
    if (position >= end - kHalfStep) return kEnd;
    const std::uint32_t bits = PlaneLine::fractionBits(start, perInverse, inverse);
    if (bits != 0) return bits;
    const bool isAlong =
        start == 0.0 && perInverse != 0.0 && position < kHalfStep && position >= -kHalfStep;
    return (isAlong ? perInverse < 0.0 : before) ? kEnd : 0;
}

constexpr std::uint64_t kWholeTexture = std::uint64_t{1} << kTexturePositionBits;

// The texture of what moves may come to its lower edge within a side, and begins anew there. Cuts
// the part above off a run and gives it; the run is empty when there is none left.
SideRun takeTurn(SideRun& run) {
    if (run.start >= kWholeTexture) run.start -= kWholeTexture;
    SideRun part = run;
    const auto rows = static_cast<std::uint64_t>(run.last - run.first);
    if (run.start + (rows - 1) * run.step >= kWholeTexture) {
        const std::uint64_t above = (kWholeTexture - run.start + run.step - 1) / run.step;
        part.last = part.first + static_cast<int>(above);
        run.start += above * run.step - kWholeTexture;
    }
    run.first = part.last;
    return part;
}

}  // namespace

// What the sides at one border have in common.
Slice::SideView Slice::sideView(const Crossing& border) const {
    // Along x on the northern and southern sides, along y on the others.
    const double fraction =
        border.alongX
            ? eyeFractionY_ + (eyeTileY_ - walk_.tileY) + ray_.y * border.distance / border.speed
            : eyeFractionX_ + (eyeTileX_ - walk_.tileX) + ray_.x * border.distance / border.speed;
    const double depth = border.along * projection_->distance;
    constexpr double kEnd = 4294967295.0;  // of 1 << 32
    return {
        static_cast<std::uint32_t>(std::min(kEnd, std::max(0.0, fraction + kSnap) * 4294967296.0)),
        depth, vista_->lighting.brightnessAt(depth), vista_->lighting.fogAt(depth)};
}

// Which texels the rows [first, last) of a side show, and in what light.
__attribute__((always_inline)) inline SideRun Slice::sideRun(const Block& block, Face face,
                                                             const Crossing& border,
                                                             const SideView& view, int first,
                                                             int last) const {
    const FaceBlueprint& look = block.blueprint->face(face);
    const FrameTexture& texture = frame_.textures[look.texture];
    const TextureLevel& level =
        texture.levels[frame_.detail.levelAt(view.depth, texture.size, texture.last)];
    const int column = static_cast<int>(std::uint64_t{view.fraction} >> (32 - level.bits));
    const int u = face == Face::north || face == Face::east ? level.size - 1 - column : column;

    // v runs from 0 at the level's upper edge to 1 at its lower edge; it stays within what the
    // block covers of the level. What has risen shows what is farther down: see takeTurn.
    constexpr double kPositions = 281474976710656.0;  // 1 << kTexturePositionBits
    constexpr std::int64_t kPositionsPerRaw = std::int64_t{1} << (kTexturePositionBits - 16);
    const std::int64_t lowest = (65536 - block.blueprint->top.raw) * kPositionsPerRaw;
    const std::int64_t end = (65536 - block.blueprint->bottom.raw) * kPositionsPerRaw;
    const double perRow = border.along;
    const double upperEdge = Coordinate{tileEdge(block.level + 1).raw - eyeZ_}.value();
    const double v = upperEdge + (first + 0.5 - projection_->horizon) * perRow + kSnap;
    const std::int64_t start = std::clamp(v <= 0.0   ? 0
                                          : v >= 1.0 ? end
                                                     : nearestInteger(v * kPositions),
                                          lowest, end - 1);
    const int steps = last - first - 1;
    // A block of several rows is no higher than a tile, so a row's step is less.
    std::int64_t step = steps > 0 ? nearestInteger(std::min(perRow, 1.0) * kPositions) : 0;
    if (start + steps * step >= end) step = (end - 1 - start) / steps;
    const std::int64_t rise = block.blueprint->textureRise.raw * kPositionsPerRaw;
    return {level.texels.data() + (static_cast<std::size_t>(u) << level.bits),
            kTexturePositionBits - level.bits,
            first,
            last,
            static_cast<std::uint64_t>(start + rise),
            static_cast<std::uint64_t>(step),
            vista_->lighting.factorOf(look.glow ? kFullBrightness : view.brightness, look.light),
            view.fog,
            vista_->lighting.haze};
}

void Slice::drawSide(const Block& block, Face face, const Crossing& border, const SideView& view,
                     int firstRow, int lastRow) {
    open_.take(firstRow, lastRow, [&](int first, int last) {
        SideRun run = sideRun(block, face, border, view, first, last);
        count(first, last);
        while (run.first < run.last) {
            const SideRun part = takeTurn(run);
            if (waterFogs_ != nullptr) {
                fillFromWater(part, Lay::opaque);
            } else {
                fillSide(pixels_ + part.first, part.last - part.first, part.texels, part.shift,
                         part.start, part.step, part.factor, part.fog, part.haze);
            }
        }
        if (trace_) traceSide(block, face, border, view, first, last, false);
    });
}

// Rows whose rays leave the eye's water before they come to the side have the fog of where they
// leave it. They are the upper ones.
void Slice::fillFromWater(const SideRun& run, Lay lay) {
    SideRun rest = run;
    const auto fill = [&](int rows, std::uint32_t fog) {
        fillSide(pixels_ + rest.first, rows, rest.texels, rest.shift, rest.start, rest.step,
                 rest.factor, fog, rest.haze, lay);
    };
    for (; rest.first < rest.last && waterFogs_[rest.first] < rest.fog; ++rest.first) {
        fill(1, waterFogs_[rest.first]);
        rest.start += rest.step;
    }
    if (rest.first < rest.last) fill(rest.last - rest.first, rest.fog);
}

void Slice::seeThroughSide(const Block& block, Face face, const Crossing& border,
                           const SideView& view, int firstRow, int lastRow) {
    open_.each(firstRow, lastRow, [&](int first, int last) {
        SideRun run = sideRun(block, face, border, view, first, last);
        while (run.first < run.last) layers_->add(takeTurn(run));
        if (trace_) traceSide(block, face, border, view, first, last, true);
    });
}

void Slice::traceSide(const Block& block, Face face, const Crossing& border, const SideView& view,
                      int first, int last, bool layer) {
    const TextureId texture = block.blueprint->face(face).texture;
    FilledRows& rows =
        traceRun(block.level, FilledRows::What::side, face, first, last, texture, layer);
    const FrameTexture& shown = frame_.textures[texture];
    const SideRun run = sideRun(block, face, border, view, first, last);
    const int detail = frame_.detail.levelAt(view.depth, shown.size, shown.last);
    const TextureLevel& level = shown.levels[detail];
    const auto texelAt = [&](int row) {
        return TracedTexel{
            view.depth,
            detail,
            static_cast<int>((run.texels - level.texels.data()) >> level.bits),
            static_cast<int>(((run.start + static_cast<std::uint64_t>(row - first) * run.step) &
                              (kWholeTexture - 1)) >>
                             run.shift),
            run.factor,
            fogOf(run.fog, row)};
    };
    rows.top = texelAt(first);
    rows.bottom = texelAt(last - 1);
    if (watches(first, last)) tracePoint(texelAt(trace_->watchedRow));
    rows.rowsOfDetail[static_cast<std::size_t>(detail)] = static_cast<std::uint16_t>(last - first);
}

// Fills a run's rows, if there are any, and leaves it empty.
void Slice::fill(PlaneRun& run) {
    if (run.first == run.last) return;
    if (frame_.textures[run.plane.texture].seeThrough && !run.plane.mirror) {
        // Only a floor closes its rows although it is see-through: below it there is haze.
        std::fill(pixels_ + run.first, pixels_ + run.last, vista_->lighting.haze);
        count(run.first, run.last);
        layers_->add(run, *vista_);
    } else {
        fillRows(run, Lay::opaque);
    }
    run.first = run.last = -1;
}

// The first and the last rows may lie within a rounding of their tiles' border, all of them where
// the ray runs along it: their texel is held inside, so that never one of the far side of the
// texture shows.
void Slice::fillRows(const PlaneRun& run, Lay lay) {
    count(run.first, run.last);
    const Plane& plane = run.plane;
    const double distance = Coordinate{plane.rise < 0 ? -plane.rise : plane.rise}.value();
    const PlaneLine line = {eyeFractionX_, eyeFractionY_, distance * ray_.x, distance * ray_.y,
                            plane.southReversed};
    const PlaneRows rows =
        vista_->planeShades.rows(plane.rise, plane.light, plane.glow, run.first, run.last);
    if (isOnBorder(run, line, rows)) return fillRowByRow(run, line, rows, run.first, run.last, lay);
    const TileBox box = boxAround(run);
    int first = run.first;
    int last = run.last;
    while (first < last && !isInside(box, line, rows.inverseOffsets[first])) ++first;
    while (first < last && !isInside(box, line, rows.inverseOffsets[last - 1])) --last;
    if (run.first < first) fillRowByRow(run, line, rows, run.first, first, lay);
    if (last < run.last) fillRowByRow(run, line, rows, last, run.last, lay);
    if (first < last) fillInside(run, line, rows, first, last, lay);
}

// The rows are split where the level of detail changes.
void Slice::fillInside(const PlaneRun& run, const PlaneLine& line, const PlaneRows& rows, int first,
                       int last, Lay lay) {
    const FrameTexture& texture = frame_.textures[run.plane.texture];
    const double depthPerInverse =
        Coordinate{run.plane.rise < 0 ? -run.plane.rise : run.plane.rise}.value() *
        projection_->distance;
    const auto levelAt = [&](int row) {
        return frame_.detail.levelAt(depthPerInverse * rows.inverseOffsets[row], texture.size,
                                     texture.last);
    };
    const auto fillTo = [&](int from, int end, int level) {
        fillPlane(pixels_, from, end, texture.levels[level], line, rows, vista_->lighting.haze,
                  lay);
    };
    const int firstLevel = levelAt(first);
    const int lastLevel = last - first == 1 ? firstLevel : levelAt(last - 1);
    int row = first;
    for (int level = firstLevel; level != lastLevel;) {
        int same = row;  // the last row known to have this level; the first known not to is `end`
        int end = last - 1;
        while (end - same > 1) {
            const int middle = same + (end - same) / 2;
            (levelAt(middle) == level ? same : end) = middle;
        }
        fillTo(row, end, level);
        row = end;
        level = levelAt(row);
    }
    fillTo(row, last, lastLevel);
}

// A point on the border of two tiles exactly belongs to the one behind it, for the eye counts as a
// trifle further east and south. Behind a portal that turns, that may be west or north: then it
// belongs to the one before, and its fraction there is 1 and not 0.
bool Slice::isOnBorder(const PlaneRun& run, const PlaneLine& line, const PlaneRows& rows) const {
    const int turn = vista_->viewpoint.turn;
    if (turn == 0) return false;
    bool any = false;
    for (int row = run.first; row < run.last; ++row) {
        const double inverse = rows.inverseOffsets[row];
        const bool east =
            PlaneLine::fractionBits(line.eastStart, line.eastPerInverse, inverse) == 0;
        const bool south =
            PlaneLine::fractionBits(line.southStart, line.southPerInverse, inverse) == 0;
        any |= (east && turn != 3) || (south && turn != 1);
    }
    return any;
}

// Those are rare, so a run that has one is drawn slowly, row by row.
void Slice::fillRowByRow(const PlaneRun& run, const PlaneLine& line, const PlaneRows& rows,
                         int first, int last, Lay lay) {
    const FrameTexture& texture = frame_.textures[run.plane.texture];
    const TileBox box = boxAround(run);
    const double depthPerInverse =
        Coordinate{run.plane.rise < 0 ? -run.plane.rise : run.plane.rise}.value() *
        projection_->distance;
    for (int row = first; row < last; ++row) {
        const double inverse = rows.inverseOffsets[row];
        const PlanePoint point = planePoint(line, box, inverse);
        drawPlaneTexel(row,
                       texture.levels[frame_.detail.levelAt(depthPerInverse * inverse, texture.size,
                                                            texture.last)],
                       point.east, point.south, line.southReversed, rows, lay, pixels_[row]);
    }
}

Slice::PlanePoint Slice::planePoint(const PlaneLine& line, const TileBox& box,
                                    double inverse) const {
    const int turn = vista_->viewpoint.turn;
    return {held(box.east, box.eastEnd, line.eastStart, line.eastPerInverse, inverse,
                 turn == 1 || turn == 2),
            held(box.south, box.southEnd, line.southStart, line.southPerInverse, inverse,
                 turn == 2 || turn == 3)};
}

// One row from the texel at a fraction of a tile, in 1/2^32.
void Slice::drawPlaneTexel(int row, const TextureLevel& level, std::uint32_t east,
                           std::uint32_t south, bool southReversed, const PlaneRows& rows, Lay lay,
                           Pixel there) {
    const auto texelOf = [&](std::uint32_t bits) {
        return static_cast<std::uint32_t>(static_cast<std::uint64_t>(bits) >> (32 - level.bits));
    };
    const std::uint32_t u = texelOf(east);
    std::uint32_t v = texelOf(south);
    if (southReversed) v = static_cast<std::uint32_t>(level.size - 1) - v;
    pixels_[row] =
        shadedTexel(level.texels[(u << level.bits) | v], rows.factors[row] & 0xffff,
                    rows.fogs ? rows.fogs[row] & 0xffff : 0, vista_->lighting.haze, lay, there);
}

Slice::TileBox Slice::boxAround(const PlaneRun& run) const {
    TileBox box = {static_cast<double>(std::min(run.fromX, run.toX) - eyeTileX_),
                   static_cast<double>(std::max(run.fromX, run.toX) + 1 - eyeTileX_),
                   static_cast<double>(std::min(run.fromY, run.toY) - eyeTileY_),
                   static_cast<double>(std::max(run.fromY, run.toY) + 1 - eyeTileY_)};
    if (run.endless) {
        constexpr double kNever = std::numeric_limits<double>::infinity();
        if (ray_.x > 0.0) box.eastEnd = kNever;
        if (ray_.x < 0.0) box.east = -kNever;
        if (ray_.y > 0.0) box.southEnd = kNever;
        if (ray_.y < 0.0) box.south = -kNever;
    }
    return box;
}

// Whether a row's point lies within the run's tiles, and by more than a rounding.
bool Slice::isInside(const TileBox& box, const PlaneLine& line, double inverse) {
    const double east = line.eastStart + line.eastPerInverse * inverse;
    const double south = line.southStart + line.southPerInverse * inverse;
    return east >= box.east && east < box.eastEnd - kHalfStep && south >= box.south &&
           south < box.southEnd - kHalfStep && !isRoundedToEye(east) && !isRoundedToEye(south);
}

}  // namespace slicecast

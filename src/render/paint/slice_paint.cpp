#include "render/paint/slice_paint.h"

#include "render/light/lit_texels.h"
#include "render/light/smooth_light.h"
#include "render/paint/lit_planes.h"
#include "render/spans/ripples.h"

#include <algorithm>

namespace slicecast {
namespace {

using What = FilledRows::What;

}  // namespace

void SlicePainter::paint(const SliceSpans& slice, Pixel* pixels) {
    column_ = slice.column;
    pixels_ = pixels;
    waterFogs_ = frame_.vistas.waterFogs();
    paintOpaque(slice.upright);
    if (!slice.upright.mirrors.empty()) paintReflection(slice);
    if (slice.upright.layers > 0) paintLayers(slice.upright);
}

void SlicePainter::paintOpaque(const ColumnSpans& column) {
    sides_.find(column);
    for (const Span& span : column.spans) {
        if (span.layer) continue;
        switch (span.what) {
            case What::side:
            case What::object:
                paintTexels(span, Lay::opaque);
                break;
            case What::sky:
                paintSky(span);
                break;
            case What::haze:
                std::fill(pixels_ + span.first, pixels_ + span.last, span.vista->lighting.haze);
                count(span.first, span.last);
                break;
            default:
                if (span.look->plane.sloped) {
                    paintSlope(span, Lay::opaque);
                } else {
                    gather(span);
                }
        }
    }
    paintGathered(falling_);
    paintGathered(rising_);
}

// Paints layers from back to front. Those of one plane that touch are painted at once; nearer rows
// of a plane are farther from the horizon, so a run grows away from it.
void SlicePainter::paintLayers(const ColumnSpans& column) {
    report_.layers += static_cast<std::int64_t>(column.layers);
    PlaneRun run;
    const auto paintRun = [&] {
        if (run.first != run.last) paintPlane(run, Lay::over);
        run.first = run.last = -1;
    };
    for (const Span* span = column.spans.end(); span != column.spans.begin();) {
        --span;
        if (!span->layer) continue;
        if (span->what == What::side || span->what == What::object) {
            paintRun();
            paintTexels(*span, Lay::over);
            continue;
        }
        if (span->look->plane.sloped) {
            paintRun();
            paintSlope(*span, Lay::over);
            continue;
        }
        const bool falls = span->look->plane.rise < 0;
        if ((falls ? run.last == span->first : run.first == span->last) && run.part == span->part &&
            run.look == span->look && run.level == span->level) {
            (falls ? run.last : run.first) = falls ? span->last : span->first;
            run.tiles.fromX = span->tiles.fromX;
            run.tiles.fromY = span->tiles.fromY;
        } else {
            paintRun();
            run = runOf(*span);
        }
    }
    paintRun();
}

// Paints the reflections into an upside down column, and blends it over the mirrors.
void SlicePainter::paintReflection(const SliceSpans& slice) {
    Pixel* const pixels = pixels_;
    const std::uint8_t* const waterFogs = waterFogs_;
    const int height = frame_.vistas.projection().height;
    reflected_.resize(static_cast<std::size_t>(height));
    pixels_ = reflected_.data();
    waterFogs_ = nullptr;
    paintOpaque(slice.reflected);
    if (slice.reflected.layers > 0) paintLayers(slice.reflected);
    pixels_ = pixels;
    waterFogs_ = waterFogs;
    if (frame_.rippleRows > 0) return blendRipples(slice);
    for (const MirrorSpan& span : slice.upright.mirrors) {
        blendReversed(pixels_ + span.first, span.last - span.first,
                      reflected_.data() + (height - span.last), span.strength);
    }
}

void SlicePainter::blendRipples(const SliceSpans& slice) {
    const int height = frame_.vistas.projection().height;
    findMirrorPlanes(frame_, slice.upright);
    for (const MirrorSpan& span : slice.upright.mirrors) {
        const int count = span.last - span.first;
        if (span.ripples > 0) {
            const int* const rows = findRippledRows(frame_, slice.column, slice.upright, span);
            blendBefore(pixels_ + span.first, count, reflected_.data() + height - 1,
                        rows + span.first, span.strength);
        } else {
            blendReversed(pixels_ + span.first, count, reflected_.data() + (height - span.last),
                          span.strength);
        }
    }
}

void SlicePainter::paintTexels(const Span& span, Lay lay) {
    count(span.first, span.last);
    const TexelColumn column = isSmooth(span)               ? smoothColumn(span)
                               : span.vista->lit == nullptr ? span.column
                               : span.what == What::object  ? litObject(span)
                                                            : litColumn(span);
    if (waterFogs_ != nullptr) return paintTexelsFromWater(span, column, lay);
    fillSide(pixels_ + span.first, span.last - span.first, column, span.vista->lighting.haze, lay);
}

// The texels of a column that rows show.
struct SlicePainter::ShownTexels {
    std::size_t first;
    std::size_t last;

    explicit ShownTexels(const Span& span) {
        const TexelColumn& column = span.column;
        const auto steps = static_cast<std::uint64_t>(span.last - span.first - 1);
        first = static_cast<std::size_t>(column.start >> column.shift);
        last = static_cast<std::size_t>((column.start + steps * column.step) >> column.shift) + 1;
    }
};

// A side's column with baked light on its texels.
TexelColumn SlicePainter::litColumn(const Span& span) {
    TexelColumn column = span.column;
    if (span.glow) return column;
    if (sides_.isKept(span)) {
        column.texels = sides_.of(span);
        return column;
    }
    // Of a large one only what is shown
    const LitFaceAt face = faceOf(span);
    const TextureLevel& level = frame_.textures[span.image].levels[column.detail];
    const auto u = static_cast<int>((column.texels - level.texels.data()) >> level.bits);
    const FaceNodes* const nodes = span.vista->lit->nodesOf(face);
    if (nodes == nullptr) return column;
    const ShownTexels shown(span);
    Pixel* const lit = frame_.lit.scratch(static_cast<std::size_t>(level.size));
    lightColumn(lit + shown.first, u, static_cast<int>(shown.first), static_cast<int>(shown.last),
                {level, face.face, span.slide, span.rise}, *nodes);
    column.texels = lit;
    return column;
}

// The same of an object.
TexelColumn SlicePainter::litObject(const Span& span) {
    TexelColumn column = span.column;
    if (span.vista->map->objects[static_cast<std::size_t>(span.object)].glow) return column;
    const ShownTexels shown(span);
    Pixel* const texels = frame_.lit.scratch(shown.last);
    lightAll(texels, column.texels, shown.first, shown.last,
             span.vista->lit->ofObject(span.object));
    column.texels = texels;
    return column;
}

// Rows whose rays leave the eye's water before the span have the fog of that distance. They are the
// upper rows.
void SlicePainter::paintTexelsFromWater(const Span& span, TexelColumn column, Lay lay) {
    const std::uint32_t fog = column.fog;
    const Pixel haze = span.vista->lighting.haze;
    int row = span.first;
    for (; row < span.last && waterFogs_[row] < fog; ++row) {
        column.fog = waterFogs_[row];
        fillSide(pixels_ + row, 1, column, haze, lay);
        column.start += column.step;
    }
    column.fog = fog;
    if (row < span.last) fillSide(pixels_ + row, span.last - row, column, haze, lay);
}

void SlicePainter::paintSky(const Span& span) {
    span.vista->skyRows.fill(pixels_, column_, span.first, span.last);
    const Lighting& lighting = span.vista->lighting;
    for (int row = span.first; lighting.inWater && row < span.last; ++row) {
        const std::uint32_t fog = waterFogs_ != nullptr ? waterFogs_[row] : 255;
        pixels_[row] =
            shadedTexel(pixels_[row], 256, fog, lighting.haze, Lay::opaque, pixels_[row]);
    }
    count(span.first, span.last);
}

// Adds rows to the run of their side of the horizon. Farther rows of a plane are closer to the
// horizon, so a run grows towards it. An underside in the plane of a ceiling may have its look, but
// has a light of its own.
void SlicePainter::gather(const Span& span) {
    const bool falls = span.look->plane.rise < 0;
    PlaneRun& run = falls ? falling_ : rising_;
    if ((falls ? run.first == span.last : run.last == span.first) && run.part == span.part &&
        run.look == span.look && run.level == span.level) {
        (falls ? run.first : run.last) = falls ? span.first : span.last;
        run.tiles.toX = span.tiles.toX;
        run.tiles.toY = span.tiles.toY;
        run.tiles.endless = span.tiles.endless;
    } else {
        paintGathered(run);
        run = runOf(span);
    }
}

// Paints the run and empties it.
void SlicePainter::paintGathered(PlaneRun& run) {
    if (run.first == run.last) return;
    Lay lay = Lay::opaque;
    if (run.look->seeThrough && !run.look->plane.mirror) {
        // Only a floor closes its rows although it is see-through; below it is haze
        std::fill(pixels_ + run.first, pixels_ + run.last, run.vista->lighting.haze);
        count(run.first, run.last);
        ++report_.layers;
        lay = Lay::over;
    }
    paintPlane(run, lay);
    run.first = run.last = -1;
}

// The first and the last rows may be within the rounding error of their tiles' border, or all of
// them if the ray runs along it. Their texel is clamped, so that the far side of the texture never
// shows.
void SlicePainter::paintPlane(const PlaneRun& run, Lay lay) {
    count(run.first, run.last);
    PlaneLook& look = *run.look;
    const PlanePoints points(*run.vista, run.vista->ray(column_), look.height,
                             look.plane.southReversed, run.tiles);
    const double* const inverses = look.rows(run.first, run.last).inverseOffsets;
    int first = run.first;
    int last = run.last;
    if (look.plane.isShifted() || points.anyOnBorder(inverses, first, last)) last = first;
    while (first < last && !points.isInside(inverses[first])) ++first;
    while (first < last && !points.isInside(inverses[last - 1])) --last;
    paintPlaneByRows(run, run.first, first, points, lay);
    paintPlaneByRows(run, last, run.last, points, lay);
    if (run.isLit()) return paintLitRows(run, first, last, points, lay);
    paintPlaneRows(run, first, last, points, lay);
}

// Paints rows whose points are well within the run's tiles, all from one texture.
void SlicePainter::paintPlaneRows(const PlaneRun& run, int first, int last,
                                  const PlanePoints& points, Lay lay) {
    const PlaneRows rows = run.look->rows(first, last);
    const TextureLevel* const levels = frame_.textures[run.look->plane.texture].levels;
    const PlaneLook::Stretch* stretch = run.look->stretches().data();
    for (int row = first; row < last; ++stretch) {
        if (stretch->last <= row) continue;
        const int end = std::min(stretch->last, last);
        if (stretch->smooth) {
            fillFetched(pixels_, row, end,
                        fetchSmoothRows(run, row, end, points.line, rows.inverseOffsets), rows,
                        run.vista->lighting.haze, stretch->shade, lay);
        } else {
            fillPlane(pixels_, row, end,
                      {levels[stretch->detail], points.line, rows, run.vista->lighting.haze},
                      stretch->shade, lay);
        }
        row = end;
    }
}

// The same with baked light.
void SlicePainter::paintLitRows(const PlaneRun& run, int first, int last, const PlanePoints& points,
                                Lay lay) {
    const PlaneRows rows = run.look->rows(first, last);
    const TextureLevel* const levels = frame_.textures[run.look->plane.texture].levels;
    const PlaneLook::Stretch* stretch = run.look->stretches().data();
    for (int row = first; row < last; ++stretch) {
        if (stretch->last <= row) continue;
        const int end = std::min(stretch->last, last);
        const Pixel* const lit =
            stretch->smooth ? fetchSmoothRows(run, row, end, points.line, rows.inverseOffsets)
                            : fetchLitRows(run, row, end, levels[stretch->detail], points.line,
                                           rows.inverseOffsets);
        fillFetched(pixels_, row, end, lit, rows, run.vista->lighting.haze, stretch->shade, lay);
        row = end;
    }
}

// One texel of a plane.
Pixel SlicePainter::texelAt(const PlaneRun& run, const TextureLevel& level,
                            const PlanePoints::Point& point) const {
    const Plane& plane = run.look->plane;
    const std::uint32_t u = texelIn(point.east, plane.east, level.bits);
    std::uint32_t v = texelIn(point.south, plane.south, level.bits);
    const std::uint32_t shown =
        plane.southReversed ? static_cast<std::uint32_t>(level.size - 1) - v : v;
    const Pixel texel = level.texels[u << level.bits | shown];
    if (!run.isLit()) return texel;
    const auto place = [&](std::uint32_t at, Coordinate shift) {
        return (middleOf(static_cast<int>(at), level.size) + shift.raw) & 65535;
    };
    return litAt(texel, planeNodes(run, point.tileX, point.tileY), place(u, plane.east),
                 place(v, plane.south));
}

// Paints rows one by one, slowly: those near tile borders, blocks that have moved sideways, and the
// rare runs behind turning portals with a point exactly on a border.
void SlicePainter::paintPlaneByRows(const PlaneRun& run, int first, int last,
                                    const PlanePoints& points, Lay lay) {
    if (first == last) return;
    const PlaneRows rows = run.look->rows(first, last);
    const FrameTexture& texture = frame_.textures[run.look->plane.texture];
    for (int row = first; row < last; ++row) {
        const double inverse = rows.inverseOffsets[row];
        const double depth = run.look->depthPerInverse * inverse;
        const int level = frame_.detail.levelAt(depth, texture.size, texture.last);
        const PlanePoints::Point point = points.at(inverse);
        const Pixel texel = frame_.detail.isSmooth(level, depth, texture.size)
                                ? smoothTexelAt(run, point)
                                : texelAt(run, texture.levels[level], point);
        pixels_[row] =
            shadedTexel(texel, rows.factors[row] & 0xffff, rows.fogs ? rows.fogs[row] & 0xffff : 0,
                        run.vista->lighting.haze, lay, pixels_[row]);
    }
}

}  // namespace slicecast

// Paints faces whose texels are larger than a pixel, if these are to be blended: finds the colour
// of each row, which is then laid on like any other texel.
#include "render/light/smooth_light.h"
#include "render/paint/lit_planes.h"
#include "render/paint/slice_paint.h"
#include "render/pixels/smooth_texels.h"

#include <algorithm>

namespace slicecast {
namespace {

std::uint32_t shifted(std::uint32_t place, Coordinate by) {
    return place - (static_cast<std::uint32_t>(by.raw) << 16);
}

}  // namespace

// The colours of a side's rows as a column of texels, one for each row.
TexelColumn SlicePainter::smoothColumn(const Span& span) const {
    const FrameTexture& image = frame_.textures[span.image];
    const TextureLevel& level = image.levels[0];
    const bool reversed = span.face == Face::north || span.face == Face::east;
    const int rows = span.last - span.first;
    Pixel* const colours = frame_.lit.scratch(static_cast<std::size_t>(rows));
    blendSide(colours, rows, {level.texels.data(), level.bits, reversed, false, image.seeThrough},
              shifted(span.along, span.slide), span.column);
    TexelColumn column = span.column;
    column.texels = colours;
    column.start = 0;
    column.step = 1;
    column.shift = 0;
    if (span.vista->lit == nullptr || span.glow) return column;
    const LitFaceAt face = {span.tiles.fromX, span.tiles.fromY, span.level,
                            static_cast<LitFace>(span.face)};
    if (const FaceNodes* const nodes = span.vista->lit->nodesOf(face)) {
        lightSide(colours, rows, *nodes, static_cast<std::int32_t>(span.along >> 16), span.column,
                  span.rise);
    }
    return column;
}

Pixel SlicePainter::smoothTexelAt(const PlaneRun& run, const PlanePoints::Point& point) const {
    const Plane& plane = run.look->plane;
    const FrameTexture& image = frame_.textures[plane.texture];
    const TextureLevel& level = image.levels[0];
    const Pixel colour =
        smoothTexel({level.texels.data(), level.bits, false, plane.southReversed, image.seeThrough},
                    shifted(point.east, plane.east), shifted(point.south, plane.south));
    if (!run.isLit()) return colour;
    return litAt(colour, planeNodes(run, point.tileX, point.tileY),
                 static_cast<std::int32_t>(point.east >> 16),
                 static_cast<std::int32_t>(point.south >> 16));
}

// The colours of rows whose points are well within the run's tiles, by row; valid until the next
// ones are made.
const Pixel* SlicePainter::fetchSmoothRows(const PlaneRun& run, int first, int last,
                                           const PlaneLine& line,
                                           const double* inverseOffsets) const {
    const FrameTexture& image = frame_.textures[run.look->plane.texture];
    const TextureLevel& level = image.levels[0];
    Pixel* const colours = frame_.lit.scratch(static_cast<std::size_t>(last + kRowsBeyond));
    blendPlane(colours, first, last,
               {level.texels.data(), level.bits, false, line.southReversed, image.seeThrough}, line,
               inverseOffsets);
    if (!run.isLit()) return colours;
    // Tile by tile
    const auto tileX = [&](int row) {
        return static_cast<int>(
            PlaneLine::position(line.eastStart, line.eastPerInverse, inverseOffsets[row]) >> 32);
    };
    const auto tileY = [&](int row) {
        return static_cast<int>(
            PlaneLine::position(line.southStart, line.southPerInverse, inverseOffsets[row]) >> 32);
    };
    for (int row = first; row < last;) {
        const int x = tileX(row);
        const int y = tileY(row);
        int end = row + 1;
        while (end < last && tileX(end) == x && tileY(end) == y) ++end;
        lightPlane(colours, row, end, planeNodes(run, x, y), line, inverseOffsets);
        row = end;
    }
    return colours;
}

}  // namespace slicecast

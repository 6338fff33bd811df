// Paints sloped faces. Each column sees them under a horizon of its own, so no table of the frame
// serves: depth, light and fog are found row by row.
#include "render/plane_points.h"
#include "render/slice_paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace slicecast {
namespace {

constexpr int kRowsAtOnce = 64;

// The tables of some rows; index 0 is the first one.
struct SlopeRows {
    std::array<double, kRowsAtOnce + kRowsBeyond> inverseOffsets{};
    std::array<std::uint32_t, kRowsAtOnce> factors;
    std::array<std::uint32_t, kRowsAtOnce> fogs;
    std::array<std::uint8_t, kRowsAtOnce> details;

    PlaneRows rows(bool foggy) const {
        return {inverseOffsets.data(), factors.data(), foggy ? fogs.data() : nullptr};
    }
};

}  // namespace

void SlicePainter::paintSlope(const Span& span, Lay lay) {
    count(span.first, span.last);
    const PlaneRun run = runOf(span);
    const Plane& plane = span.look->plane;
    const Lighting& lighting = span.vista->lighting;
    const FrameTexture& texture = frame_.textures[plane.texture];
    const double height = std::fabs(span.slope.height);
    const double depthPerInverse = height * span.vista->projection->distance;
    const PlanePoints points(*span.vista, span.vista->ray(column_), height, plane.southReversed,
                             span.tiles);
    const PlaneShade shade = lighting.foggy ? PlaneShade::foggy : PlaneShade::dimmed;
    SlopeRows table;
    for (int first = span.first; first < span.last; first += kRowsAtOnce) {
        const int rows = std::min(span.last - first, kRowsAtOnce);
        for (int row = 0; row < rows; ++row) {
            const auto i = static_cast<std::size_t>(row);
            // #region depth-of-row
            const double inverse = 1.0 / std::fabs(span.slope.horizon - (first + row + 0.5));
            const double depth = depthPerInverse * inverse;
            // #endregion
            table.inverseOffsets[i] = inverse;
            table.factors[i] = inBothHalves(lighting.factorAt(depth, plane.light, plane.glow));
            std::uint32_t fog = lighting.fogAt(depth);
            // Beyond the surface of the eye's water there is no more of it
            if (waterFogs_ != nullptr) fog = std::min<std::uint32_t>(fog, waterFogs_[first + row]);
            table.fogs[i] = inBothHalves(fog);
            table.details[i] =
                static_cast<std::uint8_t>(frame_.detail.levelAt(depth, texture.size, texture.last));
        }
        const PlaneRows shades = table.rows(lighting.foggy);
        Pixel* const pixels = pixels_ + first;
        const bool isSlow = plane.isShifted() || points.anyOnBorder(shades.inverseOffsets, 0, rows);
        const auto isClear = [&](int row) {
            return !isSlow && points.isInside(shades.inverseOffsets[row]);
        };
        const auto isSmooth = [&](int row) {
            return frame_.detail.isSmooth(table.details[static_cast<std::size_t>(row)],
                                          depthPerInverse * shades.inverseOffsets[row],
                                          texture.size);
        };
        for (int row = 0; row < rows;) {
            const std::uint8_t detail = table.details[static_cast<std::size_t>(row)];
            const TextureLevel& level = texture.levels[detail];
            const bool smooth = isSmooth(row);
            if (!isClear(row)) {
                const PlanePoints::Point point = points.at(shades.inverseOffsets[row]);
                pixels[row] = shadedTexel(
                    smooth ? smoothTexelAt(run, point) : texelAt(run, level, point),
                    shades.factors[row] & 0xffff, shades.fogs ? shades.fogs[row] & 0xffff : 0,
                    lighting.haze, lay, pixels[row]);
                ++row;
                continue;
            }
            int end = row + 1;
            while (end < rows && table.details[static_cast<std::size_t>(end)] == detail &&
                   isSmooth(end) == smooth && isClear(end))
                ++end;
            if (smooth || run.isLit()) {
                const Pixel* const lit =
                    smooth ? fetchSmoothRows(run, row, end, points.line, shades.inverseOffsets)
                           : fetchLitRows(run, row, end, level, points.line, shades.inverseOffsets);
                fillFetched(pixels, row, end, lit, shades, lighting.haze, shade, lay);
            } else {
                fillPlane(pixels, row, end, {level, points.line, shades, lighting.haze}, shade,
                          lay);
            }
            row = end;
        }
    }
}

}  // namespace slicecast

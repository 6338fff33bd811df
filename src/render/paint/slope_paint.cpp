// Paints sloped faces. Each column sees them under a horizon of its own, so no table of the frame
// serves: depth, light and fog are found row by row.
#include "render/paint/slice_paint.h"
#include "render/spans/plane_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace slicecast {
namespace {

constexpr int kRowsAtOnce = 64;

// The tables of some rows; index 0 is the first one.
struct SlopeRows {
    alignas(16) std::array<double, kRowsAtOnce + kRowsBeyond> inverseOffsets{};
    std::array<std::uint32_t, kRowsAtOnce> factors;
    std::array<std::uint32_t, kRowsAtOnce> fogs;
    PlaneShade shade = PlaneShade::dimmed;

    // `waterFogs` are those of the rows, or null.
    void find(const Span& span, int first, int rows, double depthPerInverse,
              const std::uint8_t* waterFogs);
};

void SlopeRows::find(const Span& span, int first, int rows, double depthPerInverse,
                     const std::uint8_t* waterFogs) {
    const Plane& plane = span.look->plane;
    const Lighting& lighting = span.vista->lighting;
    // #region depth-of-row
    const auto inverseOf = [&](int row) {
        return 1.0 / std::fabs(span.slope.horizon - (row + 0.5));
    };
    const auto depthOf = [&](std::size_t i) { return depthPerInverse * inverseOffsets[i]; };
    // #endregion
    const auto count = static_cast<std::size_t>(rows);
    for (std::size_t i = 0; i < count; ++i)
        inverseOffsets[i] = inverseOf(first + static_cast<int>(i));
    // Depths grow or fall along the rows
    const double deepest = std::max(depthOf(0), depthOf(count - 1));
    // Most slopes are nearer than where fog begins, and many are in baked light alone
    const bool fogBegins = lighting.foggy && deepest > lighting.fogStart;
    if (plane.glow || !lighting.lit) {
        const std::uint32_t factor = Lighting::factorOf(kFullBrightness, plane.light);
        std::fill_n(factors.begin(), count, inBothHalves(factor));
        shade = factor == 256 ? PlaneShade::full : PlaneShade::dimmed;
    } else {
        for (std::size_t i = 0; i < count; ++i)
            factors[i] = inBothHalves(lighting.factorAt(depthOf(i), plane.light, false));
        shade = PlaneShade::dimmed;
    }
    if (!fogBegins) {
        std::fill_n(fogs.begin(), count, 0);
        return;
    }
    shade = PlaneShade::foggy;
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t fog = lighting.fogAt(depthOf(i));
        // Beyond the surface of the eye's water there is no more of it
        if (waterFogs != nullptr) fog = std::min<std::uint32_t>(fog, waterFogs[i]);
        fogs[i] = inBothHalves(fog);
    }
}

}  // namespace

void SlicePainter::paintSlope(const Span& span, Lay lay) {
    count(span.first, span.last);
    const double depthPerInverse = std::fabs(span.slope.height) * span.vista->projection->distance;
    SlopeRows table;
    for (int first = span.first; first < span.last; first += kRowsAtOnce) {
        const int rows = std::min(span.last - first, kRowsAtOnce);
        table.find(span, first, rows, depthPerInverse,
                   waterFogs_ != nullptr ? waterFogs_ + first : nullptr);
        const PlaneRows shades = {table.inverseOffsets.data(), table.factors.data(),
                                  span.vista->lighting.foggy ? table.fogs.data() : nullptr};
        paintSlopeRows(span, pixels_ + first, rows, shades, table.shade, lay);
    }
}

// Rows of a slope; the first of them is at `pixels`, and at index 0 of the tables.
void SlicePainter::paintSlopeRows(const Span& span, Pixel* pixels, int rows,
                                  const PlaneRows& shades, PlaneShade shade, Lay lay) {
    const PlaneRun run = runOf(span);
    const Plane& plane = span.look->plane;
    const Pixel haze = span.vista->lighting.haze;
    const FrameTexture& texture = frame_.textures[plane.texture];
    const double height = std::fabs(span.slope.height);
    const double depthPerInverse = height * span.vista->projection->distance;
    const PlanePoints points(*span.vista, span.vista->ray(column_), height, plane.southReversed,
                             span.tiles);
    const auto depthOf = [&](int row) { return depthPerInverse * shades.inverseOffsets[row]; };
    const auto detailOf = [&](int row) {
        return frame_.detail.levelAt(depthOf(row), texture.size, texture.last);
    };
    const auto isSmooth = [&](int row, int detail) {
        return frame_.detail.isSmooth(detail, depthOf(row), texture.size);
    };
    // Only rows at the ends may be within the rounding error of the tile's border
    int clear = 0;
    int clearEnd = rows;
    if (plane.isShifted() || points.anyOnBorder(shades.inverseOffsets, 0, rows)) clearEnd = 0;
    while (clear < clearEnd && !points.isInside(shades.inverseOffsets[clear])) ++clear;
    while (clear < clearEnd && !points.isInside(shades.inverseOffsets[clearEnd - 1])) --clearEnd;
    for (int row = 0; row < rows;) {
        const int detail = detailOf(row);
        const TextureLevel& level = texture.levels[detail];
        const bool smooth = isSmooth(row, detail);
        if (row < clear || row >= clearEnd) {
            const PlanePoints::Point point = points.at(shades.inverseOffsets[row]);
            pixels[row] =
                shadedTexel(smooth ? smoothTexelAt(run, point) : texelAt(run, level, point),
                            shades.factors[row] & 0xffff,
                            shades.fogs ? shades.fogs[row] & 0xffff : 0, haze, lay, pixels[row]);
            ++row;
            continue;
        }
        // Depths grow or fall along the rows: if the last row is alike, those between are
        const auto isAlike = [&](int other) {
            return detailOf(other) == detail && isSmooth(other, detail) == smooth;
        };
        int end = clearEnd;
        if (!isAlike(end - 1)) {
            end = row + 1;
            while (isAlike(end)) ++end;
        }
        if (smooth || run.isLit()) {
            const Pixel* const lit =
                smooth ? fetchSmoothRows(run, row, end, points.line, shades.inverseOffsets)
                       : fetchLitRows(run, row, end, level, points.line, shades.inverseOffsets);
            fillFetched(pixels, row, end, lit, shades, haze, shade, lay);
        } else {
            fillPlane(pixels, row, end, {level, points.line, shades, haze}, shade, lay);
        }
        row = end;
    }
}

}  // namespace slicecast

#include "render/view/sky_layers.h"

#include "base/angle.h"
#include "base/pixels.h"
#include "base/random.h"
#include "render/pixels/column_fill.h"
#include "render/pixels/vectors.h"
#include "world/time_step.h"

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

constexpr int kHalfSquares = 2 * kSkyColumns;  // around the full circle
constexpr int kStarSide = 8;                   // squares a side of a place for a star
constexpr int kStarFade = 48;                  // rows above the horizon in which stars appear
constexpr int kCloudFade = 24;
constexpr int kDiscFade = 16;
constexpr int kCloudTurn = kCloudColumns * 256;
constexpr int kToneRows = 6;  // from a square to the one whose density decides its tone

int share255(double share) {
    return static_cast<int>(255.0 * share + 0.5);
}

// A colour as a texel that is laid over others with a weight of 255.
Pixel weighted(Pixel colour, int weight) {
    return (colour & ~kOpaque) | static_cast<Pixel>(weight) << 24;
}

Pixel mixed(Pixel there, Pixel texel) {
    return shadedTexel(texel, 256, 0, 0, Lay::over, there);
}

}  // namespace

SkyLayers::Disc SkyLayers::discOf(const SkyDisc& disc) {
    const auto halves = [](double degrees) {
        return static_cast<int>(std::floor(degrees * (kHalfSquares / 360.0) + 0.5));
    };
    Disc found;
    found.x = halves(wrapDegrees(disc.azimuth));
    found.y =
        static_cast<int>(std::floor(2.0 * kSkyRowsPerSlope * tanDegrees(disc.altitude) + 0.5));
    found.radius = halves(disc.size / 2.0);
    found.glow = halves(disc.glow);
    if (found.glow > 0)
        found.perDistance = (1u << 28) / static_cast<std::uint32_t>(found.glow * found.glow);
    found.colour = disc.colour;
    return found;
}

void SkyLayers::beginFrame(const Sky& sky, const Projection& projection, std::int64_t steps) {
    sky_ = &sky;
    skyRows_.resize(static_cast<std::size_t>(projection.firstFallingRow));
    for (int row = 0; row < projection.firstFallingRow; ++row) {
        const double up = kSkyRowsPerSlope * projection.upwardSlope(row);
        skyRows_[static_cast<std::size_t>(row)] =
            static_cast<std::uint16_t>(up < kMaxSkyRow ? up : kMaxSkyRow);
    }
    const int rows = skyRows_.empty() ? 0 : skyRows_[0] + 1;
    lastRows_.resize(static_cast<std::size_t>(rows));
    for (int square = rows - 1, row = 0; square >= 0; --square) {
        while (row < projection.firstFallingRow &&
               skyRows_[static_cast<std::size_t>(row)] >= square)
            ++row;
        lastRows_[static_cast<std::size_t>(square)] = row;
    }
    squares_.resize(static_cast<std::size_t>(rows));
    layer_.resize(static_cast<std::size_t>(rows));
    beginColours(sky, rows);
    sun_ = discOf(sky.sun);
    moon_ = discOf(sky.moon);
    moon_.hasSpots = true;
    density_ = static_cast<int>(1024.0 * sky.stars.density + 0.5);
    brightness_ = share255(sky.stars.brightness);
    if (sky.clouds.shape != nullptr) beginClouds(sky.clouds, steps);
}

// The sky's own colours are those of the middles of squares.
void SkyLayers::beginColours(const Sky& sky, int rows) {
    const bool isPanorama = sky.kind == Sky::Kind::panorama;
    (isPanorama ? panoramaOffsets_.resize(static_cast<std::size_t>(rows))
                : colours_.resize(static_cast<std::size_t>(rows)));
    for (int row = 0; row < rows; ++row) {
        const double share = std::min(1.0, (row + 0.5) / kSkyRowsPerSlope / sky.slope);
        const auto i = static_cast<std::size_t>(row);
        if (isPanorama) {
            const int height = sky.panorama.height;
            panoramaOffsets_[i] =
                std::min(height - 1, static_cast<int>((1.0 - share) * height)) * sky.panorama.width;
            continue;
        }
        const auto blend = [&](int low, int high) {
            return static_cast<std::uint8_t>(std::floor(low + (high - low) * share + 0.5));
        };
        colours_[i] =
            toPixel(sky.kind == Sky::Kind::colour
                        ? sky.low
                        : Colour{blend(sky.low.r, sky.high.r), blend(sky.low.g, sky.high.g),
                                 blend(sky.low.b, sky.high.b), 255});
    }
}

void SkyLayers::beginClouds(const SkyClouds& clouds, std::int64_t steps) {
    // The quotient's floor is exact, as in frameAt
    constexpr double kStepsPerTurn = 360.0 * kStepsPerSecond / kCloudTurn;
    const double moved = std::floor(static_cast<double>(steps) * clouds.speed / kStepsPerTurn);
    drift_ = static_cast<int>(std::fmod(moved, kCloudTurn));
    threshold_ = 200 - static_cast<int>(160.0 * clouds.cover + 0.5);
    const int opacity = share255(clouds.opacity);
    for (int density = 0; density < 256; ++density) {
        cloudWeights_[static_cast<std::size_t>(density)] = static_cast<std::uint8_t>(
            std::clamp(8 * (density - threshold_), 0, 255) * opacity / 255);
    }
    for (int tone = 0; tone < 16; ++tone)
        cloudColours_[static_cast<std::size_t>(tone)] =
            mixed(toPixel(clouds.shade), weighted(toPixel(clouds.colour), 17 * tone));
}

void SkyLayers::fill(Pixel* colours, int column, int first, int last) {
    if (first >= last) return;
    const Rows rows = {skyRows_[static_cast<std::size_t>(last - 1)],
                       skyRows_[static_cast<std::size_t>(first)] + 1};
    fillColours(column, rows);
    if (density_ > 0) addStars(column, rows);
    if (sun_.radius > 0) addDisc(sun_, column, rows);
    if (moon_.radius > 0) addDisc(moon_, column, rows);
    if (sky_->clouds.shape != nullptr) addClouds(column, rows);
    for (int row = first, square = rows.last - 1; square >= rows.first; --square) {
        const Pixel colour = squares_[static_cast<std::size_t>(square)];
        const int end = std::min(last, lastRows_[static_cast<std::size_t>(square)]);
        if constexpr (kHasVectors) {  // what goes beyond the end is overwritten by the next square
            for (; row < end && row + 4 <= last; row += 4)
                storeVector(colours + row, allLanes(colour));
        }
        for (; row < end; ++row) colours[row] = colour;
        row = end;
    }
}

void SkyLayers::fillColours(int column, Rows rows) {
    if (sky_->kind != Sky::Kind::panorama) {
        std::copy(colours_.begin() + rows.first, colours_.begin() + rows.last,
                  squares_.begin() + rows.first);
        return;
    }
    const Pixel* const texels =
        sky_->panorama.pixels.data() + (2 * column + 1) * sky_->panorama.width / (2 * kSkyColumns);
    for (int row = rows.first; row < rows.last; ++row) {
        const auto i = static_cast<std::size_t>(row);
        squares_[i] = texels[panoramaOffsets_[i]];
    }
}

// Lays the rows of `layer_` over the squares.
void SkyLayers::layOver(Rows rows) {
    fillFetched(squares_.data(), rows.first, rows.last, layer_.data(), {}, 0, PlaneShade::full,
                Lay::over);
}

// A place of 8 x 8 squares may hold a star, in one of its inner squares.
void SkyLayers::addStars(int column, Rows rows) {
    const int placeX = column / kStarSide;
    for (int place = rows.first / kStarSide; place * kStarSide < rows.last; ++place) {
        const std::uint64_t star =
            Random(std::uint64_t{sky_->stars.seed} | static_cast<std::uint64_t>(placeX) << 32 |
                   static_cast<std::uint64_t>(place) << 44)
                .next();
        if (static_cast<int>(star & 1023) >= density_) continue;
        const int x = std::abs(column % kStarSide - 1 - static_cast<int>((star >> 10) % 6));
        if (x > 1) continue;
        addStar(star, x, place * kStarSide + 1 + static_cast<int>((star >> 16) % 6), rows);
    }
}

// Adds what a column `x` squares beside a star shows of it. The brightest ones have four rays.
void SkyLayers::addStar(std::uint64_t star, int x, int y, Rows rows) {
    const int size = star >> 24 & 255;
    const int bright = 40 + 215 * (size * size / 255 * size / 255) / 255;
    const int rays = size >= 224 ? 1 : 0;
    if (x > rays) return;
    for (int row = y - rays; row <= y + rays; ++row) {
        const int away = x + std::abs(row - y);
        if (away > 1 || row < rows.first || row >= rows.last) continue;
        const int weight =
            bright / (1 + 2 * away) * std::min(row, kStarFade) / kStarFade * brightness_ / 255;
        Pixel& square = squares_[static_cast<std::size_t>(row)];
        square = mixed(square, weighted(toPixel(sky_->stars.colour), weight));
    }
}

// A disc has a soft rim, a square wide. Its glow ends gently. The moon has spots.
void SkyLayers::addDisc(const Disc& disc, int column, Rows rows) {
    const int rim = disc.radius + 1;
    const int reach = std::max(rim, disc.glow);
    const int x =
        ((2 * column + 1 - disc.x + 3 * kHalfSquares / 2) & (kHalfSquares - 1)) - kHalfSquares / 2;
    if (std::abs(x) >= reach) return;
    const Rows seen = {std::max(rows.first, (disc.y - reach) / 2),
                       std::min(rows.last, (disc.y + reach) / 2 + 1)};
    for (int row = seen.first; row < seen.last; ++row) {
        const int y = 2 * row + 1 - disc.y;
        const int distance = x * x + y * y;
        int weight = 0;
        if (distance < disc.glow * disc.glow) {
            const int near =
                256 -
                static_cast<int>(static_cast<std::uint32_t>(distance) * disc.perDistance >> 20);
            const int square = near * near >> 8;
            weight = 160 * (square * square >> 8) >> 8;
        }
        Pixel colour = toPixel(disc.colour);
        if (distance < rim * rim) {
            weight =
                std::max(weight, std::min(255, 255 * (rim * rim - distance) / (4 * disc.radius)));
            if (disc.hasSpots) colour = mixed(colour, weighted(0, spotAt(disc, x, y)));
        }
        layer_[static_cast<std::size_t>(row)] =
            weighted(colour, weight * std::min(row, kDiscFade) / kDiscFade);
    }
    layOver(seen);
}

// How dark the moon is at one of its points, of 255.
int SkyLayers::spotAt(const Disc& disc, int x, int y) {
    const int noise = cloudNoise(0, x * 640 / disc.radius, y * 640 / disc.radius);
    return std::clamp(2 * (112 - noise), 0, 64);
}

// Clouds are bright where they are denser than above, and shaded where they are thinner.
void SkyLayers::addClouds(int column, Rows rows) {
    const int at = (column * (kCloudTurn / kSkyColumns) - drift_) & (kCloudTurn - 1);
    const int share = at & 255;
    const std::uint8_t* const shape = sky_->clouds.shape->density.data();
    const std::uint8_t* const near = shape + static_cast<std::ptrdiff_t>(at >> 8) * kCloudRows;
    const std::uint8_t* const far =
        shape + static_cast<std::ptrdiff_t>(((at >> 8) + 1) % kCloudColumns) * kCloudRows;
    const int firstRow = rows.first / 2;
    const int lastRow = (rows.last + kToneRows) / 2 + 2;
    densities_.resize(static_cast<std::size_t>(lastRow));
    for (int row = firstRow; row < lastRow; ++row) {
        const int i = std::min(row, kCloudRows - 1);
        densities_[static_cast<std::size_t>(row)] = (near[i] * (256 - share) + far[i] * share) >> 8;
    }
    const int* const densities = densities_.data();
    const auto put = [&](int row, int density, int above) {
        if (row < rows.first || row >= rows.last) return;
        int weight = cloudWeights_[static_cast<std::size_t>(density)];
        if (row < kCloudFade) weight = weight * row / kCloudFade;
        const int tone = std::clamp(160 + 8 * (density - above), 0, 255);
        layer_[static_cast<std::size_t>(row)] =
            weighted(cloudColours_[static_cast<std::size_t>(tone >> 4)], weight);
    };
    std::fill(layer_.begin() + rows.first, layer_.begin() + rows.last, 0);
    for (int row = firstRow; 2 * row < rows.last; ++row) {
        const int here = densities[row];
        const int next = densities[row + 1];
        if (std::max(here, next) <= threshold_) continue;
        const int above = densities[row + kToneRows / 2];
        put(2 * row, here, above);
        put(2 * row + 1, (here + next) >> 1, (above + densities[row + kToneRows / 2 + 1]) >> 1);
    }
    layOver(rows);
}

}  // namespace slicecast

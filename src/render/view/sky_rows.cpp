#include "render/view/sky_rows.h"

#include "base/angle.h"

#include <algorithm>
#include <cmath>

namespace slicecast {

void SkyRows::beginFrame(const Sky& sky, const Projection& projection, double headingDegrees,
                         std::int64_t steps) {
    sky_ = &sky;
    hasLayers_ = sky.hasLayers();
    fetchedColumn_ = -1;
    headingDegrees_ = headingDegrees;
    if (hasLayers_ || sky.kind == Sky::Kind::panorama) findAzimuths(projection);
    if (hasLayers_) {
        layers_.beginFrame(sky, projection, steps);
        colours_.resize(static_cast<std::size_t>(projection.firstFallingRow));
        return;
    }
    // #region gradient
    const int rows = projection.firstFallingRow;
    const auto share = [&](int row) {
        return std::min(1.0, projection.upwardSlope(row) / sky.slope);
    };

    if (sky.kind == Sky::Kind::gradient) {
        colours_.resize(static_cast<std::size_t>(rows));
        for (int row = 0; row < rows; ++row) {
            const double s = share(row);
            const auto blend = [s](int low, int high) {
                return static_cast<std::uint8_t>(std::floor(low + (high - low) * s + 0.5));
            };
            colours_[static_cast<std::size_t>(row)] =
                toPixel({blend(sky.low.r, sky.high.r), blend(sky.low.g, sky.high.g),
                         blend(sky.low.b, sky.high.b), 255});
        }
        // #endregion
    } else if (sky.kind == Sky::Kind::panorama) {
        colours_.resize(static_cast<std::size_t>(rows));
        panoramaOffsets_.resize(static_cast<std::size_t>(rows));
        for (int row = 0; row < rows; ++row) {
            const int line = std::min(sky.panorama.height - 1,
                                      static_cast<int>((1.0 - share(row)) * sky.panorama.height));
            panoramaOffsets_[static_cast<std::size_t>(row)] = line * sky.panorama.width;
        }
    }
}

// The arc tangents depend only on the shape of the picture, so they are kept from frame to frame.
void SkyRows::findAzimuths(const Projection& projection) {
    if (azimuthWidth_ == projection.width && azimuthDistance_ == projection.distance) return;
    azimuthWidth_ = projection.width;
    azimuthDistance_ = projection.distance;
    azimuths_.resize(static_cast<std::size_t>(projection.width));
    for (int column = 0; column < projection.width; ++column) {
        azimuths_[static_cast<std::size_t>(column)] = atanDegrees(projection.sidewaysSlope(column));
    }
}

// The column of `count` around the full circle that a column of the picture looks into.
int SkyRows::columnOf(int column, int count) const {
    const double turn = (headingDegrees_ + azimuths_[static_cast<std::size_t>(column)]) / 360.0;
    return std::min(count - 1, static_cast<int>((turn - std::floor(turn)) * count));
}

void SkyRows::fill(Pixel* slice, int column, int first, int last) {
    if (hasLayers_) {
        fetch(columnOf(column, kSkyColumns), first, last);
    } else if (sky_->kind == Sky::Kind::panorama) {
        fetch(columnOf(column, sky_->panorama.width), first, last);
    } else if (sky_->kind == Sky::Kind::colour) {
        std::fill(slice + first, slice + last, toPixel(sky_->low));
        return;
    }
    std::copy(colours_.begin() + first, colours_.begin() + last, slice + first);
}

// Fills rows of `colours_` from a column of the panorama, or of squares. Several neighbouring
// slices show the same one.
void SkyRows::fetch(int skyColumn, int first, int last) {
    if (skyColumn != fetchedColumn_) {
        fetchedColumn_ = skyColumn;
        fetchedFirst_ = fetchedLast_ = first;
    }
    if (first < fetchedFirst_) {
        fetchRows(first, fetchedFirst_);
        fetchedFirst_ = first;
    }
    if (last > fetchedLast_) {
        fetchRows(fetchedLast_, last);
        fetchedLast_ = last;
    }
}

// The panorama is stored by rows, so the pixels of a column are far apart in memory.
void SkyRows::fetchRows(int first, int last) {
    Pixel* const colours = colours_.data();
    if (hasLayers_) return layers_.fill(colours, fetchedColumn_, first, last);
    const Pixel* const texels = sky_->panorama.pixels.data() + fetchedColumn_;
    const int* const offsets = panoramaOffsets_.data();
    for (int row = first; row < last; ++row) colours[row] = texels[offsets[row]];
}

}  // namespace slicecast

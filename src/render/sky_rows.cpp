#include "render/sky_rows.h"

#include "base/angle.h"

#include <algorithm>
#include <cmath>

namespace slicecast {

void SkyRows::beginFrame(const Sky& sky, const Projection& projection, double headingDegrees) {
    sky_ = &sky;
    headingDegrees_ = headingDegrees;
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
        fetchedColumn_ = -1;
        panoramaOffsets_.resize(static_cast<std::size_t>(rows));
        for (int row = 0; row < rows; ++row) {
            const int line = std::min(sky.panorama.height - 1,
                                      static_cast<int>((1.0 - share(row)) * sky.panorama.height));
            panoramaOffsets_[static_cast<std::size_t>(row)] = line * sky.panorama.width;
        }
        // The arc tangents depend only on the shape of the picture, so they are kept from frame to
        // frame
        if (azimuthWidth_ != projection.width || azimuthDistance_ != projection.distance) {
            azimuthWidth_ = projection.width;
            azimuthDistance_ = projection.distance;
            azimuths_.resize(static_cast<std::size_t>(projection.width));
            for (int column = 0; column < projection.width; ++column) {
                azimuths_[static_cast<std::size_t>(column)] =
                    atanDegrees(projection.sidewaysSlope(column));
            }
        }
    }
}

void SkyRows::fill(Pixel* slice, int column, int first, int last) {
    if (sky_->kind == Sky::Kind::colour) {
        std::fill(slice + first, slice + last, toPixel(sky_->low));
        return;
    }
    if (sky_->kind == Sky::Kind::panorama) {
        const double turn = (headingDegrees_ + azimuths_[static_cast<std::size_t>(column)]) / 360.0;
        const int width = sky_->panorama.width;
        fetch(std::min(width - 1, static_cast<int>((turn - std::floor(turn)) * width)), first,
              last);
    }
    std::copy(colours_.begin() + first, colours_.begin() + last, slice + first);
}

// Copies rows of a panorama's column into `colours_`. The panorama is stored by rows, so the pixels
// of a column are far apart in memory; but several neighbouring slices show the same column.
void SkyRows::fetch(int panoramaColumn, int first, int last) {
    if (panoramaColumn != fetchedColumn_) {
        fetchedColumn_ = panoramaColumn;
        fetchedFirst_ = fetchedLast_ = first;
    }
    const Pixel* const texels = sky_->panorama.pixels.data() + panoramaColumn;
    const int* const offsets = panoramaOffsets_.data();
    Pixel* const colours = colours_.data();
    if (first < fetchedFirst_) {
        for (int row = first; row < fetchedFirst_; ++row) colours[row] = texels[offsets[row]];
        fetchedFirst_ = first;
    }
    if (last > fetchedLast_) {
        for (int row = fetchedLast_; row < last; ++row) colours[row] = texels[offsets[row]];
        fetchedLast_ = last;
    }
}

}  // namespace slicecast

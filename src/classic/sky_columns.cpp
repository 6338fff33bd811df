#include "classic/sky_columns.h"

#include <algorithm>
#include <cmath>

namespace slicecast::classic {

SkyColumns::SkyColumns(const World& world, const View& view, const RowGrid& rows)
    : world_(world),
      upright_(rows.rows, view.distance / rows.pixelSize, view.horizon / rows.pixelSize),
      mirrored_(upright_.mirrored()),
      seen_(2 * world.maps.size()) {}

Pixel SkyColumns::at(int map, bool isMirrored, double azimuthDegrees, int row) {
    std::unique_ptr<Seen>& seen = seen_[static_cast<std::size_t>(2 * map + (isMirrored ? 1 : 0))];
    const Projection& rows = isMirrored ? mirrored_ : upright_;
    if (seen == nullptr) {
        seen = std::make_unique<Seen>();
        const Sky& sky = world_.maps[static_cast<std::size_t>(map)].sky;
        seen->layers.beginFrame(sky, rows, world_.steps);
        // One more: a row at the horizon may have been rounded to the other side of it
        seen->colours.assign(static_cast<std::size_t>(rows.firstFallingRow) + 1, toPixel(sky.low));
    }
    const double turn = azimuthDegrees / 360.0;
    const int column =
        std::min(kSkyColumns - 1, static_cast<int>((turn - std::floor(turn)) * kSkyColumns));
    if (column != seen->column) {
        seen->column = column;
        seen->layers.fill(seen->colours.data(), column, 0, rows.firstFallingRow);
    }
    return seen->colours[static_cast<std::size_t>(isMirrored ? rows.height - 1 - row : row)];
}

}  // namespace slicecast::classic

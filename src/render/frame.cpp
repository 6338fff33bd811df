#include "render/frame.h"

#include <algorithm>
#include <cmath>

namespace slicecast {

Frame::Frame(const World& w, const Eye& e, const RenderOptions& options, int width, int height, std::vector<double>& slopes, PlaneShades& shades, SkyRows& sky)
    : world(&w), map(&w.maps[static_cast<std::size_t>(e.map)]), eye(e), projection(e, options, width, height), lighting(*map, options),
      detail(options, projection.distance), inverseSlopes(slopes), planeShades(shades), skyRows(sky) {
    inverseSlopes.resize(static_cast<std::size_t>(height));
    for (int row = 0; row < height; ++row) inverseSlopes[static_cast<std::size_t>(row)] = projection.distance / std::fabs(projection.horizon - (row + 0.5));

    const double farRow = projection.rowOf(-eye.z.value(), map->far);
    firstFloorRow = std::max(projection.firstFallingRow, projection.firstRowBelowRow(farRow, true));
    highest = std::max<double>(map->levels, map->ceiling.tiles.empty() ? 0.0 : map->ceiling.height.value());

    planeShades.beginFrame(lighting, inverseSlopes.data(), height);
    skyRows.beginFrame(map->sky, projection, eye.headingDegrees);
}

}  // namespace slicecast

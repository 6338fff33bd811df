#include "render/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicecast {

Frame::Frame(const World& w, const Eye& e, const RenderOptions& options, int width, int height, std::vector<double>& slopes,
             std::vector<FrameTexture>& current, FrameObjects& seenObjects, PlaneShades& shades, SkyRows& sky)
    : world(&w), map(&w.maps[static_cast<std::size_t>(e.map)]), eye(e), projection(e, options, width, height), lighting(*map, options),
      detail(options, projection.distance), inverseOffsets(slopes), textures(current), objects(seenObjects), planeShades(shades), skyRows(sky) {
    inverseOffsets.resize(static_cast<std::size_t>(height));
    for (int row = 0; row < height; ++row) {
        const double offset = std::fabs(projection.horizon - (row + 0.5));
        inverseOffsets[static_cast<std::size_t>(row)] = offset > 0.0 ? 1.0 / offset : std::numeric_limits<double>::infinity();
    }

    const double farRow = projection.rowOf(-eye.z.value(), map->far);
    firstFloorRow = std::max(projection.firstFallingRow, projection.firstRowBelowRow(farRow, true));
    highest = std::max<double>(map->levels, map->ceiling.tiles.empty() ? 0.0 : map->ceiling.height.value());

    textures.resize(w.textures.size());
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const Texture& texture = w.textures[i];
        const std::vector<TextureLevel>& levels = texture.levelsOf(texture.frameAt(w.seconds));
        textures[i] = {levels.data(), texture.size(), static_cast<int>(levels.size()) - 1, texture.seeThrough};
    }

    objects.beginFrame(w, *map, eye, projection, detail, lighting);
    highest = std::max(highest, objects.highest());

    planeShades.beginFrame(lighting, projection.distance, inverseOffsets.data(), height);
    skyRows.beginFrame(map->sky, projection, eye.headingDegrees);
}

}  // namespace slicecast

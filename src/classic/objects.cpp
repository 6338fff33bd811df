// The objects that a column meets.
#include "base/angle.h"
#include "base/sort.h"
#include "classic/surfaces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace slicecast::classic {

void gatherObjects(const Scenery& scenery, std::vector<Surface>& surfaces) {
    const View& view = scenery.view;
    const ColumnRay& ray = scenery.ray;
    const double forwardX = cosDegrees(view.headingDegrees);
    const double forwardY = sinDegrees(view.headingDegrees);
    const double stretch = scenery.classic.wrongScale ? view.distance / view.height : 1.0;
    for (std::size_t i = 0; i < scenery.map.objects.size(); ++i) {
        const Object& object = scenery.map.objects[i];
        if (view.oneLevel && object.z.tile() != view.storey) continue;

        // Where the ray meets the object's plane
        const double x = object.x.value() - view.eyeX;
        const double y = object.y.value() - view.eyeY;
        const double ahead = std::floor(65536.0 * (forwardX * x + forwardY * y) + 0.5) / 65536.0;
        const double along = ahead / ray.ahead;
        const double depth = along * ray.depthPerAlong;
        if (!(ahead > 0.0) || depth <= scenery.begins) continue;
        const double aside = (along * ray.y - y) * forwardX - (along * ray.x - x) * forwardY;
        const double u = aside * stretch / object.width.value() + 0.5;
        if (!(u >= 0.0 && u < 1.0)) continue;

        Surface surface;
        surface.what = FilledRows::What::object;
        surface.texture = object.sprite;
        surface.light = object.light;
        surface.glow = object.glow;
        surface.passing = Passing::object;
        surface.object = static_cast<int>(i);
        surface.along = along;
        surface.nearest = surface.farthest = depth;
        surface.textureBottom = object.z.value() - view.storey;
        surface.textureTop = surface.textureBottom + object.height.value();
        surface.stretch = stretch;
        surface.u = u;
        // Wider than a coordinate: behind portals the eye may be far outside the grid
        surface.side = sideTowards(object, std::int64_t{toCoordinate(view.eyeX).raw} - object.x.raw,
                                   std::int64_t{toCoordinate(view.eyeY).raw} - object.y.raw);
        const double z = (surface.textureBottom + surface.textureTop) / 2.0 - view.eyeZ;
        surface.thingDistance = x * x + y * y + z * z;
        const double top = view.rowOf(surface.textureTop, depth * stretch);
        const double bottom = view.rowOf(surface.textureBottom, depth * stretch);
        surface.firstRow = scenery.rows.firstBelow(std::min(top, bottom));
        surface.lastRow = scenery.rows.firstBelow(std::max(top, bottom));
        if (surface.firstRow < surface.lastRow) surfaces.push_back(surface);
    }
    mergeSort(surfaces, [](const Surface& a, const Surface& b) { return a.nearest < b.nearest; });
}

void hideBehindFirstBlock(std::vector<Surface>& surfaces) {
    double first = std::numeric_limits<double>::infinity();
    for (const Surface& surface : surfaces) {
        if (surface.block >= 0 && surface.isUpright() && surface.passing == Passing::entered)
            first = std::min(first, surface.along);
    }
    std::erase_if(surfaces, [&](const Surface& surface) {
        return surface.what == FilledRows::What::object && surface.along >= first;
    });
}

}  // namespace slicecast::classic

#include "answers/spot.h"

namespace slicecast {

std::optional<Spot> spotOf(const Session& session, const Place& place, int map, int width,
                           int height) {
    const Eye eye = session.drawnEye();
    const std::optional<PicturePoint> point = project(session, eye, place, map, width, height);
    if (!point) return std::nullopt;
    const World& world = session.world();
    const bool isInside =
        point->x >= 0.0 && point->x <= width && point->y >= 0.0 && point->y <= height;
    return Spot{*point,
                isInside && isInSight(world, world.maps[static_cast<std::size_t>(map)],
                                      {eye.x.value(), eye.y.value(), eye.z.value()}, place)};
}

}  // namespace slicecast

#include "session/spot.h"

#include "render/projection.h"

namespace slicecast {

std::optional<Spot> spotOf(const Session& session, const Place& place, int map, int width,
                           int height) {
    const Eye eye = session.drawnEye();
    if (map != eye.map) return std::nullopt;
    const Projection projection(eye, session.options().render, width, height);
    const Place from = {eye.x.value(), eye.y.value(), eye.z.value()};
    const double east = place.x - from.x;
    const double south = place.y - from.y;
    const double depth = east * projection.forward.x + south * projection.forward.y;
    if (!(depth > 0.0)) return std::nullopt;
    const double sideways = east * projection.right.x + south * projection.right.y;
    Spot spot = {width / 2.0 + sideways * projection.distance / depth,
                 projection.rowOf(place.z - from.z, depth), depth};
    const World& world = session.world();
    spot.isSeen = spot.x >= 0.0 && spot.x <= width && spot.y >= 0.0 && spot.y <= height &&
                  isInSight(world, world.maps[static_cast<std::size_t>(map)], from, place);
    return spot;
}

}  // namespace slicecast

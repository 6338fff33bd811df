// Where a place of the world stands in the picture that a session drew last, for a label on it.
//
//     const auto spot = spotOf(session, {.x = 4.5, .y = 2.0, .z = 0.5}, map, 640, 400);
//     if (spot && spot->isSeen) ...      at spot->x, spot->y
#pragma once

#include "session/pick.h"

#include <optional>

namespace slicecast {

struct Spot : PicturePoint {
    bool isSeen = false;  // within the picture, and nothing in between (world/line_of_sight.h)
};

// Nothing for a place that is not before the eye, or in another map.
std::optional<Spot> spotOf(const Session& session, const Place& place, int map, int width,
                           int height);

}  // namespace slicecast

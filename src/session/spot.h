// Finds where a place of the world appears in the picture that a session drew last, for a label
// there.
//
//     const auto spot = spotOf(session, {.x = 4.5, .y = 2.0, .z = 0.5}, map, 640, 400);
//     if (spot && spot->isSeen) ...      at spot->x, spot->y
#pragma once

#include "session/pick.h"

#include <optional>

namespace slicecast {

struct Spot : PicturePoint {
    bool isSeen =
        false;  // inside the picture, and nothing stands in between (world/line_of_sight.h)
};

// Nothing for a place in another map, or not in front of the eye.
std::optional<Spot> spotOf(const Session& session, const Place& place, int map, int width,
                           int height);

}  // namespace slicecast

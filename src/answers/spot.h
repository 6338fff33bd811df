// Finds where a place of the world appears in the picture that a session drew last, to put a label
// there.
//
//     const auto spot = spotOf(session, {.x = 4.5, .y = 2.0, .z = 0.5}, map, 640, 400);
//     if (spot && spot->isSeen) ...      at spot->x, spot->y
#pragma once

#include "answers/pick.h"

#include <optional>

namespace slicecast {

struct Spot : PicturePoint {
    // It is inside the picture, and nothing stands before it (world/line_of_sight.h)
    bool isSeen = false;
};

// `width` and `height` are the picture's, in pixels. Nothing for a place in another map than the
// eye's, or not in front of the eye.
std::optional<Spot> spotOf(const Session& session, const Place& place, int map, int width,
                           int height);

}  // namespace slicecast

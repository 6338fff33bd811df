// A line in the world that is laid over the picture, dashed where something hides it.
#pragma once

#include "slicecast/colour.h"
#include "slicecast/place.h"

#include <cstddef>

namespace slicecast {

inline constexpr std::size_t kMostMarks = 16384;  // of a picture: outlines of 1,365 boxes

struct Mark {
    int map = 0;  // index in Scene::maps
    Place from;
    Place to;
    Colour colour;
};

}  // namespace slicecast

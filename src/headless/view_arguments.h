// How a command line says from where to look and how large a picture to draw.
//
//     --eye 3.5,4,0.5,90,0        x, y, height of the eye (units), heading (degrees, 0 = east, 90 = south), look (screen heights, positive up)
//     --size 1280x720             pixels
#pragma once

#include "render/eye.h"

#include <optional>
#include <string>

namespace slicecast {

struct PictureSize {
    int width = 1280;  // pixels
    int height = 720;
};

// A value, or in words what was found and what was expected.
template <typename Value>
struct Read {
    std::optional<Value> value;
    std::string fault;
};

Read<PictureSize> readSize(const std::string& text);

// A column of a picture, 0 on the left.
Read<int> readColumn(const std::string& text, int width);

// The eye in the map with index `map`. One that sees nothing, at or below the floor, is refused.
// Seconds, to the nearest step of the simulation: how many steps (1/120 s) that is.
Read<int> readTime(const std::string& text);

Read<Eye> readEye(const std::string& text, int map);

}  // namespace slicecast

// Reads the viewpoint and the size of the picture from a command line.
//
//     --eye 3.5,4,0.5,90,0        x, y, height of the eye (units), heading (degrees, 0 = east,
//                                 90 = south), look (screen heights, positive up)
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

// A value, or a message with what was found and expected.
template <typename Value>
struct Read {
    std::optional<Value> value;
    std::string fault;
};

Read<PictureSize> readSize(const std::string& text);

// A column of a picture, 0 on the left.
Read<int> readColumn(const std::string& text, int width);

// Seconds, returned as steps (1/120 s), rounded to the nearest.
Read<int> readTime(const std::string& text);

// The eye in the map with index `map`. Refuses one at or below the floor, because it sees
// nothing.
Read<Eye> readEye(const std::string& text, int map);

}  // namespace slicecast

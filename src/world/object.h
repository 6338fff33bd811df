// Objects: billboards. An object is an upright rectangle parallel to the picture plane that always
// faces the viewer: `width` units wide, centred on (x, y), with its feet at height z. It has one
// depth t, that of its middle, rounded to 1/65536.
#pragma once

#include "base/coordinate.h"
#include "world/baked_light.h"

#include <cstdint>

namespace slicecast {

using SpriteId = std::uint16_t;  // index into World::sprites

struct Object {
    SpriteId sprite = 0;
    Coordinate x;
    Coordinate y;
    Coordinate z;        // >= 0
    Coordinate width;    // > 0
    Coordinate height;   // > 0
    double light = 1.0;  // see FaceBlueprint
    bool glow = false;
    bool floats = false;    // floats on water
    LampId lamp = kNoLamp;  // at 4/5 of its height; only of objects that stay where they are
};

}  // namespace slicecast

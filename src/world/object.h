// Objects: billboards. An object is an upright rectangle parallel to the picture plane that always
// faces the viewer: `width` units wide, centred on (x, y), with its feet at height z. It has one
// depth t, that of its middle, rounded to 1/65536. A sprite with four views shows the side that the
// object turns to the eye.
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
    // Where it faces: one unit long, to the nearest 1/65536; east at first.
    Coordinate facingX = tileEdge(1);
    Coordinate facingY = {};

    friend bool operator==(const Object&, const Object&) = default;
};

// The sides of an object, in the order of a sprite's rows.
enum class ObjectSide : std::uint8_t { front, right, back, left };
inline constexpr int kSpriteViews = 4;

// The side that an object turns to an eye; (x, y) leads from its middle to the eye, 1/65536 units.
// On a diagonal it is the front or the back, and for an eye above the middle the front.
constexpr ObjectSide sideTowards(const Object& object, std::int64_t x, std::int64_t y) {
    const std::int64_t ahead = object.facingX.raw * x + object.facingY.raw * y;
    const std::int64_t right = object.facingX.raw * y - object.facingY.raw * x;
    const std::int64_t aside = right < 0 ? -right : right;
    if (ahead >= aside) return ObjectSide::front;
    if (-ahead >= aside) return ObjectSide::back;
    return right > 0 ? ObjectSide::right : ObjectSide::left;
}

}  // namespace slicecast

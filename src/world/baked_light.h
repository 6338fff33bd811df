// Baked light: a sun, an ambient colour and lamps, which light the faces of a map's blocks through
// its air. What light reaches which texel is defined in web/docs/picture.md.
#pragma once

#include "base/coordinate.h"
#include "slicecast/colour.h"

#include <cstdint>
#include <vector>

namespace slicecast {

inline constexpr Coordinate kFarthestLamp = {16 * 65536};
inline constexpr double kStrongestLamp = 16.0;
// Of a map: those of the map's list, then of objects, then of faces. Others do not shine.
inline constexpr std::size_t kMaxLamps = 65'536;
// That light what lies in one cube of kLampCube units a side: the nearest ones. Each sample in the
// cube sends a ray to each of them.
inline constexpr std::size_t kMaxLampsOfCube = 64;
inline constexpr int kLampCube = 4;  // units

using LampId = std::uint16_t;  // index into World::lampKinds
inline constexpr LampId kNoLamp = 0xffff;

struct LampKind {
    Colour colour = {255, 255, 255, 255};
    double strength = 1.0;            // 0 to kStrongestLamp
    Coordinate radius = tileEdge(4);  // beyond it the lamp lights nothing; above 0

    friend bool operator==(const LampKind&, const LampKind&) = default;
};

struct Lamp {
    Coordinate x;
    Coordinate y;
    Coordinate z;
    LampKind kind;

    friend bool operator==(const Lamp&, const Lamp&) = default;
};

struct BakedLight {
    bool on = false;
    Colour sun = {0, 0, 0, 255};  // black: no sun
    double azimuth = 0.0;         // degrees, where the sun stands: 0 = east, 90 = south
    double altitude = 45.0;       // degrees, above 0 and at most 90
    Colour ambient = {0, 0, 0, 255};
    std::vector<Lamp> lamps;
    double lampStrength = 1.0;  // multiplies that of all lamps, 0 to kStrongestLamp

    friend bool operator==(const BakedLight&, const BakedLight&) = default;
};

}  // namespace slicecast

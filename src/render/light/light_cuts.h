// The planes that cut a block of light's world out of its box: slopes, and the cut of a half.
// Everything is exact, also the small steps by which samples count as moved (see LightWay): they
// move the moments at which ways cross the planes.
#pragma once

#include "render/light/light_way.h"
#include "world/blueprint.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace slicecast {

// A moment of a way, num / den of its vector: `num` from where the way begins; den 0 is never. The
// small step along each axis makes it later by late / den.
struct CutMoment {
    std::int64_t num;
    std::int64_t den;
    std::array<std::int64_t, 3> late{};

    CutMoment(std::int64_t numerator, std::int64_t denominator,
              std::array<std::int64_t, 3> lateness = {})
        : num(numerator), den(denominator), late(lateness) {}
    // Of a way, whose last bits tell by which axis it is late.
    CutMoment(const LightWay& way, LightMoment moment) : den(way.whole / 8) {
        const LightMoment order = ((moment + 4) & 7) - 4;
        num = (moment - order) / 8;
        if (order != 0) {
            const auto axis = static_cast<std::size_t>(3 - std::abs(order));
            late[axis] = order < 0 ? -way.shares[axis] / 8 : way.shares[axis] / 8;
        }
    }

    bool isBefore(const CutMoment& other) const {
        __extension__ using Wide = __int128;
        const Wide left = Wide{num} * other.den;
        const Wide right = Wide{other.num} * den;
        if (left != right) return left < right;
        for (std::size_t i = 0; i < 3; ++i) {
            const Wide lateLeft = Wide{late[i]} * other.den;
            const Wide lateRight = Wide{other.late[i]} * den;
            if (lateLeft != lateRight) return lateLeft < lateRight;
        }
        return false;
    }
};

// Points inside have normal * (point - origin) > 0.
struct LightCut {
    Face face = Face::top;  // that the block has there
    std::array<std::int64_t, 3> normal{};
    LightVector origin{};

    std::int64_t along(const LightVector& v) const {
        return normal[0] * v[0] + normal[1] * v[1] + normal[2] * v[2];
    }
    std::int64_t depthOf(const LightVector& point) const {
        return along({point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]});
    }
    // On the plane, the small steps decide.
    bool contains(const LightVector& point) const {
        const std::int64_t depth = depthOf(point);
        if (depth != 0) return depth > 0;
        for (const std::int64_t part : normal) {
            if (part != 0) return part > 0;
        }
        return false;
    }
};

// A moving block's slopes as light sees them: with the motion's offset rounded down to a quarter of
// a unit, so that they seldom change.
constexpr Slopes slopesInLight(const CellBlueprint& block) {
    const auto back = [](Coordinate offset) { return Coordinate{-(offset.raw & 0x3fff)}; };
    return moved(block.slopes, back(block.textureEast), back(block.textureSouth),
                 back(block.textureRise));
}

// Up to three cuts of a block whose tile and level begin at `origin`; `use` returns false to stop.
// Returns whether it went through all of them.
template <typename Use>
bool eachCut(const CellBlueprint& block, const LightVector& origin, Use&& use) {
    const Half half = block.plan.half;
    if (half != Half::none) {
        const std::int64_t east = isEastern(half) ? 1 : -1;
        const bool isFalling = isCutFalling(half);
        if (!use(LightCut{cutFace(half),
                          {east, isFalling ? -east : east, 0},
                          {origin[0] + (isFalling ? 0 : 65536), origin[1], origin[2]}}))
            return false;
    }
    if (!block.slopes.any()) return true;
    const Slopes slopes = slopesInLight(block);
    for (const Face face : {Face::bottom, Face::top}) {
        const Slant& slant = slopes.of(face);
        if (slant.isLevel()) continue;
        const std::int64_t up = face == Face::bottom ? 1 : -1;
        const std::int64_t ahead = -up * slant.rise();
        if (!use(LightCut{
                face,
                {slopes.alongX ? ahead : 0, slopes.alongX ? 0 : ahead, up * 65536},
                {origin[0] + (slopes.alongX ? slant.shift.raw : 0),
                 origin[1] + (slopes.alongX ? 0 : slant.shift.raw), origin[2] + slant.from.raw}}))
            return false;
    }
    return true;
}

}  // namespace slicecast

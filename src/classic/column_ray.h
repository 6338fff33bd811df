// The direction of one column of the picture in the world, by each of the old projections.
//
//     equal angles                 plane
//     \  |  |  /                   \   |   /         ground lines of columns from above; both kinds
//      \ | | /                      \  |  /          agree at the picture's edges and its middle
//       \|/                          \ | /
#pragma once

#include "classic/classic_options.h"
#include "render/eye.h"
#include "render/options.h"
#include "world/portal.h"
#include "world/world.h"

namespace slicecast::classic {

// Sine and cosine from a table with a number of steps for the full turn, as in old programs: the
// entry at or before the angle. 0 steps: no table.
struct SineTable {
    int steps = 0;

    double sine(double degrees) const;
    double cosine(double degrees) const;
};

// A ground line from the eye. `along` is in multiples of its direction.
struct ColumnRay {
    double x = 0.0;  // direction
    double y = 0.0;
    double length = 1.0;  // of that direction, units
    // Both are at least the cosine of half the widest view, so that anything may be divided by them
    double depthPerAlong = 1.0;  // factor from `along` to the depth for heights and light
    double ahead =
        1.0;  // factor from `along` to units along the eye's heading; for meeting objects
    double azimuthDegrees = 0.0;  // for the sky
};

// The view of a map in the picture. Positions in the picture are pixels from its upper left, real
// numbers: a pixel's centre is at + 0.5.
struct View {
    double width = 0.0;
    double height = 0.0;
    double distance = 1.0;  // to the projection plane, pixels
    double horizon = 0.0;
    double fovDegrees = 60.0;
    double headingDegrees = 0.0;
    double eyeX = 0.0;  // in the map's coordinates
    double eyeY = 0.0;
    double eyeZ = 0.0;
    double up = 1.0;  // -1 in a mirror: from below, upside down
    bool oneLevel = false;
    int storey = 0;  // heights count from this level's base: the eye's level if only one level is
                     // drawn, else 0
    ClassicProjection projection = ClassicProjection::plane;
    SineTable table;

    View() = default;
    View(const World& world, const Eye& eye, const RenderOptions& options,
         const ClassicOptions& classic, int pictureWidth, int pictureHeight);

    ColumnRay rayAt(double x) const;
    double upwardSlopeAt(double y) const { return up * (horizon - y) / distance; }
    // The row of a height at a depth; infinitely high or low at depth 0.
    double rowOf(double z, double depth) const;
    // The depth of a plane in a row that meets it. It has height z over or under the eye, and
    // climbs by so much per unit of depth. Infinite for a row that runs along it; never a negative
    // zero, which has other bits than zero.
#if defined(__clang__)
    __attribute__((no_sanitize("float-divide-by-zero")))
#endif
    double
    depthOfPlane(double z, double y, double climb = 0.0) const {
        return (z - eyeZ) * distance / (up * (horizon - y) - climb * distance) + 0.0;
    }

    // The view behind a portal, in the coordinates of its exit map.
    View beyond(const Portal& portal) const;
    // The view in a mirror at that height.
    View mirroredAt(double z) const;
};

ColumnRay beyond(const ColumnRay& ray, const Portal& portal);

}  // namespace slicecast::classic

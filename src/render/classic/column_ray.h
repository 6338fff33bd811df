// How one column of the picture looks into the world, by each of the old projections.
//
//     equal angles                 plane
//     \  |  |  /                   \   |   /         a column's ground line from above; both kinds
//      \ | | /                      \  |  /          meet at the picture's edges and its middle
//       \|/                          \ | /
#pragma once

#include "render/classic/classic_options.h"
#include "render/eye.h"
#include "render/options.h"
#include "world/portal.h"
#include "world/world.h"

namespace slicecast::classic {

// Sine and cosine as programs had them from a table with a number of steps over the full turn: the
// entry at or before the angle. 0 steps stand for no table.
struct SineTable {
    int steps = 0;

    double sine(double degrees) const;
    double cosine(double degrees) const;
};

// A ground line from the eye. `along` counts in its own direction's lengths.
struct ColumnRay {
    double x = 0.0;  // direction
    double y = 0.0;
    double length = 1.0;         // of that direction, units
    double depthPerAlong = 1.0;  // what heights and light take for the depth
    double ahead = 1.0;  // how far a length of it goes along the eye's heading, units: an object is
                         // met where this makes up its depth
    double azimuthDegrees = 0.0;  // where the sky is looked at
};

// What the picture shows of a map, and from where. Places on the picture are in pixels from its
// upper left, real numbers: a pixel's centre is at + 0.5.
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
    double up = 1.0;  // -1 where it is seen in a mirror, from below it and upside down
    bool oneLevel = false;
    int storey = 0;  // heights count from this level's base: the eye's level where there is one
                     // level only, else 0
    ClassicProjection projection = ClassicProjection::plane;
    SineTable table;

    View() = default;
    View(const World& world, const Eye& eye, const RenderOptions& options,
         const ClassicOptions& classic, int pictureWidth, int pictureHeight);

    ColumnRay rayAt(double x) const;
    double upwardSlopeAt(double y) const { return up * (horizon - y) / distance; }
    // Where a height appears at a depth; infinitely high or low at depth 0.
    double rowOf(double z, double depth) const;
    // The depth of a level plane in a row that is not the horizon's.
    double depthOfPlane(double z, double y) const {
        return (z - eyeZ) * distance / (up * (horizon - y));
    }

    // What is behind a portal, in the coordinates of its exit map.
    View beyond(const Portal& portal) const;
    // What a mirror at that height shows.
    View mirroredAt(double z) const;
};

ColumnRay beyond(const ColumnRay& ray, const Portal& portal);

}  // namespace slicecast::classic

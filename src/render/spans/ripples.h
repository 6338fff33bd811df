// Ripples on mirrors: waves that move what a mirror reflects up and down, by whole rows.
//
//     row of a mirror   ->  the row, at most `mostRippleRows` away, whose reflection it shows
//
// How far is a function of the mirror's point and of time (web/docs/picture.md). It never leads
// from one mirror to another, nor to where the column shows something else than the mirror: what is
// reflected in other rows is not known. See-through things before the mirror do not count; so the
// walk must go on for so many rows beside what shows (cutTexels).
#pragma once

#include "slicecast/colour.h"

#include <array>
#include <cstddef>
#include <vector>

namespace slicecast {

struct ColumnSpans;
struct Frame;
struct MirrorSpan;

// A point of a mirror with ripples, at a step of the world.
struct RippledPoint {
    int x = 0;  // 1/256 units
    int y = 0;
    int step = 0;
    int ripples = 0;         // of the mirror, of 255
    double offset = 0.0;     // rows below the horizon
    double perSquare = 1.0;  // the eye's height over the mirror, times the distance to the plane
};

// By how many rows, at most `most`, what it reflects is moved down.
int rippledBy(const RippledPoint& point, int most);

// Finds which rows of a column show mirrors.
void findMirrorPlanes(const Frame& frame, const ColumnSpans& found);

// For each row of a span of that column, by row, the row whose reflection it shows; valid until the
// next call. The mirror has ripples.
const int* findRippledRows(const Frame& frame, int column, const ColumnSpans& found,
                           const MirrorSpan& span);

}  // namespace slicecast

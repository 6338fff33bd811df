// What one slice of a picture meets: a line where it is, with a stripe that tells what fills each of its rows, and a view of it from the side.
//
//     height |            +-----+                      the blocks that its ground line passes, brighter where they are seen,
//            |     +---+--|     |---                   and rays from the eye to the rows that they fill, in the stripe's colours
//        eye o-----|   |  |     |
//            +-----+---+--+-----+--- depth
#pragma once

#include "overlay/blend.h"
#include "render/eye.h"
#include "render/picture.h"
#include "render/trace.h"
#include "world/world.h"

namespace slicecast {

// The colour that stands for what fills rows.
Colour kindColour(FilledRows::What what);

// The line of the traced slice, from the top of the picture to its bottom.
void drawSliceLine(const SliceTrace& trace, const Picture& picture);

// The slice seen from the side, in its place (see layout.h).
void drawSideView(const SliceTrace& trace, const World& world, const Eye& eye, const Picture& picture);

}  // namespace slicecast

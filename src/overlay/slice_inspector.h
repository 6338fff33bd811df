// Shows what one slice of a picture meets: a line at the slice, with a stripe that shows what fills
// each of its rows, and a side view.
//
//     height |            +-----+       :          |    the blocks on its ground line,
//            |     +---+--|     |---    :cellar    |    brighter where seen, objects as
//        eye o-----|   |  |     |       :    +--+       bars, rays to the rows they fill,
//            +-----+---+--+-----+-------:----+--+-- depth      in the stripe's colours
//
// A vertical line with a map's name is a portal into it. Behind it depths and heights continue as
// the eye sees them. A dashed line is a mirror, with faint reflected rays.
#pragma once

#include "overlay/blend.h"
#include "render/eye.h"
#include "render/trace.h"
#include "slicecast/picture.h"
#include "world/world.h"

#include <span>

namespace slicecast {

inline constexpr Colour kObjectColour = {255, 246, 220, 255};
inline constexpr Colour kPortalColour = {64, 224, 208, 255};  // as on the minimap
inline constexpr Colour kMirrorColour = {214, 234, 255, 255};

// A kind of filled rows, with its name and colour.
struct SliceKind {
    FilledRows::What what;
    const char* name;
    Colour colour;
};
std::span<const SliceKind> sliceKinds();
Colour kindColour(FilledRows::What what);

// A line at the traced slice, from the top of the picture to its bottom.
void drawSliceLine(const SliceTrace& trace, const Picture& picture);

// The side view of the slice, in its place (see layout.h). In side_view.cpp.
void drawSideView(const SliceTrace& trace, const World& world, const Eye& eye,
                  const Picture& picture);

}  // namespace slicecast

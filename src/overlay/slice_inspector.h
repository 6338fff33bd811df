// What one slice of a picture meets: a line where it is, with a stripe that tells what fills each
// of its rows, and a view of it from the side.
//
//     height |            +-----+       :          |       the blocks that its ground line passes, brighter where they are seen, objects as bars,
//            |     +---+--|     |---    :cellar    |       and rays from the eye to the rows that they fill, in the stripe's colours;
//        eye o-----|   |  |     |       :    +--+          an upright line where rays go through a portal into that map
//            +-----+---+--+-----+-------:----+--+-- depth
//
// Behind a portal depths and heights go on as the eye sees them. Where the slice meets a mirror, a
// dashed line is that mirror, and faint rays go up from it.
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

// What fills rows, its name and the colour that stands for it.
struct SliceKind {
    FilledRows::What what;
    const char* name;
    Colour colour;
};
std::span<const SliceKind> sliceKinds();
Colour kindColour(FilledRows::What what);

// The line of the traced slice, from the top of the picture to its bottom.
void drawSliceLine(const SliceTrace& trace, const Picture& picture);

// The slice seen from the side, in its place (see layout.h). In side_view.cpp.
void drawSideView(const SliceTrace& trace, const World& world, const Eye& eye,
                  const Picture& picture);

}  // namespace slicecast

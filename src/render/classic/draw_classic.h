// The slow renderer for lessons: draws a world by the old ways of ClassicOptions. It computes every
// pixel on its own and shares only plain data with the fast renderer: eye, options, light, picture,
// trace.
//
//     column_ray       the direction of a column of the picture
//     tile_spans       the tiles that it passes: exactly, or by marching
//     surfaces         the surfaces on those tiles and their rows; objects
//     colouring        a surface's colour in a row
//     column           what its rows show, also behind portals and in mirrors
//
// It differs from the definition in two points: it has no levels of detail, and does not join
// see-through blocks that touch through a portal.
#pragma once

#include "render/classic/classic_options.h"
#include "render/eye.h"
#include "render/options.h"
#include "render/trace.h"
#include "slicecast/picture.h"
#include "world/world.h"

#include <optional>

namespace slicecast {

// Draws the leftmost `columns` columns of the picture, or all of a narrower picture, and returns
// the work done. Returns nothing and changes nothing where the fast renderer would refuse, or if a
// classic option is out of range.
//
// In the report, tilesWalked counts the places along the ground at which tiles were looked up, and
// rowsFilled includes overpainted rows; a pixel of `pixelSize` counts once.
std::optional<FrameReport> drawClassic(const World& world, const Eye& eye,
                                       const RenderOptions& options, const ClassicOptions& classic,
                                       const Picture& picture, int columns = kMaxPictureSide);

// Traces one column of such a picture. Empty for an invalid eye or column. For a march, borders of
// tiles are where it found them. The watched row is traced at the middle of its pixel, however
// coarse that is.
SliceTrace traceClassic(const World& world, const Eye& eye, const RenderOptions& options,
                        const ClassicOptions& classic, const ColumnRequest& request);

}  // namespace slicecast

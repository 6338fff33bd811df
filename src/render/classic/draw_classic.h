// The slow renderer for lessons: draws a world by the old ways that ClassicOptions names. It works
// out every pixel by itself and shares nothing with the fast renderer but plain data: the eye, the
// options, the light, the picture, the trace.
//
//     column_ray       how a column of the picture looks into the world
//     tile_spans       which tiles it passes: exactly, or by marching
//     surfaces         what on those tiles it could see, in which rows; objects
//     colouring        a surface's colour in a row
//     column           what its rows show, behind portals and in mirrors too
//
// What it leaves out of the definition: levels of detail, and that see-through blocks which touch
// through a portal are joined.
#pragma once

#include "render/classic/classic_options.h"
#include "render/eye.h"
#include "render/options.h"
#include "render/trace.h"
#include "slicecast/picture.h"
#include "world/world.h"

#include <optional>

namespace slicecast {

// Draws the leftmost `columns` columns of the picture, all of them if it is no wider, and tells
// what that took. Gives nothing and leaves the picture alone where the fast renderer would, or if a
// classic option is out of its range.
//
// In the report, tilesWalked are the places along the ground at which tiles were looked up, and
// rowsFilled counts what was painted over again, a pixel of `pixelSize` as one.
std::optional<FrameReport> drawClassic(const World& world, const Eye& eye,
                                       const RenderOptions& options, const ClassicOptions& classic,
                                       const Picture& picture, int columns = kMaxPictureSide);

// What one column of such a picture shows and met on its way. An invalid eye or column gives an
// empty trace. Of a march, the borders of tiles are where it found them. Of the watched row the
// middle of its pixel is told, however coarse that is.
SliceTrace traceClassic(const World& world, const Eye& eye, const RenderOptions& options,
                        const ClassicOptions& classic, const ColumnRequest& request);

}  // namespace slicecast

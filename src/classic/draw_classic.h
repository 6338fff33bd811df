// The slow renderer for lessons: draws a world by the old ways of ClassicOptions. It finds on its
// own what every pixel shows. Of the fast renderer it takes the colour of a point: levels of
// detail, light, the layers of the sky and the height of waves.
//
//     column_ray       the direction of a column of the picture
//     tile_spans       the tiles that it passes: exactly, or by marching
//     surfaces         the surfaces on those tiles and their rows; objects
//     colouring        a surface's colour in a row
//     sky_columns      skies with layers
//     column           what its rows show, also behind portals and in mirrors
//
// It differs from the definition where a portal's exit is not free: it does not join see-through
// blocks that touch through a portal, and leaves out the side of a block in which rays come out.
#pragma once

#include "classic/classic_options.h"
#include "render/eye.h"
#include "render/light/lit_maps.h"
#include "render/options.h"
#include "render/trace.h"
#include "slicecast/picture.h"
#include "world/world.h"

#include <optional>

namespace slicecast {

// `lit` has what is known of baked light. It may be a renderer's that draws the same world.
//
// Draws the leftmost `columns` columns of the picture, or all of a narrower picture, and returns
// the work done. Returns nothing and changes nothing where the fast renderer would refuse, or if a
// classic option is out of range.
//
// In the report, tilesWalked counts the places along the ground at which tiles were looked up, and
// rowsFilled includes overpainted rows; a pixel of `pixelSize` counts once.
std::optional<FrameReport> drawClassic(const World& world, const Eye& eye,
                                       const RenderOptions& options, const ClassicOptions& classic,
                                       LitMaps& lit, const Picture& picture,
                                       int columns = kMaxPictureSide);

// Traces one column of such a picture. Empty for an invalid eye or column. For a march, borders of
// tiles are where it found them. The watched row is traced at the middle of its pixel, however
// coarse that is.
SliceTrace traceClassic(const World& world, const Eye& eye, const RenderOptions& options,
                        const ClassicOptions& classic, LitMaps& lit, const ColumnRequest& request);

}  // namespace slicecast

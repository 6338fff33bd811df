// Baked light on blended colours: that of a point instead of a texel's middle. See "Smooth
// textures" in web/docs/picture.md.
#pragma once

#include "render/light/light_samples.h"
#include "render/pixels/column_fill.h"

#include <cstdint>

namespace slicecast {

// A colour in the light of a point: `a` and `b` are its place along the axes of the face, in
// 1/65536 of the tile, below 65536.
Pixel litAt(Pixel colour, const FaceNodes& nodes, std::int32_t a, std::int32_t b);

// The same for a side's colours in rows: `a` is their place along the side, the other one follows
// from the column's positions and the rise of its texture.
void lightSide(Pixel* colours, int rows, const FaceNodes& nodes, std::int32_t a,
               const TexelColumn& column, Coordinate rise);

// The same for a plane's colours in the rows [first, last), by row, all in one tile.
void lightPlane(Pixel* colours, int first, int last, const FaceNodes& nodes, const PlaneLine& line,
                const double* inverseOffsets);

}  // namespace slicecast

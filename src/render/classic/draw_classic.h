// The slow renderer for lessons: draws a world's blocks, floor, ceiling and sky by the old ways
// that ClassicOptions names. It works out every pixel by itself and shares nothing with the fast
// renderer but plain data: the eye, the options, the light, the picture.
//
//     column_ray       how a column of the picture looks into the world
//     tile_spans       which tiles it passes: exactly, or by marching
//     surfaces         what of the blocks on those tiles it could see, in which rows
//     colouring        a surface's colour in a row
#pragma once

#include "render/classic/classic_options.h"
#include "render/eye.h"
#include "render/options.h"
#include "render/picture.h"
#include "world/world.h"

#include <cstdint>

namespace slicecast {

// What a picture took.
struct ClassicReport {
    std::int64_t samples = 0;  // places along the ground at which tiles were looked up
    std::int64_t pixelsPainted =
        0;  // with those that were painted over again; a pixel of `pixelSize` counts as one
};

// Draws the whole picture. Returns false and leaves the picture alone where the fast renderer
// would, or if a classic option is out of its range.
bool drawClassic(const World& world, const Eye& eye, const RenderOptions& options,
                 const ClassicOptions& classic, const Picture& picture,
                 ClassicReport* report = nullptr);

}  // namespace slicecast

// Colours: of a surface in a row, and of what lies behind all surfaces, the floor and the sky.
// Nearest texels of the whole image, never of a smaller one.
#pragma once

#include "base/colour.h"
#include "render/classic/column_ray.h"
#include "render/classic/surfaces.h"
#include "render/options.h"
#include "render/shading.h"
#include "world/world.h"

namespace slicecast::classic {

// An opaque colour with another laid over it.
Pixel laidOver(Pixel colour, Pixel behind);

class Colouring {
public:
    Colouring(const World& world, const Map& map, const View& view, const RenderOptions& options);

    // In the row whose middle is at y. A surface's colour keeps its texel's alpha, the background
    // is opaque.
    Pixel ofSurface(const Surface& surface, const ColumnRay& ray, double y) const;
    Pixel ofBackground(const ColumnRay& ray, double y) const;

private:
    Pixel texel(TextureId texture, double u, double v, bool uReversed, bool vReversed) const;
    Pixel shaded(Pixel texel, double depth, double faceLight, bool glow) const;
    Pixel ofSky(const ColumnRay& ray, double slope) const;

    const World& world_;
    const Map& map_;
    const View& view_;
    Lighting lighting_;
    bool textures_;
};

}  // namespace slicecast::classic

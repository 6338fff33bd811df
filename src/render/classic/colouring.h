// Colours: of a surface in a row, and of what lies behind all surfaces, the floor and the sky.
// Nearest texels of the whole image, never of a smaller one.
#pragma once

#include "render/classic/column_ray.h"
#include "render/classic/surfaces.h"
#include "render/options.h"
#include "render/shading.h"
#include "render/trace.h"
#include "slicecast/colour.h"
#include "world/world.h"

namespace slicecast::classic {

// An opaque colour with another laid over it.
Pixel laidOver(Pixel colour, Pixel behind);

// What a row shows of a surface or of the background.
struct Shown {
    FilledRows::What what = FilledRows::What::haze;
    TextureId texture = kNoTexture;  // or the sprite's number
    TracedTexel texel = {};
    Pixel colour = 0;  // of a surface with its texel's alpha
    int mirror = 0;    // how much of what is above shows in it, 0 to 255
};

class Colouring {
public:
    // What is given here must outlive it.
    Colouring(const World& world, const Map& map, const View& view, const ColumnRay& ray,
              const RenderOptions& options, const ClassicOptions& classic);

    // In the row whose middle is at y.
    Shown ofSurface(const Surface& surface, double y) const;
    Shown ofBackground(double y) const;
    Shown ofHaze() const;
    // It may have holes.
    bool isSeeThrough(const Surface& surface) const;

private:
    // Where a texture, or a sprite, is looked at, and in what light.
    struct Texel {
        TextureId texture = kNoTexture;
        double depth = 0.0;
        double u = 0.0;  // 0 to 1
        double v = 0.0;
        bool uReversed = false;  // counted from the right
        bool vReversed = false;  // counted from the bottom
        double light = 1.0;
        bool glow = false;
        bool plain = false;  // its texture's average
    };

    int mirrorStrength(int strength) const;
    Shown shown(FilledRows::What what, const Texel& texel) const;
    Pixel shaded(Pixel texel, const Shade& shade) const;
    Pixel ofSky(double slope) const;

    const World& world_;
    const Map& map_;
    const View& view_;
    const ColumnRay& ray_;
    const RenderOptions& options_;
    const ClassicOptions& classic_;
    Lighting lighting_;
};

}  // namespace slicecast::classic

// Colours of surfaces in a row, and of the background: the floor and the sky. Uses the nearest
// texel of the full image, without levels of detail.
#pragma once

#include "render/classic/column_ray.h"
#include "render/classic/surfaces.h"
#include "render/options.h"
#include "render/shading.h"
#include "render/trace.h"
#include "slicecast/colour.h"
#include "world/world.h"

namespace slicecast::classic {

// Blends `colour` over an opaque one.
Pixel laidOver(Pixel colour, Pixel behind);

// What a row shows of a surface or of the background.
struct Shown {
    FilledRows::What what = FilledRows::What::haze;
    TextureId texture = kNoTexture;  // or the sprite's number
    TracedTexel texel = {};
    Pixel colour = 0;  // with its texel's alpha, for a surface
    int mirror = 0;    // strength of its reflection, 0 to 255
};

class Colouring {
public:
    // All arguments must outlive it.
    Colouring(const World& world, const Map& map, const View& view, const ColumnRay& ray,
              const RenderOptions& options, const ClassicOptions& classic);

    // For the row whose middle is at y.
    Shown ofSurface(const Surface& surface, double y) const;
    Shown ofBackground(double y) const;
    Shown ofHaze() const;
    // True if it may have holes.
    bool isSeeThrough(const Surface& surface) const;

private:
    // A place in a texture or a sprite, and its light.
    struct Texel {
        TextureId texture = kNoTexture;
        double depth = 0.0;
        double u = 0.0;  // 0 to 1
        double v = 0.0;
        bool uReversed = false;  // counted from the right
        bool vReversed = false;  // counted from the bottom
        double light = 1.0;
        bool glow = false;
        bool plain = false;                   // shows its texture's average colour
        ObjectSide side = ObjectSide::front;  // of a sprite
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

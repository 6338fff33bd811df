// Colours of surfaces in a row, and of the background: the floor and the sky. Levels of detail and
// light are the exact renderer's, asked for texel by texel.
#pragma once

#include "classic/column_ray.h"
#include "classic/sky_columns.h"
#include "classic/surfaces.h"
#include "render/light/lit_maps.h"
#include "render/light/lit_texels.h"
#include "render/options.h"
#include "render/trace.h"
#include "render/view/detail.h"
#include "render/view/shading.h"
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
    int ripples = 0;   // of that, 0 to 255
};

// What all columns of a picture share.
struct Palette {
    const World& world;
    const RenderOptions& options;
    const ClassicOptions& classic;
    LitMaps& lit;
    SkyColumns& skies;
    EyeWater water;  // around the eye
};

class Colouring {
public:
    // All arguments must outlive it. `map` is an index into World::maps.
    Colouring(const Palette& palette, int map, const View& view, const ColumnRay& ray);

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
        // The point on its face: from the west or the north, and on sides and sprites from above
        double u = 0.0;  // 0 to 1
        double v = 0.0;
        bool downwards = false;  // v is from above
        double pictureV = 0.0;   // the same in the picture, if that is stretched
        Coordinate slideU = {};  // see Surface
        Coordinate slideV = {};
        bool uReversed = false;  // counted from the right
        bool vReversed = false;  // counted from the bottom
        double light = 1.0;
        bool glow = false;
        LitFaceAt lit = {};
        bool plain = false;                   // shows its texture's average colour
        ObjectSide side = ObjectSide::front;  // of a sprite
        int object = -1;
    };

    int mirrorStrength(int strength) const;
    Shown shown(FilledRows::What what, const Texel& at, double y) const;
    LightColour bakedLight(const Texel& at, std::int32_t a, std::int32_t b) const;
    Pixel shaded(Pixel texel, const TracedTexel& light) const;
    Pixel fogged(Pixel colour, std::uint32_t fog) const;
    std::uint32_t mostFog(double y) const;
    Pixel ofSky(double slope, double y) const;

    const Palette& palette_;
    const World& world_;
    const int mapNumber_;
    const Map& map_;
    const View& view_;
    const ColumnRay& ray_;
    Detail detail_;
    Lighting lighting_;
    LitMap* lit_;  // null without baked light
};

}  // namespace slicecast::classic

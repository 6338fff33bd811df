// Smooth magnification: colours that are blended between the four texels round a point. See "Smooth
// textures" in web/docs/picture.md.
#pragma once

#include "render/pixels/column_fill.h"
#include "slicecast/colour.h"
#include "world/texture.h"

#include <cstdint>

namespace slicecast {

// A texture whose level 0 is shown.
struct SmoothTexture {
    const Pixel* texels;  // of level 0, in its order
    int bits;             // its size is 1 << bits
    bool uReversed;       // its texels run against the map
    bool vReversed;
    bool seeThrough;  // it may have holes
};

// The texels along one axis between which a point lies, and the share of the second, of 128.
struct SmoothPlace {
    std::uint32_t first;
    std::uint32_t second;
    std::uint32_t share;
};

inline constexpr int kSmoothBits = 7;  // of a share

// `place` is a fraction of the texture in the map's direction, in 1/2^32.
inline SmoothPlace smoothPlace(std::uint32_t place, int bits, bool reversed) {
    const std::uint32_t size = 1u << bits;
    const std::uint32_t reverse = reversed ? size - 1 : 0;
    const std::uint32_t steps = (place >> (32 - bits - kSmoothBits)) - (1u << (kSmoothBits - 1));
    const std::uint32_t texel = steps >> kSmoothBits;
    return {(texel & (size - 1)) ^ reverse, ((texel + 1) & (size - 1)) ^ reverse,
            steps & ((1u << kSmoothBits) - 1)};
}

// The colour at a point, with the alpha of the nearest texel. Places are as for smoothPlace.
Pixel smoothTexel(const SmoothTexture& texture, std::uint32_t u, std::uint32_t v);

// The colours of `rows` rows of a side at place u; v is as in TexelColumn.
void blendSide(Pixel* out, int rows, const SmoothTexture& texture, std::uint32_t u,
               const TexelColumn& column);

// The colours of the rows [first, last) of a plane, by row. Its textures have not moved.
void blendPlane(Pixel* out, int first, int last, const SmoothTexture& texture,
                const PlaneLine& line, const double* inverseOffsets);

}  // namespace slicecast

// Texels times baked light. Each texel has one light, that of its middle, which lies between the
// four nodes of its square. See "Baked light" in web/docs/picture.md.
#pragma once

#include "render/light/light_samples.h"
#include "render/pixels/lanes.h"
#include "world/texture.h"

#include <cstdint>

namespace slicecast {

// The middle of a texel in 1/65536 of its tile.
inline std::int32_t middleOf(int texel, int size) {
    return (2 * texel + 1) * 32768 / size;
}

// The texel at a place in the tile, in 1/2^32, counted in the map's direction.
inline std::uint32_t texelIn(std::uint32_t place, Coordinate shift, int bits) {
    const std::uint64_t within = place - (static_cast<std::uint32_t>(shift.raw) << 16);
    return static_cast<std::uint32_t>((within & 0xffffffff) >> (32 - bits));
}

// How the texels of a face lie along one of its axes. Those of a level are numbered from 0.
struct TexelAxis {
    enum class Way : std::uint8_t { forward, backward, downward };

    Way way = Way::forward;  // downward: the rows of a side, from its upper edge
    Coordinate shift;        // how far the texture has moved along the axis

    // Where a texel's middle is, in 1/65536 of the tile.
    std::int32_t placeOf(int texel, int size) const;
};

// A level of detail as a face shows it.
struct FaceTexels {
    const TextureLevel& level;
    TexelAxis a;
    TexelAxis b;

    FaceTexels(const TextureLevel& shown, LitFace face, Coordinate shiftA, Coordinate shiftB);
};

// The light at a place along the two axes of a face, in 1/65536 of its tile: 0 to 256.
LightColour lightAt(const FaceNodes& nodes, std::int32_t a, std::int32_t b);

// Lights the texels [first, last) of a column of the level into out[0] and so on. May also write up
// to three places before and behind, within the column.
void lightColumn(Pixel* out, int u, int first, int last, const FaceTexels& texels,
                 const FaceNodes& nodes);

// The light of weighted sums of nodes: 0 to 256.
inline U32x4 lightInSteps(U32x4 sum) {
    return (sum >> 14) + (sum >> 21);
}

// The texels [first, last) times one light of 0 to 256.
void lightAll(Pixel* out, const Pixel* texels, std::size_t first, std::size_t last,
              const LightColour& light);

}  // namespace slicecast

// Texels times baked light. Each texel has one light, that of its middle, which lies between the
// four nodes of its square. See "Baked light" in web/docs/picture.md.
#pragma once

#include "render/column_fill.h"
#include "render/light_samples.h"
#include "world/texture.h"

#include <array>
#include <cstdint>

namespace slicecast {

// Texels of a level of detail that rows of a plane see, all in one square of a tile.
struct LitSquare {
    const Pixel* texels;  // of the level, in its order
    int bits;             // of the level, above 0: a single texel has no square of its own
    const FaceNodes& nodes;
    int squareA;
    int squareB;
};

// Puts the lit texel of each row from `first` on into out[row], while rows lie in the square of the
// first one; returns the first row beyond. May also read and write the three places behind `last`.
int fetchLit(Pixel* out, int first, int last, const LitSquare& square, const PlaneLine& line,
             const double* inverseOffsets);

// The middle of a texel in 1/65536 of its tile.
inline std::int32_t middleOf(int texel, int size) {
    return (2 * texel + 1) * 32768 / size;
}

// A texel in the light of a point: `a` and `b` are its place along the axes of the face, in 1/65536
// of the tile, below 65536.
Pixel litAt(Pixel texel, const FaceNodes& nodes, std::int32_t a, std::int32_t b);

// The same for a side's colours in rows: `a` is their place along the side, the other
// one follows from the column's positions.
void lightSide(Pixel* colours, int rows, const FaceNodes& nodes, std::int32_t a,
               const TexelColumn& column, Coordinate rise);
// The same for a plane's colours in the rows [first, last), by row, all in one tile.
void lightPlane(Pixel* colours, int first, int last, const FaceNodes& nodes, const PlaneLine& line,
                const double* inverseOffsets);

// How the texels of a plane lie in its tiles.
struct TexelLay {
    bool southReversed = false;
    Coordinate east;  // CellBlueprint::textureEast and textureSouth
    Coordinate south;
};

// The texel at a place in the tile, in 1/2^32, counted in the map's direction.
inline std::uint32_t texelIn(std::uint32_t place, Coordinate shift, int bits) {
    const std::uint64_t within = place - (static_cast<std::uint32_t>(shift.raw) << 16);
    return static_cast<std::uint32_t>((within & 0xffffffff) >> (32 - bits));
}

// One lit texel of a plane: `east` and `south` are its place in the tile, in 1/2^32.
Pixel litTexelAt(const Pixel* texels, int bits, const FaceNodes& nodes, std::uint32_t east,
                 std::uint32_t south, const TexelLay& lay);

// A column of a side's texels.
struct SideTexels {
    const TextureLevel& level;
    int u;  // the column in the level
    LitFace face;
    Coordinate rise;   // CellBlueprint::textureRise
    Coordinate slide;  // textureEast or textureSouth
};
// Lights the texels [first, last) of a column into out[first] and so on; may also write up to three
// places before and behind, within the column.
void lightColumn(Pixel* out, int first, int last, const SideTexels& side, const FaceNodes& nodes);

// The texels [first, last) times one light of 0 to 256.
void lightAll(Pixel* out, const Pixel* texels, std::size_t first, std::size_t last,
              const LightColour& light);

}  // namespace slicecast

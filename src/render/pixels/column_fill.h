// The innermost loops: fill rows of one slice from a texture, with light and fog. Per pixel only a
// texel fetch, a multiply and a store.
//
// A slice is drawn into a column of memory, row after row, so all three streams (rows, tables per
// row, a wall's texels) run forwards.
#pragma once

#include "base/bits.h"
#include "slicecast/colour.h"
#include "world/texture.h"

#include <cstdint>

namespace slicecast {

// Texture positions are in 1/2^48 of a tile: a step rounded to that is off by less than 1e-10 of a
// tile after 8192 rows.
inline constexpr int kTexturePositionBits = 48;
inline constexpr std::uint64_t kWholeTexture = std::uint64_t{1} << kTexturePositionBits;  // a tile

// Whether texels replace the pixels, or are blended over them by their alpha:
//     channel = (texel * alpha + there * (255 - alpha) + 127) / 255
enum class Lay { opaque, over };

// One column of texels of a side or an object. Row r of a run that begins at row `first` shows
// texels[(start + (r - first) * step) >> shift], which never leaves the column. On a side positions
// are in 1/2^48 of a tile.
struct TexelColumn {
    const Pixel* texels = nullptr;
    std::uint64_t start = 0;
    std::uint64_t step = 0;
    double depth = 0.0;          // perpendicular, units
    std::uint32_t factor = 256;  // light, 0 to 256
    std::uint32_t fog = 0;       // weight, 0 to 255
    int shift = 0;
    int detail = 0;  // level of detail
};

// Fills `rows` rows.
void fillSide(Pixel* out, int rows, const TexelColumn& column, Pixel haze, Lay lay = Lay::opaque);

// Loops over a plane's rows take four at a time: tables by row have room for so many more.
inline constexpr int kRowsBeyond = 3;

// The points of a horizontal plane that a slice sees, by row: east = eastStart + eastPerInverse *
// inverseOffset, likewise south, in tiles; only the fraction counts.
struct PlaneLine {
    double eastStart = 0.0;  // the eye's fraction of a tile, 0 to 1
    double southStart = 0.0;
    double eastPerInverse = 0.0;
    double southPerInverse = 0.0;
    bool southReversed = false;  // undersides and ceilings

    // A double from 2^20 to below 2^21 has 32 bits after the point, so adding this leaves the
    // fraction in the low half of its bits, rounded to 1/2^32. The sum must stay in that range:
    // positions are below 2^19 tiles (see kMaxFar).
    static constexpr double kFractionMagic = 1572864.0;

    // A position in 1/2^32 of a tile, and the fraction of its tile in the same unit.
    static std::int64_t position(double start, double perInverse, double inverseOffset) {
        return bitCast<std::int64_t>(start + kFractionMagic + perInverse * inverseOffset) -
               bitCast<std::int64_t>(kFractionMagic);
    }
    static std::uint32_t fractionBits(double start, double perInverse, double inverseOffset) {
        return static_cast<std::uint32_t>(position(start, perInverse, inverseOffset));
    }
};

// Values of a plane's rows; the tables are indexed by row. `fogs` is null without fog. Light and
// fog are stored twice in each entry, once in each half.
struct PlaneRows {
    const double* inverseOffsets = nullptr;  // 1 / |horizon - (row + 0.5)|
    const std::uint32_t* factors = nullptr;
    const std::uint32_t* fogs = nullptr;
};

constexpr std::uint32_t inBothHalves(std::uint32_t value) {
    return value | value << 16;
}

// How some rows are shaded: not at all (full light), by light, or by light and fog.
enum class PlaneShade : std::uint8_t { full, dimmed, foggy };

struct PlaneTexels {
    const TextureLevel& level;
    const PlaneLine& line;
    const PlaneRows& rows;
    Pixel haze;
};

// Fills the rows [first, last) of the slice that starts at `column`, all with this shade.
void fillPlane(Pixel* column, int first, int last, const PlaneTexels& texels, PlaneShade shade,
               Lay lay = Lay::opaque);

// The same where the texels of the rows are known: texels[row].
void fillFetched(Pixel* column, int first, int last, const Pixel* texels, const PlaneRows& rows,
                 Pixel haze, PlaneShade shade, Lay lay);

// Blends `rows` pixels, in reverse order, over those at `out`: out = (out * (255 - strength) +
// colour * strength + 127) / 255.
void blendReversed(Pixel* out, int rows, const Pixel* colours, std::uint32_t strength);

// The same with one colour for each row: last[-before[row]].
void blendBefore(Pixel* out, int rows, const Pixel* last, const int* before,
                 std::uint32_t strength);

// One pixel from a texel found by other means; `there` is the old pixel.
Pixel shadedTexel(Pixel texel, std::uint32_t factor, std::uint32_t fog, Pixel haze, Lay lay,
                  Pixel there);

}  // namespace slicecast

#include "render/pixels/column_fill.h"

#include "base/bits.h"
#include "base/pixels.h"
#include "render/pixels/vectors.h"

#include <algorithm>
#include <array>

namespace slicecast {
namespace {

constexpr std::uint32_t kFullLight = 256;  // leaves a colour unchanged

// A pixel's four channels are handled as two pairs of 16-bit halves, red with blue and green with
// alpha; no product or sum below exceeds 16 bits. Machines without vectors do not use the vector
// forms.

// #region shaded
inline std::uint32_t shaded(std::uint32_t texel, std::uint32_t factorTwice) {
    const std::uint32_t factor = factorTwice & 0xffff;
    const std::uint32_t even = (((texel & kRedAndBlue) * factor + 0x00800080) >> 8) & kRedAndBlue;
    const std::uint32_t odd = ((texel >> 8) & kRedAndBlue) * factor + 0x00800080;
    return even | (odd & ~kRedAndBlue) | kOpaque;
}
// #endregion

// Shifts by a variable count. Clang 14 hoists the broadcast of the count out of loops, then fails
// to see that all lanes have the same count, and shifts them one by one for WebAssembly; the asm
// statement prevents the hoisting.
[[maybe_unused]] inline U32x4 shiftedRight(U32x4 value, int count) {
#ifdef __wasm_simd128__
    __asm__ volatile("" : "+r"(count));
#endif
    return value >> count;
}

[[maybe_unused]] inline U32x4 shiftedLeft(U32x4 value, int count) {
#ifdef __wasm_simd128__
    __asm__ volatile("" : "+r"(count));
#endif
    return value << count;
}

// Red and blue, green and alpha.
struct Halves {
    U16x8 even;
    U16x8 odd;
};

[[maybe_unused]] inline Halves shadedHalves(U32x4 texels, U32x4 factorsTwice) {
    const U16x8 half = (U16x8)allLanes(0x00800080);
    return {((U16x8)(texels & kRedAndBlue) * (U16x8)factorsTwice + half) >> 8,
            (((U16x8)texels >> 8) * (U16x8)factorsTwice + half) >> 8};
}

[[maybe_unused]] inline U32x4 shaded(U32x4 texels, U32x4 factorsTwice) {
    const Halves lit = shadedHalves(texels, factorsTwice);
    return (U32x4)lit.even | (U32x4)(lit.odd << 8) | kOpaque;
}

// x / 255 for each half, 0 <= x <= 255 * 255 + 127.
inline std::uint32_t dividedBy255(std::uint32_t halves) {
    return ((halves + 0x00010001 + ((halves >> 8) & kRedAndBlue)) >> 8) & kRedAndBlue;
}

[[maybe_unused]] inline U16x8 dividedBy255(U16x8 x) {
    return (x + (std::uint16_t)1 + (x >> 8)) >> 8;
}

inline std::uint32_t fogged(std::uint32_t lit, std::uint32_t fogTwice, std::uint32_t haze) {
    const std::uint32_t fog = fogTwice & 0xffff;
    const std::uint32_t rest = 255 - fog;
    const std::uint32_t even =
        dividedBy255((lit & kRedAndBlue) * rest + (haze & kRedAndBlue) * fog + 0x007f007f);
    const std::uint32_t odd = dividedBy255(((lit >> 8) & kRedAndBlue) * rest +
                                           ((haze >> 8) & kRedAndBlue) * fog + 0x007f007f);
    return even | odd << 8 | kOpaque;
}

[[maybe_unused]] inline U32x4 fogged(Halves lit, U32x4 fogsTwice, std::uint32_t haze) {
    const U16x8 fog = (U16x8)fogsTwice;
    const U16x8 rest = (U16x8)allLanes(0x00ff00ff) - fog;
    const U16x8 hazeEven = (U16x8)allLanes(haze & kRedAndBlue);
    const U16x8 hazeOdd = (U16x8)allLanes((haze >> 8) & kRedAndBlue);
    const U16x8 half = (U16x8)allLanes(0x007f007f);
    const U16x8 even = dividedBy255(lit.even * rest + (hazeEven * fog + half));
    const U16x8 odd = dividedBy255(lit.odd * rest + (hazeOdd * fog + half));
    return (U32x4)even | (U32x4)(odd << 8) | kOpaque;
}

// Texels as they are, for those who shade them later.
struct AsItIs {
    std::uint32_t one(std::uint32_t texel, int) const { return texel; }
    U32x4 four(U32x4 texels, int) const { return texels; }
};

// Full light and no fog: colours stay unchanged.
struct NoShade {
    std::uint32_t one(std::uint32_t texel, int) const { return texel | kOpaque; }
    U32x4 four(U32x4 texels, int) const { return texels | kOpaque; }
};

// The same light and fog for all rows, because a wall has one depth.
template <bool foggy>
struct EvenShade {
    std::uint32_t factor;
    std::uint32_t fog;
    Pixel haze;

    std::uint32_t one(std::uint32_t texel, int) const {
        const std::uint32_t lit = shaded(texel, factor);
        return foggy ? fogged(lit, fog, haze) : lit;
    }
    U32x4 four(U32x4 texels, int) const {
        if constexpr (foggy)
            return fogged(shadedHalves(texels, allLanes(factor)), allLanes(fog), haze);
        return shaded(texels, allLanes(factor));
    }
};

// Light and fog from tables by row.
template <bool foggy>
struct RowShade {
    const std::uint32_t* factors;
    const std::uint32_t* fogs;
    Pixel haze;

    std::uint32_t one(std::uint32_t texel, int row) const {
        const std::uint32_t lit = shaded(texel, factors[row]);
        return foggy ? fogged(lit, fogs[row], haze) : lit;
    }
    U32x4 four(U32x4 texels, int row) const {
        if constexpr (foggy)
            return fogged(shadedHalves(texels, loadVector<U32x4>(factors + row)),
                          loadVector<U32x4>(fogs + row), haze);
        return shaded(texels, loadVector<U32x4>(factors + row));
    }
};

// #region lay-over
inline std::uint32_t laidOver(std::uint32_t there, std::uint32_t colour, std::uint32_t alpha) {
    const std::uint32_t rest = 255 - alpha;
    const std::uint32_t even =
        dividedBy255((colour & kRedAndBlue) * alpha + (there & kRedAndBlue) * rest + 0x007f007f);
    const std::uint32_t odd = dividedBy255(((colour >> 8) & kRedAndBlue) * alpha +
                                           ((there >> 8) & kRedAndBlue) * rest + 0x007f007f);
    return even | odd << 8 | kOpaque;
}
// #endregion

// The result for a row: `there` is its old pixel, `colour` the shaded texel.
struct Opaque {
    static std::uint32_t one(const Pixel*, std::uint32_t, std::uint32_t colour) { return colour; }
    static U32x4 four(const Pixel*, U32x4, U32x4 colours) { return colours; }
};
struct Over {
    static std::uint32_t one(const Pixel* there, std::uint32_t texel, std::uint32_t colour) {
        return laidOver(*there, colour, texel >> 24);
    }
    static U32x4 four(const Pixel* there, U32x4 texels, U32x4 colours) {
        const U32x4 old = loadVector<U32x4>(there);
        const U32x4 alphas = texels >> 24;
        const U16x8 alpha = (U16x8)(alphas | alphas << 16);
        const U16x8 rest = (U16x8)allLanes(0x00ff00ff) - alpha;
        const U16x8 half = (U16x8)allLanes(0x007f007f);
        const U16x8 even = dividedBy255((U16x8)(colours & kRedAndBlue) * alpha +
                                        ((U16x8)(old & kRedAndBlue) * rest + half));
        const U16x8 odd =
            dividedBy255(((U16x8)colours >> 8) * alpha + (((U16x8)old >> 8) * rest + half));
        return (U32x4)even | (U32x4)(odd << 8) | kOpaque;
    }
};

template <typename Put, typename ShadeRows>
void fillSideRows(Pixel* out, int rows, const TexelColumn& column, ShadeRows shade) {
    const Pixel* const texels = column.texels;
    const int shift = column.shift;
    const std::uint64_t step = column.step;
    std::uint64_t position = column.start;
    int row = 0;
    if constexpr (kHasVectors) {
        for (; row + 4 <= rows; row += 4) {
            const std::uint64_t second = position + step;
            const std::uint64_t third = second + step;
            const std::uint64_t fourth = third + step;
            const U32x4 four = {texels[position >> shift], texels[second >> shift],
                                texels[third >> shift], texels[fourth >> shift]};
            storeVector(out + row, Put::four(out + row, four, shade.four(four, row)));
            position = fourth + step;
        }
    }
    for (; row < rows; ++row) {
        const Pixel texel = texels[position >> shift];
        out[row] = Put::one(out + row, texel, shade.one(texel, row));
        position += step;
    }
}

inline std::uint32_t lowHalf(double value) {
    return static_cast<std::uint32_t>(bitCast<std::uint64_t>(value));
}

template <typename ShadeRows>
void fillPlaneRows(Pixel* column, int first, int last, const PlaneTexels& from, ShadeRows shade) {
    const PlaneLine& line = from.line;
    const double* const inverseOffsets = from.rows.inverseOffsets;
    const Pixel* const texels = from.level.texels.data();
    const int bits = from.level.bits;
    const int shift = 32 - bits;
    const std::uint32_t reverse = line.southReversed ? (1u << bits) - 1 : 0;
    const double eastStart = line.eastStart + PlaneLine::kFractionMagic;
    const double southStart = line.southStart + PlaneLine::kFractionMagic;
    int row = first;
    if constexpr (kHasVectors) {
        const F64x2 east0 = {eastStart, eastStart};
        const F64x2 south0 = {southStart, southStart};
        const F64x2 eastPer = {line.eastPerInverse, line.eastPerInverse};
        const F64x2 southPer = {line.southPerInverse, line.southPerInverse};
        for (; row + 4 <= last; row += 4) {
            const F64x2 inverseA = loadVector<F64x2>(inverseOffsets + row);
            const F64x2 inverseB = loadVector<F64x2>(inverseOffsets + row + 2);
            const U32x4 u = shiftedRight(
                lowHalves(east0 + eastPer * inverseA, east0 + eastPer * inverseB), shift);
            const U32x4 v = shiftedRight(
                lowHalves(south0 + southPer * inverseA, south0 + southPer * inverseB), shift);
            const U32x4 index = shiftedLeft(u, bits) | (v ^ reverse);
            const U32x4 four = {texels[index[0]], texels[index[1]], texels[index[2]],
                                texels[index[3]]};
            storeVector(column + row, shade.four(four, row));
        }
    }
    // #region plane-texel
    for (; row < last; ++row) {
        const std::uint32_t u =
            lowHalf(eastStart + line.eastPerInverse * inverseOffsets[row]) >> shift;
        const std::uint32_t v =
            lowHalf(southStart + line.southPerInverse * inverseOffsets[row]) >> shift;
        column[row] = shade.one(texels[(u << bits) | (v ^ reverse)], row);
    }
    // #endregion
}

template <typename Put, typename ShadeRows>
void fillFetchedRows(Pixel* column, int first, int last, const Pixel* texels, ShadeRows shade) {
    int row = first;
    if constexpr (kHasVectors) {
        for (; row + 4 <= last; row += 4) {
            const U32x4 four = loadVector<U32x4>(texels + row);
            storeVector(column + row, Put::four(column + row, four, shade.four(four, row)));
        }
    }
    for (; row < last; ++row)
        column[row] = Put::one(column + row, texels[row], shade.one(texels[row], row));
}

template <typename Put>
void fillFetchedAs(Pixel* column, int first, int last, const Pixel* texels, const PlaneRows& rows,
                   Pixel haze, PlaneShade kind) {
    switch (kind) {
        case PlaneShade::full:
            return fillFetchedRows<Put>(column, first, last, texels, NoShade{});
        case PlaneShade::dimmed:
            return fillFetchedRows<Put>(column, first, last, texels,
                                        RowShade<false>{rows.factors, nullptr, haze});
        case PlaneShade::foggy:
            return fillFetchedRows<Put>(column, first, last, texels,
                                        RowShade<true>{rows.factors, rows.fogs, haze});
    }
}

template <typename Put>
void fillSideAs(Pixel* out, int rows, const TexelColumn& column, Pixel haze) {
    const std::uint32_t factor = inBothHalves(column.factor);
    if (column.fog != 0) {
        fillSideRows<Put>(out, rows, column,
                          EvenShade<true>{factor, inBothHalves(column.fog), haze});
    } else if (column.factor == kFullLight) {
        fillSideRows<Put>(out, rows, column, NoShade{});
    } else {
        fillSideRows<Put>(out, rows, column, EvenShade<false>{factor, 0, haze});
    }
}

template <typename ShadeRows>
void fillPlaneAs(Pixel* column, int first, int last, const PlaneTexels& texels, ShadeRows shade) {
    // A single texel needs no position (and a shift by all 32 bits is undefined)
    if (texels.level.bits != 0) return fillPlaneRows(column, first, last, texels, shade);
    for (int row = first; row < last; ++row) column[row] = shade.one(texels.level.texels[0], row);
}

// The same, laid over what is there. Rare where light is baked: not worth loops of its own.
void layPlane(Pixel* column, int first, int last, const PlaneTexels& texels, PlaneShade shade) {
    constexpr int kBatch = 64;
    std::array<Pixel, kBatch> fetched;
    const PlaneRows& all = texels.rows;
    for (int from = first; from < last; from += kBatch) {
        const int count = std::min(kBatch, last - from);
        const PlaneRows rows = {all.inverseOffsets + from, all.factors + from,
                                all.fogs != nullptr ? all.fogs + from : nullptr};
        fillPlaneAs(fetched.data(), 0, count, {texels.level, texels.line, rows, texels.haze},
                    AsItIs{});
        fillFetchedAs<Over>(column + from, 0, count, fetched.data(), rows, texels.haze, shade);
    }
}

}  // namespace

void fillSide(Pixel* out, int rows, const TexelColumn& column, Pixel haze, Lay lay) {
    (lay == Lay::opaque ? fillSideAs<Opaque> : fillSideAs<Over>)(out, rows, column, haze);
}

void fillPlane(Pixel* column, int first, int last, const PlaneTexels& texels, PlaneShade shade,
               Lay lay) {
    if (lay == Lay::over) return layPlane(column, first, last, texels, shade);
    const PlaneRows& rows = texels.rows;
    switch (shade) {
        case PlaneShade::full:
            return fillPlaneAs(column, first, last, texels, NoShade{});
        case PlaneShade::dimmed:
            return fillPlaneAs(column, first, last, texels,
                               RowShade<false>{rows.factors, nullptr, texels.haze});
        case PlaneShade::foggy:
            return fillPlaneAs(column, first, last, texels,
                               RowShade<true>{rows.factors, rows.fogs, texels.haze});
    }
}

void fillFetched(Pixel* column, int first, int last, const Pixel* texels, const PlaneRows& rows,
                 Pixel haze, PlaneShade shade, Lay lay) {
    (lay == Lay::opaque ? fillFetchedAs<Opaque> : fillFetchedAs<Over>)(column, first, last, texels,
                                                                       rows, haze, shade);
}

void blendReversed(Pixel* out, int rows, const Pixel* colours, std::uint32_t strength) {
    int row = 0;
    if constexpr (kHasVectors) {
        const U32x4 alphas = allLanes(strength << 24);
        for (; row + 4 <= rows; row += 4) {
            const Pixel* const from = colours + rows - 4 - row;
            const U32x4 four = {from[3], from[2], from[1], from[0]};
            storeVector(out + row, Over::four(out + row, alphas, four));
        }
    }
    for (; row < rows; ++row) out[row] = laidOver(out[row], colours[rows - 1 - row], strength);
}

void blendBefore(Pixel* out, int rows, const Pixel* last, const int* before,
                 std::uint32_t strength) {
    int row = 0;
    if constexpr (kHasVectors) {
        const U32x4 alphas = allLanes(strength << 24);
        for (; row + 4 <= rows; row += 4) {
            const U32x4 four = {last[-before[row]], last[-before[row + 1]], last[-before[row + 2]],
                                last[-before[row + 3]]};
            storeVector(out + row, Over::four(out + row, alphas, four));
        }
    }
    for (; row < rows; ++row) out[row] = laidOver(out[row], last[-before[row]], strength);
}

Pixel shadedTexel(Pixel texel, std::uint32_t factor, std::uint32_t fog, Pixel haze, Lay lay,
                  Pixel there) {
    const std::uint32_t lit = shaded(texel, inBothHalves(factor));
    const std::uint32_t colour = fog == 0 ? lit : fogged(lit, inBothHalves(fog), haze);
    return lay == Lay::opaque ? colour : laidOver(there, colour, texel >> 24);
}

}  // namespace slicecast

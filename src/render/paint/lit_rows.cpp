// Part of the painter: the lit texels of a plane's rows. Each is lit as it is read; four rows at a
// time, wherever they lie.
#include "base/bits.h"
#include "render/paint/lit_planes.h"
#include "render/paint/slice_paint.h"
#include "render/pixels/lanes.h"

#include <algorithm>
#include <array>

namespace slicecast {
namespace {

// The middle of a texel is as far behind the lower node of its square as these bits of its place,
// of 256 in a tile, and half a texel: of 128.
struct Middles {
    std::uint32_t bits;
    std::uint32_t half;
};
constexpr std::array<Middles, 11> kMiddles = [] {
    std::array<Middles, 11> all{};
    for (std::uint32_t bits = 0; bits < all.size(); ++bits)
        all[bits] = {bits < 8 ? (256 - (256u >> bits)) & 127 : 127, 128u >> bits & 127};
    return all;
}();

// The whole part of a position by PlaneLine: the tile, relative to the eye's, above this.
constexpr auto kTileMagic =
    static_cast<std::uint32_t>(bitCast<std::uint64_t>(PlaneLine::kFractionMagic) >> 32);

// Where rows find their texels and lines of light: some rows are found, then lit, so that many
// reads of memory wait together.
constexpr int kAtOnce = 64;
struct LitPlaces {
    alignas(16) std::array<std::uint32_t, kAtOnce> texels;
    alignas(16) std::array<std::uint32_t, kAtOnce> lines;
    alignas(16) std::array<std::uint32_t, kAtOnce> weights;  // of a line's ends, of 128, in halves
};

// Lights `rows` texels, and up to three more.
void lightRows(Pixel* lit, const LitPlaces& places, int rows, const Pixel* texels,
               const LightLine* lines) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows); i += 4) {
        const U32x4 weights = loadVector<U32x4>(places.weights.data() + i);
        const auto light = [&](int n) {
            return dotPairs(loadVector<U32x4>(lines + places.lines[i + indexOf(n)]),
                            allLanes(weights[n])) >>
                   14;
        };
        const auto lightA = (U16x8)narrowed(light(0), light(1));
        const auto lightB = (U16x8)narrowed(light(2), light(3));
        const std::uint32_t* const at = places.texels.data() + i;
        const auto shown = (U8x16)U32x4{texels[at[0]], texels[at[1]], texels[at[2]], texels[at[3]]};
        storeVector(lit + i, upperBytes(lowBytes(shown) * (lightA + (lightA >> 7)) + 128,
                                        highBytes(shown) * (lightB + (lightB >> 7)) + 128));
    }
}

std::uint32_t highHalf(double value) {
    return static_cast<std::uint32_t>(bitCast<std::uint64_t>(value) >> 32);
}

}  // namespace

// The lines of light over a plane's tile, from kTileMagic on.
std::uint32_t SlicePainter::linesOf(const PlaneRun& run, int levelBits, std::uint32_t tileX,
                                    std::uint32_t tileY) {
    const auto x = static_cast<int>(tileX - kTileMagic);
    const auto y = static_cast<int>(tileY - kTileMagic);
    return run.vista->lit->linesOf(planeFace(run, x, y), levelBits, ownFace(run));
}

// The lit texels of rows, by row; valid until the next ones are made. May also read and write the
// three places behind `last`.
const Pixel* SlicePainter::fetchLitRows(const PlaneRun& run, int first, int last,
                                        const TextureLevel& level, const PlaneLine& line,
                                        const double* inverseOffsets) const {
    Pixel* const lit = frame_.lit.scratch(static_cast<std::size_t>(last + kRowsBeyond));
    const LitMap& map = *run.vista->lit;
    const double eastStart = line.eastStart + PlaneLine::kFractionMagic;
    const double southStart = line.southStart + PlaneLine::kFractionMagic;
    // The tile that rows lie in, and its lines
    const std::uint32_t firstX = highHalf(eastStart + line.eastPerInverse * inverseOffsets[first]);
    const std::uint32_t firstY =
        highHalf(southStart + line.southPerInverse * inverseOffsets[first]);
    U32x4 tileX = allLanes(firstX);
    U32x4 tileY = allLanes(firstY);
    U32x4 tileLines = allLanes(linesOf(run, level.bits, firstX, firstY));
    // A single texel is drawn as four equal ones: a shift by all 32 bits is undefined
    int bits = level.bits;
    const Pixel* texels = level.texels.data();
    std::array<Pixel, 4> four;
    if (bits == 0) {
        four.fill(texels[0]);
        texels = four.data();
        bits = 1;
    }
    const int shift = 32 - bits;
    const std::uint32_t reverse = line.southReversed ? (1u << bits) - 1 : 0;
    const Middles middles = kMiddles[static_cast<std::size_t>(bits)];
    const F64x2 east0 = {eastStart, eastStart};
    const F64x2 south0 = {southStart, southStart};
    const F64x2 eastPer = {line.eastPerInverse, line.eastPerInverse};
    const F64x2 southPer = {line.southPerInverse, line.southPerInverse};
    LitPlaces places;
    int from = first;
    for (int row = first; row < last; row += 4) {
        const F64x2 inverseA = loadVector<F64x2>(inverseOffsets + row);
        const F64x2 inverseB = loadVector<F64x2>(inverseOffsets + row + 2);
        const F64x2 eastA = east0 + eastPer * inverseA;
        const F64x2 eastB = east0 + eastPer * inverseB;
        const F64x2 southA = south0 + southPer * inverseA;
        const F64x2 southB = south0 + southPer * inverseB;
        const U32x4 xs = highHalves(eastA, eastB);
        const U32x4 ys = highHalves(southA, southB);
        U32x4 lines = tileLines;
        const unsigned same = bitsOf((U32x4)(xs == tileX) & (U32x4)(ys == tileY));
        if (same != 15) {
            std::array<std::uint32_t, 4> x;
            std::array<std::uint32_t, 4> y;
            storeVector(x.data(), xs);
            storeVector(y.data(), ys);
            unsigned others = ~same & (last - row < 4 ? (1u << (last - row)) - 1 : 15);
            while (others != 0) {
                const auto i = static_cast<std::size_t>(__builtin_ctz(others));
                tileX = allLanes(x[i]);
                tileY = allLanes(y[i]);
                tileLines = allLanes(linesOf(run, level.bits, x[i], y[i]));
                const U32x4 there = (U32x4)(loadVector<U32x4>(x.data()) == tileX) &
                                    (U32x4)(loadVector<U32x4>(y.data()) == tileY);
                lines = (tileLines & there) | (lines & ~there);
                others &= ~bitsOf(there);
            }
        }
        const U32x4 south = lowHalves(southA, southB);
        const U32x4 u = lowHalves(eastA, eastB) >> shift;
        const U32x4 high = south >> 24 & middles.bits;
        const auto at = static_cast<std::size_t>(row - from);
        storeVector(places.texels.data() + at, (u << bits | south >> shift) ^ reverse);
        storeVector(places.lines.data() + at, lines + u + (south >> 31 << bits));
        storeVector(places.weights.data() + at,
                    (high << 16) - high + (128 + middles.half * 0xffff));
        if (row + 4 - from >= kAtOnce || row + 4 >= last) {
            lightRows(lit + from, places, row + 4 - from, texels, map.allLines());
            from = row + 4;
        }
    }
    return lit;
}

}  // namespace slicecast

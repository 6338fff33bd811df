// Sixteen whole numbers at once, one for each column of a strip: rows, tiles, textures. Each is in
// -32768 to 32767. A lane of a mask has all bits set, or none.
#pragma once

#include "render/pixels/vectors.h"

#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace slicecast {

inline constexpr int kLanes = 16;

using I16x8 = std::int16_t __attribute__((vector_size(16)));

struct Lanes {
    I16x8 low;   // of columns 0 to 7
    I16x8 high;  // of columns 8 to 15
};

inline std::size_t indexOf(int lane) {
    return static_cast<std::size_t>(lane);
}
inline std::int16_t inLane(int value) {
    return static_cast<std::int16_t>(value);
}

inline Lanes inAllLanes(int value) {
    const std::int16_t v = inLane(value);
    const I16x8 eight = {v, v, v, v, v, v, v, v};
    return {eight, eight};
}

inline Lanes operator<(Lanes a, Lanes b) {
    return {(I16x8)(a.low < b.low), (I16x8)(a.high < b.high)};
}
inline Lanes operator==(Lanes a, Lanes b) {
    return {(I16x8)(a.low == b.low), (I16x8)(a.high == b.high)};
}
inline Lanes operator&(Lanes a, Lanes b) {
    return {a.low & b.low, a.high & b.high};
}
inline Lanes operator|(Lanes a, Lanes b) {
    return {a.low | b.low, a.high | b.high};
}
inline Lanes operator~(Lanes a) {
    return {~a.low, ~a.high};
}
inline Lanes operator+(Lanes a, Lanes b) {
    return {a.low + b.low, a.high + b.high};
}
// Takes lanes of `a` where `mask` is set, of `b` elsewhere.
inline Lanes chosen(Lanes mask, Lanes a, Lanes b) {
    return {(mask.low & a.low) | (~mask.low & b.low), (mask.high & a.high) | (~mask.high & b.high)};
}

#if defined(__SSE2__)
inline Lanes lesser(Lanes a, Lanes b) {
    return {(I16x8)_mm_min_epi16((__m128i)a.low, (__m128i)b.low),
            (I16x8)_mm_min_epi16((__m128i)a.high, (__m128i)b.high)};
}
inline Lanes greater(Lanes a, Lanes b) {
    return {(I16x8)_mm_max_epi16((__m128i)a.low, (__m128i)b.low),
            (I16x8)_mm_max_epi16((__m128i)a.high, (__m128i)b.high)};
}
// One bit for each set lane of a mask.
inline unsigned bitsOf(Lanes mask) {
    return static_cast<unsigned>(
        _mm_movemask_epi8(_mm_packs_epi16((__m128i)mask.low, (__m128i)mask.high)));
}
// Whether any lane of a mask of four 32-bit numbers is set.
inline bool anyOf(U32x4 mask) {
    return _mm_movemask_epi8((__m128i)mask) != 0;
}
// One bit for each set lane of such a mask.
inline unsigned bitsOf(U32x4 mask) {
    return static_cast<unsigned>(_mm_movemask_ps((__m128)mask));
}
inline F64x2 heldBetween(F64x2 value, double low, double high) {
    return (F64x2)_mm_min_pd(_mm_max_pd((__m128d)value, _mm_set1_pd(low)), _mm_set1_pd(high));
}
// Numbers must be below 32768.
inline I16x8 narrowed(U32x4 a, U32x4 b) {
    return (I16x8)_mm_packs_epi32((__m128i)a, (__m128i)b);
}
// The low 16 bits of eight numbers.
inline I16x8 lowHalves(U32x4 a, U32x4 b) {
    return (I16x8)_mm_packs_epi32((__m128i)((I32x4)(a << 16) >> 16),
                                  (__m128i)((I32x4)(b << 16) >> 16));
}
// The first four of eight numbers, and the others.
inline I32x4 firstFour(I16x8 v) {
    return (I32x4)_mm_unpacklo_epi16((__m128i)v, (__m128i)v) >> 16;
}
inline I32x4 lastFour(I16x8 v) {
    return (I32x4)_mm_unpackhi_epi16((__m128i)v, (__m128i)v) >> 16;
}
// Four numbers rounded towards 0.
inline I32x4 wholeOf(F64x2 a, F64x2 b) {
    return (I32x4)_mm_unpacklo_epi64(_mm_cvttpd_epi32((__m128d)a), _mm_cvttpd_epi32((__m128d)b));
}
inline F64x2 firstTwo(I32x4 v) {
    return (F64x2)_mm_cvtepi32_pd((__m128i)v);
}
inline F64x2 lastTwo(I32x4 v) {
    return (F64x2)_mm_cvtepi32_pd(_mm_unpackhi_epi64((__m128i)v, (__m128i)v));
}
// Of four pairs of 16-bit numbers: the sum of their two products.
inline U32x4 dotPairs(U32x4 a, U32x4 b) {
    return (U32x4)_mm_madd_epi16((__m128i)a, (__m128i)b);
}
// The first, or the last, eight bytes as numbers of 16 bits.
inline U16x8 lowBytes(U8x16 v) {
    return (U16x8)_mm_unpacklo_epi8((__m128i)v, _mm_setzero_si128());
}
inline U16x8 highBytes(U8x16 v) {
    return (U16x8)_mm_unpackhi_epi8((__m128i)v, _mm_setzero_si128());
}
// The bytes of two numbers in turn, as numbers of 16 bits: the first of both, the second of both...
inline U16x8 bytesInTurn(std::uint32_t a, std::uint32_t b) {
    return lowBytes((U8x16)_mm_unpacklo_epi8(_mm_cvtsi32_si128(static_cast<int>(a)),
                                             _mm_cvtsi32_si128(static_cast<int>(b))));
}
// The upper bytes of sixteen numbers.
inline U8x16 upperBytes(U16x8 a, U16x8 b) {
    return (U8x16)_mm_packus_epi16((__m128i)(a >> 8), (__m128i)(b >> 8));
}
#elif defined(__wasm_simd128__)
inline I16x8 lowHalves(U32x4 a, U32x4 b) {
    return (I16x8)wasm_i16x8_shuffle((v128_t)a, (v128_t)b, 0, 2, 4, 6, 8, 10, 12, 14);
}
inline I32x4 firstFour(I16x8 v) {
    return (I32x4)wasm_i32x4_extend_low_i16x8((v128_t)v);
}
inline I32x4 lastFour(I16x8 v) {
    return (I32x4)wasm_i32x4_extend_high_i16x8((v128_t)v);
}
inline I32x4 wholeOf(F64x2 a, F64x2 b) {
    return (I32x4)wasm_i32x4_shuffle(wasm_i32x4_trunc_sat_f64x2_zero((v128_t)a),
                                     wasm_i32x4_trunc_sat_f64x2_zero((v128_t)b), 0, 1, 4, 5);
}
inline F64x2 firstTwo(I32x4 v) {
    return (F64x2)wasm_f64x2_convert_low_i32x4((v128_t)v);
}
inline F64x2 lastTwo(I32x4 v) {
    return (F64x2)wasm_f64x2_convert_low_i32x4(
        wasm_i32x4_shuffle((v128_t)v, (v128_t)v, 2, 3, 2, 3));
}
inline U32x4 dotPairs(U32x4 a, U32x4 b) {
    return (U32x4)wasm_i32x4_dot_i16x8((v128_t)a, (v128_t)b);
}
inline U16x8 lowBytes(U8x16 v) {
    return (U16x8)wasm_u16x8_extend_low_u8x16((v128_t)v);
}
inline U16x8 highBytes(U8x16 v) {
    return (U16x8)wasm_u16x8_extend_high_u8x16((v128_t)v);
}
inline U16x8 bytesInTurn(std::uint32_t a, std::uint32_t b) {
    const v128_t both = wasm_i32x4_make(static_cast<int>(a), static_cast<int>(b), 0, 0);
    return lowBytes(
        (U8x16)wasm_i8x16_shuffle(both, both, 0, 4, 1, 5, 2, 6, 3, 7, 0, 0, 0, 0, 0, 0, 0, 0));
}
inline U8x16 upperBytes(U16x8 a, U16x8 b) {
    return (U8x16)wasm_u8x16_narrow_i16x8((v128_t)(a >> 8), (v128_t)(b >> 8));
}
inline Lanes lesser(Lanes a, Lanes b) {
    return {(I16x8)wasm_i16x8_min((v128_t)a.low, (v128_t)b.low),
            (I16x8)wasm_i16x8_min((v128_t)a.high, (v128_t)b.high)};
}
inline Lanes greater(Lanes a, Lanes b) {
    return {(I16x8)wasm_i16x8_max((v128_t)a.low, (v128_t)b.low),
            (I16x8)wasm_i16x8_max((v128_t)a.high, (v128_t)b.high)};
}
inline unsigned bitsOf(Lanes mask) {
    return wasm_i8x16_bitmask(wasm_i8x16_narrow_i16x8((v128_t)mask.low, (v128_t)mask.high));
}
inline bool anyOf(U32x4 mask) {
    return wasm_v128_any_true((v128_t)mask);
}
inline unsigned bitsOf(U32x4 mask) {
    return wasm_i32x4_bitmask((v128_t)mask);
}
inline F64x2 heldBetween(F64x2 value, double low, double high) {
    return (F64x2)wasm_f64x2_pmin(wasm_f64x2_pmax((v128_t)value, wasm_f64x2_splat(low)),
                                  wasm_f64x2_splat(high));
}
inline I16x8 narrowed(U32x4 a, U32x4 b) {
    return (I16x8)wasm_i16x8_narrow_i32x4((v128_t)a, (v128_t)b);
}
#else
inline I16x8 lowHalves(U32x4 a, U32x4 b) {
    I16x8 all;
    for (int i = 0; i < 4; ++i) {
        all[i] = static_cast<std::int16_t>(a[i] & 0xffff);
        all[i + 4] = static_cast<std::int16_t>(b[i] & 0xffff);
    }
    return all;
}
inline I32x4 firstFour(I16x8 v) {
    return I32x4{v[0], v[1], v[2], v[3]};
}
inline I32x4 lastFour(I16x8 v) {
    return I32x4{v[4], v[5], v[6], v[7]};
}
inline I32x4 wholeOf(F64x2 a, F64x2 b) {
    return I32x4{static_cast<int>(a[0]), static_cast<int>(a[1]), static_cast<int>(b[0]),
                 static_cast<int>(b[1])};
}
inline F64x2 firstTwo(I32x4 v) {
    return F64x2{static_cast<double>(v[0]), static_cast<double>(v[1])};
}
inline F64x2 lastTwo(I32x4 v) {
    return F64x2{static_cast<double>(v[2]), static_cast<double>(v[3])};
}
inline U32x4 dotPairs(U32x4 a, U32x4 b) {
    return (a & 0xffff) * (b & 0xffff) + (a >> 16) * (b >> 16);
}
inline U16x8 lowBytes(U8x16 v) {
    return U16x8{v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]};
}
inline U16x8 highBytes(U8x16 v) {
    return U16x8{v[8], v[9], v[10], v[11], v[12], v[13], v[14], v[15]};
}
inline U16x8 bytesInTurn(std::uint32_t a, std::uint32_t b) {
    U16x8 all;
    for (int i = 0; i < 4; ++i) {
        all[2 * i] = static_cast<std::uint16_t>(a >> (8 * i) & 0xff);
        all[2 * i + 1] = static_cast<std::uint16_t>(b >> (8 * i) & 0xff);
    }
    return all;
}
inline U8x16 upperBytes(U16x8 a, U16x8 b) {
    U8x16 all;
    for (int i = 0; i < 8; ++i) {
        all[i] = static_cast<std::uint8_t>(a[i] >> 8);
        all[i + 8] = static_cast<std::uint8_t>(b[i] >> 8);
    }
    return all;
}
inline Lanes lesser(Lanes a, Lanes b) {
    return chosen(a < b, a, b);
}
inline Lanes greater(Lanes a, Lanes b) {
    return chosen(a < b, b, a);
}
inline unsigned bitsOf(Lanes mask) {
    unsigned bits = 0;
    for (int lane = 0; lane < 8; ++lane) {
        bits |= (mask.low[lane] ? 1u : 0u) << lane;
        bits |= (mask.high[lane] ? 256u : 0u) << lane;
    }
    return bits;
}
inline bool anyOf(U32x4 mask) {
    return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}
inline unsigned bitsOf(U32x4 mask) {
    return (mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8);
}
inline F64x2 heldBetween(F64x2 value, double low, double high) {
    for (int i = 0; i < 2; ++i) {
        value[i] = value[i] > low ? value[i] : low;
        value[i] = value[i] < high ? value[i] : high;
    }
    return value;
}
inline I16x8 narrowed(U32x4 a, U32x4 b) {
    I16x8 all;
    for (int i = 0; i < 4; ++i) {
        all[i] = static_cast<std::int16_t>(a[i]);
        all[i + 4] = static_cast<std::int16_t>(b[i]);
    }
    return all;
}
#endif

// The mask with these bits; inverse of bitsOf.
inline Lanes maskOf(unsigned bits) {
    const I16x8 each = {1, 2, 4, 8, 16, 32, 64, 128};
    const auto low = static_cast<std::int16_t>(bits & 0xff);
    const auto high = static_cast<std::int16_t>(bits >> 8);
    return {(I16x8)((each & I16x8{low, low, low, low, low, low, low, low}) == each),
            (I16x8)((each & I16x8{high, high, high, high, high, high, high, high}) == each)};
}

// The lanes as numbers in memory, for access one by one.
struct LaneValues {
    alignas(16) std::int16_t at[kLanes];

    LaneValues() = default;
    explicit LaneValues(Lanes lanes) {
        storeVector(at, lanes.low);
        storeVector(at + 8, lanes.high);
    }
    Lanes lanes() const { return {loadVector<I16x8>(at), loadVector<I16x8>(at + 8)}; }
};

inline int leastOf(Lanes lanes) {
    const LaneValues values(lesser(lanes, {lanes.high, lanes.low}));
    int least = values.at[0];
    for (int lane = 1; lane < 8; ++lane) least = values.at[lane] < least ? values.at[lane] : least;
    return least;
}
inline int greatestOf(Lanes lanes) {
    const LaneValues values(greater(lanes, {lanes.high, lanes.low}));
    int greatest = values.at[0];
    for (int lane = 1; lane < 8; ++lane)
        greatest = values.at[lane] > greatest ? values.at[lane] : greatest;
    return greatest;
}

// Calls fn(lane) for each bit, from the lowest.
template <typename Fn>
inline void eachLane(unsigned bits, Fn&& fn) {
    for (; bits != 0; bits &= bits - 1) fn(__builtin_ctz(bits));
}

}  // namespace slicecast

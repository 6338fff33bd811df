// Four pixels at a time, written once for all machines: the compilers' vector types become SSE on
// x86, NEON on ARM and SIMD128 in WebAssembly. Without vectors (kHasVectors is false) only the
// scalar forms are used. Both do the same arithmetic, so they give the same bytes.
#pragma once

#include <cstdint>
#include <cstring>

namespace slicecast {

#if defined(__SSE2__) || defined(__ARM_NEON) || defined(__wasm_simd128__)
inline constexpr bool kHasVectors = true;
#else
inline constexpr bool kHasVectors = false;
#endif

using U8x16 = std::uint8_t __attribute__((vector_size(16)));
using U16x8 = std::uint16_t __attribute__((vector_size(16)));
using I32x4 = std::int32_t __attribute__((vector_size(16)));
using U32x4 = std::uint32_t __attribute__((vector_size(16)));
using F64x2 = double __attribute__((vector_size(16)));
using U64x2 = std::uint64_t __attribute__((vector_size(16)));
using I64x2 = std::int64_t __attribute__((vector_size(16)));

template <typename Vector>
inline Vector loadVector(const void* from) {
    Vector v;
    std::memcpy(&v, from, sizeof v);
    return v;
}

template <typename Vector>
inline void storeVector(void* to, Vector v) {
    std::memcpy(to, &v, sizeof v);
}

inline U32x4 allLanes(std::uint32_t value) {
    return U32x4{value, value, value, value};
}

// The low 16 bits of a number.
inline U16x8 inEight(int value) {
    const auto v = static_cast<std::uint16_t>(value & 0xffff);
    return U16x8{v, v, v, v, v, v, v, v};
}
// `low` must not be above `high`.
inline I32x4 heldBetween(I32x4 value, int low, int high) {
    const I32x4 over = value > high;
    value = (over & high) | (~over & value);
    const I32x4 under = value < low;
    return (under & low) | (~under & value);
}

// The low 32 bits of four doubles' bit patterns.
inline U32x4 lowHalves(F64x2 a, F64x2 b) {
    U32x4 lowA;
    U32x4 lowB;
    std::memcpy(&lowA, &a, sizeof lowA);
    std::memcpy(&lowB, &b, sizeof lowB);
#if defined(__clang__)
    return __builtin_shufflevector(lowA, lowB, 0, 2, 4, 6);
#else
    return __builtin_shuffle(lowA, lowB, U32x4{0, 2, 4, 6});
#endif
}

// The high 32 bits of them.
inline U32x4 highHalves(F64x2 a, F64x2 b) {
    U32x4 highA;
    U32x4 highB;
    std::memcpy(&highA, &a, sizeof highA);
    std::memcpy(&highB, &b, sizeof highB);
#if defined(__clang__)
    return __builtin_shufflevector(highA, highB, 1, 3, 5, 7);
#else
    return __builtin_shuffle(highA, highB, U32x4{1, 3, 5, 7});
#endif
}

}  // namespace slicecast

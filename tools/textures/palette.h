// The one palette of the project: 48 colours, and the ramps made from them.
//
// Everything painted in the world (textures, skies) takes its colours from here. Shadows lean
// towards violet and blue, lights towards warm yellow, so that materials of different hue still
// stand in the same air.
//
// A ramp lists palette colours from dark to light. A *tone* is a place on it in steps: tone 2 is
// the third colour, tone 2.5 the blend half-way to the fourth. Tones are rounded to half steps,
// which keeps painted areas clean.
#pragma once

#include <array>
#include <cstdint>

#include "slicecast/colour.h"

namespace slicecast::textures {

constexpr Colour fromHex(unsigned hex) {
    return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>((hex >> 8) & 255U),
            static_cast<std::uint8_t>(hex & 255U)};
}

// The blend of two colours; `share` of 256 goes to the second.
constexpr Colour blend(Colour first, Colour second, int share) {
    const auto mix = [share](int from, int to) {
        return static_cast<std::uint8_t>((from * (256 - share) + to * share + 128) / 256);
    };
    return {mix(first.r, second.r), mix(first.g, second.g), mix(first.b, second.b)};
}

// Darkness
inline constexpr Colour kInk = fromHex(0x15131c);
inline constexpr Colour kNight = fromHex(0x232136);

// Slate: cool stone, iron, clouds in shade
inline constexpr Colour kSlate0 = fromHex(0x2e313e);
inline constexpr Colour kSlate1 = fromHex(0x434955);
inline constexpr Colour kSlate2 = fromHex(0x5c656e);
inline constexpr Colour kSlate3 = fromHex(0x798388);
inline constexpr Colour kSlate4 = fromHex(0x9ba5a4);
inline constexpr Colour kSlate5 = fromHex(0xc0c8c1);

// Stone: warm masonry, mortar, plaster in shade
inline constexpr Colour kStone0 = fromHex(0x3a3231);
inline constexpr Colour kStone1 = fromHex(0x544a44);
inline constexpr Colour kStone2 = fromHex(0x736759);
inline constexpr Colour kStone3 = fromHex(0x958674);
inline constexpr Colour kStone4 = fromHex(0xb5a58d);
inline constexpr Colour kStone5 = fromHex(0xd1c3aa);
inline constexpr Colour kStone6 = fromHex(0xe7ddc4);
inline constexpr Colour kCream = fromHex(0xf7f1e1);

// Clay: brick, roof tiles, rust
inline constexpr Colour kClay0 = fromHex(0x3e2129);
inline constexpr Colour kClay1 = fromHex(0x60302f);
inline constexpr Colour kClay2 = fromHex(0x80453d);
inline constexpr Colour kClay3 = fromHex(0xa35b46);
inline constexpr Colour kClay4 = fromHex(0xc07c5a);
inline constexpr Colour kClay5 = fromHex(0xdba277);

// Timber
inline constexpr Colour kTimber0 = fromHex(0x2a1d1e);
inline constexpr Colour kTimber1 = fromHex(0x432d26);
inline constexpr Colour kTimber2 = fromHex(0x61422f);
inline constexpr Colour kTimber3 = fromHex(0x815c3d);
inline constexpr Colour kTimber4 = fromHex(0xa37c51);
inline constexpr Colour kTimber5 = fromHex(0xc39f6c);

// Moss: everything that grows
inline constexpr Colour kMoss0 = fromHex(0x1d2a2b);
inline constexpr Colour kMoss1 = fromHex(0x2d4230);
inline constexpr Colour kMoss2 = fromHex(0x455c35);
inline constexpr Colour kMoss3 = fromHex(0x64783c);
inline constexpr Colour kMoss4 = fromHex(0x8a974a);
inline constexpr Colour kMoss5 = fromHex(0xb4b767);

// Sand
inline constexpr Colour kSand0 = fromHex(0xd2b179);
inline constexpr Colour kSand1 = fromHex(0xe5cc97);
inline constexpr Colour kSand2 = fromHex(0xf3e3bc);

// Brass: gilding, lamplight, flowers
inline constexpr Colour kBrass0 = fromHex(0x7e5626);
inline constexpr Colour kBrass1 = fromHex(0xbc8b36);
inline constexpr Colour kBrass2 = fromHex(0xecc862);

// Sea and sky
inline constexpr Colour kSea0 = fromHex(0x1d3852);
inline constexpr Colour kSea1 = fromHex(0x2b6189);
inline constexpr Colour kSea2 = fromHex(0x4f96ba);
inline constexpr Colour kSea3 = fromHex(0x8bc3dc);
inline constexpr Colour kSea4 = fromHex(0xc8e2e6);

// Evening
inline constexpr Colour kViolet = fromHex(0x54416a);
inline constexpr Colour kPlum = fromHex(0x8e5270);
inline constexpr Colour kCoral = fromHex(0xe3835f);

// All of them, for the palette strip and for the tests.
inline constexpr std::array<Colour, 48> kPalette = {
    kInk,    kNight,  kSlate0,  kSlate1,  kSlate2,  kSlate3,  kSlate4,  kSlate5,  kStone0, kStone1,
    kStone2, kStone3, kStone4,  kStone5,  kStone6,  kCream,   kClay0,   kClay1,   kClay2,  kClay3,
    kClay4,  kClay5,  kTimber0, kTimber1, kTimber2, kTimber3, kTimber4, kTimber5, kMoss0,  kMoss1,
    kMoss2,  kMoss3,  kMoss4,   kMoss5,   kSand0,   kSand1,   kSand2,   kBrass0,  kBrass1, kBrass2,
    kSea0,   kSea1,   kSea2,    kSea3,    kSea4,    kViolet,  kPlum,    kCoral};

struct Ramp {
    std::array<Colour, 8> colours;  // dark to light; only the first `count` are used
    int count;
};

inline constexpr Ramp kSlateRamp{
    {kInk, kSlate0, kSlate1, kSlate2, kSlate3, kSlate4, kSlate5, kCream}, 8};
inline constexpr Ramp kStoneRamp{
    {kStone0, kStone1, kStone2, kStone3, kStone4, kStone5, kStone6, kCream}, 8};
inline constexpr Ramp kClayRamp{{kClay0, kClay1, kClay2, kClay3, kClay4, kClay5, kSand2}, 7};
inline constexpr Ramp kBurntRamp{{kInk, kClay0, kClay1, kClay2, kClay3, kClay4}, 6};
inline constexpr Ramp kTimberRamp{
    {kTimber0, kTimber1, kTimber2, kTimber3, kTimber4, kTimber5, kSand1}, 7};
inline constexpr Ramp kOakRamp{{kInk, kTimber0, kTimber1, kTimber2, kTimber3, kTimber4, kTimber5},
                               7};
inline constexpr Ramp kMossRamp{{kInk, kMoss0, kMoss1, kMoss2, kMoss3, kMoss4, kMoss5}, 7};
inline constexpr Ramp kSandRamp{{kTimber3, kTimber4, kTimber5, kSand0, kSand1, kSand2, kCream}, 7};
inline constexpr Ramp kBrassRamp{{kTimber0, kTimber1, kBrass0, kBrass1, kBrass2, kSand2}, 6};
inline constexpr Ramp kSeaRamp{{kNight, kSea0, kSea1, kSea2, kSea3, kSea4, kCream}, 7};
inline constexpr Ramp kRustRamp{{kTimber0, kTimber1, kTimber2, kBrass0, kClay3, kClay4}, 6};
inline constexpr Ramp kEarthRamp{
    {kTimber0, kTimber1, blend(kTimber2, kStone1, 128), blend(kTimber3, kStone2, 128),
     blend(kTimber4, kStone3, 144), blend(kTimber5, kStone4, 144), kStone5},
    7};
inline constexpr Ramp kFlintRamp{
    {kInk, blend(kSlate0, kStone0, 128), blend(kSlate1, kStone1, 128), blend(kSlate2, kStone2, 128),
     blend(kSlate3, kStone3, 128), blend(kSlate4, kStone4, 128), kStone5, kStone6},
    8};
inline constexpr Ramp kRockRamp{{kInk, kNight, kSlate0, kSlate1, kSlate2, kStone3, kStone4}, 7};
inline constexpr Ramp kLichenRamp{{kStone1, kMoss2, kStone2, kMoss3, kStone3, kMoss4, kStone4}, 7};
inline constexpr Ramp kFireRamp{{kInk, kClay0, kClay1, kClay2, kClay3, kCoral, kBrass2, kCream}, 8};
inline constexpr Ramp kPineRamp{{kInk, kMoss0, blend(kMoss0, kMoss1, 160), kMoss1,
                                 blend(kMoss1, kMoss2, 128), kMoss2, blend(kMoss2, kSlate3, 110)},
                                7};
inline constexpr Ramp kBlossomRamp{{kClay1, kPlum, blend(kPlum, kCoral, 128),
                                    blend(kPlum, kCream, 130), blend(kPlum, kCream, 200), kCream},
                                   6};
inline constexpr Ramp kSkinRamp{
    {kClay1, kClay2, kClay3, kClay4, kClay5, blend(kClay5, kSand2, 128), kSand2}, 7};
inline constexpr Ramp kCrimsonRamp{{kInk, kClay0, kClay1, kClay2, kClay3, kCoral}, 6};

// The colour at a tone of a ramp, rounded to half steps and held inside the ramp.
Colour colourAt(const Ramp& ramp, double tone);

// The same in sixteenths of a step, for skies and soft light.
Colour softColourAt(const Ramp& ramp, double tone);

// How light a colour looks, 0 to 255 (Rec. 709 weights on the bytes).
int greyOf(Colour colour);

}  // namespace slicecast::textures

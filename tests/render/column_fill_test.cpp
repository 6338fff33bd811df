// The innermost loops against plain ones that are written from the definition, byte by byte.
// Lengths and beginnings are such that four rows at a time and single ones both occur.
#include "render/pixels/column_fill.h"

#include "defined_shade.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace slicecast::known {
namespace {

constexpr int kMostBits = 10;
constexpr int kMostRows = 20;
constexpr int kRoom = 64;

// Holes and opaque texels are as frequent as those between.
Pixel anyPixel(Random& random) {
    Colour colour = toColour(static_cast<Pixel>(random.next()));
    if (random.oneIn(3)) colour.a = random.oneIn(2) ? 0 : 255;
    return toPixel(colour);
}

std::vector<Pixel> anyPixels(Random& random, std::size_t count) {
    std::vector<Pixel> pixels(count);
    for (Pixel& pixel : pixels) pixel = anyPixel(random);
    return pixels;
}

std::uint32_t upTo(Random& random, int most) {
    return static_cast<std::uint32_t>(random.between(0, most));
}

std::uint32_t anyFactor(Random& random) {
    return random.oneIn(3) ? 256 : upTo(random, 256);
}

std::uint32_t anyFog(Random& random) {
    return random.oneIn(2) ? 0 : upTo(random, 255);
}

TextureLevel anyLevel(Random& random, int bits) {
    const std::size_t size = std::size_t{1} << bits;
    return {static_cast<int>(size), bits, anyPixels(random, size * size)};
}

// Rows that are filled at odd places too; all that is not theirs must be left alone.
struct Rows {
    std::vector<Pixel> pixels;
    int first;
    int last;

    explicit Rows(Random& random, int most = kMostRows)
        : pixels(anyPixels(random, kRoom)),
          first(random.below(6)),
          last(first + random.between(0, most)) {}

    template <typename One>
    std::vector<Pixel> filled(One&& one) const {
        std::vector<Pixel> expected = pixels;
        for (int row = first; row < last; ++row) {
            Pixel& pixel = expected[static_cast<std::size_t>(row)];
            pixel = one(row, pixel);
        }
        return expected;
    }
};

TEST(ColumnFill, Sides) {
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const int bits = random.between(0, kMostBits);
        const std::vector<Pixel> texels = anyPixels(random, std::size_t{1} << bits);
        const int shift = kTexturePositionBits - bits;
        constexpr std::uint64_t kTile = std::uint64_t{1} << kTexturePositionBits;
        Rows rows(random);
        const auto count = static_cast<std::uint64_t>(rows.last - rows.first);
        const std::uint64_t start = random.next() % kTile;
        const std::uint64_t step = random.next() % ((kTile - start - 1) / (count + 1) + 1);
        const DefinedLight light = {anyFactor(random), anyFog(random), anyPixel(random)};
        const Lay lay = random.oneIn(2) ? Lay::opaque : Lay::over;
        const std::vector<Pixel> expected = rows.filled([&](int row, Pixel there) {
            const std::uint64_t at = start + static_cast<std::uint64_t>(row - rows.first) * step;
            return defined(texels[static_cast<std::size_t>(at >> shift)], light, lay, there);
        });
        fillSide(rows.pixels.data() + rows.first, rows.last - rows.first,
                 {.texels = texels.data(),
                  .start = start,
                  .step = step,
                  .factor = light.factor,
                  .fog = light.fog,
                  .shift = shift},
                 light.haze, lay);
        ASSERT_EQ(rows.pixels, expected) << "case " << i;
    }
}

// As objects are drawn: positions in texels, any number of them.
TEST(ColumnFill, ColumnsOfAnyLength) {
    Random random(2);
    for (int i = 0; i < 5000; ++i) {
        const int length = random.between(1, 300);
        const std::vector<Pixel> texels = anyPixels(random, static_cast<std::size_t>(length));
        Rows rows(random);
        const std::uint64_t end = static_cast<std::uint64_t>(length) << 32;
        const auto count = static_cast<std::uint64_t>(rows.last - rows.first);
        const std::uint64_t start = random.next() % end;
        const std::uint64_t step = (end - start - 1) / (count + 1);
        const DefinedLight light = {anyFactor(random), anyFog(random), anyPixel(random)};
        const std::vector<Pixel> expected = rows.filled([&](int row, Pixel there) {
            const std::uint64_t at = start + static_cast<std::uint64_t>(row - rows.first) * step;
            return defined(texels[static_cast<std::size_t>(at >> 32)], light, Lay::over, there);
        });
        fillSide(rows.pixels.data() + rows.first, rows.last - rows.first,
                 {.texels = texels.data(),
                  .start = start,
                  .step = step,
                  .factor = light.factor,
                  .fog = light.fog,
                  .shift = 32},
                 light.haze, Lay::over);
        ASSERT_EQ(rows.pixels, expected) << "case " << i;
    }
}

// Every colour in every light and in every fog.
TEST(ColumnFill, EveryColour) {
    std::vector<Pixel> texels(256);
    for (std::uint32_t c = 0; c < 256; ++c) texels[c] = c | (255 - c) << 8 | c << 16 | 255u << 24;
    std::vector<Pixel> out(256);
    std::vector<Pixel> expected(256);
    const auto compare = [&](const DefinedLight& light) {
        std::transform(texels.begin(), texels.end(), expected.begin(),
                       [&](Pixel texel) { return defined(texel, light, Lay::opaque, 0); });
        fillSide(out.data(), 256,
                 {.texels = texels.data(), .step = 1, .factor = light.factor, .fog = light.fog},
                 light.haze);
        ASSERT_EQ(out, expected) << "light " << light.factor << ", fog " << light.fog;
    };
    for (std::uint32_t factor = 0; factor <= 256; ++factor) compare({factor, 0, 0});
    for (std::uint32_t fog = 0; fog <= 255; ++fog) {
        for (const Pixel haze : {0xff000000u, 0xffffffffu, 0xff3380c8u}) compare({256, fog, haze});
    }
}

// A plane's tables.
struct Tables {
    std::vector<double> inverseOffsets;
    std::vector<std::uint32_t> factors;
    std::vector<std::uint32_t> fogs;

    // On a grid of 1/1024, points lie on borders of texels exactly.
    Tables(Random& random, bool onGrid) {
        const double scale = random.between(0.001, 2.0);
        for (int row = 0; row < kRoom; ++row) {
            const double inverse = random.unit() * scale;
            inverseOffsets.push_back(onGrid ? std::floor(inverse * 1024.0) / 1024.0 : inverse);
            factors.push_back(
                static_cast<std::uint32_t>(std::clamp(random.between(-100, 400), 0, 256)));
            fogs.push_back(
                static_cast<std::uint32_t>(std::clamp(random.between(-300, 300), 0, 255)));
        }
    }

    DefinedLight at(int row, PlaneShade shade, Pixel haze) const {
        const auto i = static_cast<std::size_t>(row);
        return {shade == PlaneShade::full ? 256 : factors[i],
                shade == PlaneShade::foggy ? fogs[i] : 0, haze};
    }
};

std::vector<std::uint32_t> twice(std::vector<std::uint32_t> values) {
    for (std::uint32_t& value : values) value = inBothHalves(value);
    return values;
}

std::size_t texelAt(double position, int size) {
    const double fraction = position - std::floor(position);
    return static_cast<std::size_t>(std::min(size - 1, static_cast<int>(fraction * size)));
}

PlaneLine anyLine(Random& random, bool onGrid) {
    const auto perInverse = [&] {
        const double per = random.between(-500.0, 500.0);
        return onGrid ? std::floor(per) / 4.0 : per;
    };
    const double east = random.below(65536) / 65536.0;
    const double south = random.below(65536) / 65536.0;
    return {onGrid ? std::floor(east * 16.0) / 16.0 : east, south, perInverse(), perInverse(),
            random.oneIn(2)};
}

TEST(ColumnFill, Planes) {
    Random random(3);
    std::vector<TextureLevel> levels;
    for (int bits = 0; bits <= kMostBits; ++bits) levels.push_back(anyLevel(random, bits));
    for (int i = 0; i < 20000; ++i) {
        const TextureLevel& level = levels[static_cast<std::size_t>(random.between(0, kMostBits))];
        const bool onGrid = random.oneIn(4);
        const Tables tables(random, onGrid);
        const PlaneLine line = anyLine(random, onGrid);
        const PlaneShade shade = static_cast<PlaneShade>(random.below(3));
        const Pixel haze = anyPixel(random);
        const Lay lay = random.oneIn(2) ? Lay::opaque : Lay::over;
        Rows rows(random, random.oneIn(4) ? 50 : kMostRows);
        const std::vector<Pixel> expected = rows.filled([&](int row, Pixel there) {
            const double inverse = tables.inverseOffsets[static_cast<std::size_t>(row)];
            const std::size_t u =
                texelAt(line.eastStart + line.eastPerInverse * inverse, level.size);
            std::size_t v = texelAt(line.southStart + line.southPerInverse * inverse, level.size);
            if (line.southReversed) v = static_cast<std::size_t>(level.size) - 1 - v;
            return defined(level.texels[(u << level.bits) + v], tables.at(row, shade, haze), lay,
                           there);
        });
        const std::vector<std::uint32_t> factors = twice(tables.factors);
        const std::vector<std::uint32_t> fogs = twice(tables.fogs);
        fillPlane(rows.pixels.data(), rows.first, rows.last,
                  {level, line, {tables.inverseOffsets.data(), factors.data(), fogs.data()}, haze},
                  shade, lay);
        ASSERT_EQ(rows.pixels, expected) << "case " << i;
    }
}

TEST(ColumnFill, ReversedBlends) {
    Random random(4);
    for (int i = 0; i < 20000; ++i) {
        Rows rows(random);
        const int count = rows.last - rows.first;
        const std::vector<Pixel> colours = anyPixels(random, static_cast<std::size_t>(count));
        const std::uint32_t strength = random.oneIn(8) ? 255 : upTo(random, 255);
        const std::vector<Pixel> expected = rows.filled([&](int row, Pixel there) {
            return over(colours[static_cast<std::size_t>(rows.last - 1 - row)], there, strength);
        });
        blendReversed(rows.pixels.data() + rows.first, count, colours.data(), strength);
        ASSERT_EQ(rows.pixels, expected) << "case " << i;
    }
}

TEST(ColumnFill, SingleTexels) {
    Random random(5);
    for (int i = 0; i < 50000; ++i) {
        const Pixel texel = anyPixel(random);
        const Pixel there = anyPixel(random);
        const DefinedLight light = {anyFactor(random), anyFog(random), anyPixel(random)};
        for (const Lay lay : {Lay::opaque, Lay::over}) {
            ASSERT_EQ(shadedTexel(texel, light.factor, light.fog, light.haze, lay, there),
                      defined(texel, light, lay, there));
        }
    }
}

TEST(ColumnFill, FractionsOfATile) {
    EXPECT_EQ(PlaneLine::fractionBits(0.25, 0.5, 1.0), 0xc0000000u);
    EXPECT_EQ(PlaneLine::fractionBits(0.25, -0.5, 1.0), 0xc0000000u);
    EXPECT_EQ(PlaneLine::fractionBits(0.25, 3.0, 4.25), 0u) << "13 tiles further on, on the border";
    EXPECT_EQ(PlaneLine::fractionBits(0.0, 1.0, 1.0 / 4294967296.0), 1u);
    EXPECT_EQ(PlaneLine::fractionBits(0.0, -1.0, 1.0 / 4294967296.0), 0xffffffffu);
    EXPECT_EQ(PlaneLine::fractionBits(0.5, -500000.0, 1.0), 0x80000000u);
}

}  // namespace
}  // namespace slicecast::known

// Lit columns against the formula, one texel at a time, and what is kept of them.
#include "render/light/lit_texels.h"
#include "base/random.h"
#include "render/light/light_lines.h"
#include "render/light/lit_images.h"
#include "render/pixels/lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace slicecast {
namespace {

TextureLevel levelOf(int bits, Random& random) {
    TextureLevel level;
    level.bits = bits;
    level.size = 1 << bits;
    level.texels.resize(std::size_t{1} << (2 * bits));
    for (Pixel& texel : level.texels) texel = static_cast<Pixel>(random.next());
    return level;
}

FaceNodes nodesByChance(Random& random) {
    FaceNodes nodes;
    for (Pixel& node : nodes.nodes) node = static_cast<Pixel>(random.next()) | 0xff000000u;
    return nodes;
}

// See "Baked light" in web/docs/picture.md.
Pixel litByFormula(Pixel texel, const FaceNodes& nodes, int a, int b) {
    Pixel lit = texel & 0xff000000u;
    const auto weightA = static_cast<std::uint32_t>((a & 32767) >> 8);
    const auto weightB = static_cast<std::uint32_t>((b & 32767) >> 8);
    for (int shift = 0; shift < 24; shift += 8) {
        const auto node = [&](int nodeA, int nodeB) {
            return nodes.nodes[FaceNodes::index(a >> 15, b >> 15, nodeA, nodeB)] >> shift & 255;
        };
        const std::uint32_t sum =
            (128 - weightB) * ((128 - weightA) * node(0, 0) + weightA * node(1, 0)) +
            weightB * ((128 - weightA) * node(0, 1) + weightA * node(1, 1)) + 8192;
        const std::uint32_t light = (sum >> 14) + (sum >> 21);
        lit |= ((texel >> shift & 255) * light + 128) >> 8 << shift;
    }
    return lit;
}

// Where the middle of a texel is along an axis that goes up or down with the texels.
int placeOf(int texel, int size, bool falls, int shift) {
    const int middle = (2 * texel + 1) * 32768 / size;
    return ((falls ? 65536 - middle : middle) + shift) & 65535;
}

class LitTexels : public testing::TestWithParam<LitFace> {};

TEST_P(LitTexels, FollowTheFormulaInAllSizes) {
    const LitFace face = GetParam();
    const bool isSide = face <= LitFace::west;
    const bool fallsA = face == LitFace::north || face == LitFace::east;
    const bool fallsB = isSide || face == LitFace::bottom || face == LitFace::ceilingBelow ||
                        face == LitFace::ceilingAbove;
    Random random(7);
    for (int bits = 0; bits <= 10; ++bits) {
        const TextureLevel level = levelOf(bits, random);
        for (const int shift : {0, 20001, 33333}) {
            const FaceNodes nodes = nodesByChance(random);
            const FaceTexels texels(level, face, {shift}, {shift});
            std::vector<Pixel> lit(static_cast<std::size_t>(level.size) + 4);
            for (int u = 0; u < level.size; u += std::max(1, level.size / 7)) {
                lightColumn(lit.data(), u, 0, level.size, texels, nodes);
                const int a = placeOf(u, level.size, fallsA, shift);
                for (int v = 0; v < level.size; ++v) {
                    const auto at = static_cast<std::size_t>(u << bits | v);
                    const int b = placeOf(v, level.size, fallsB, shift);
                    ASSERT_EQ(lit[static_cast<std::size_t>(v)],
                              litByFormula(level.texels[at], nodes, a, b))
                        << level.size << " texels, moved by " << shift << ", at " << u << ' ' << v;
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Faces, LitTexels,
                         testing::Values(LitFace::north, LitFace::east, LitFace::south,
                                         LitFace::west, LitFace::top, LitFace::bottom,
                                         LitFace::floor, LitFace::ceilingAbove));

// A texel whose middle is on the border of two tiles of a side is at the upper end of the lower
// one.
TEST(LitTexels, OnABorderAreAtTheUpperEnd) {
    const TexelAxis axis = {TexelAxis::Way::downward, {32768 / 8}};
    EXPECT_EQ(axis.placeOf(0, 8), 65535);
    EXPECT_EQ(axis.placeOf(1, 8), 65536 - 8192);
}

struct Images {
    LitImages images;
    Random random{3};
    TextureLevel level = levelOf(6, random);
    FaceNodes nodes = nodesByChance(random);

    const Pixel* make(int tile, LitImages::Source source = {1, 1}, Coordinate shift = {}) {
        return images.make({{tile, 0, 0, LitFace::floor}, level, shift, {}}, nodes, source);
    }
    const Pixel* find(int tile, Coordinate shift = {}) const {
        return images.find({{tile, 0, 0, LitFace::floor}, level, shift, {}});
    }
};

TEST(LitImages, AreMadeOnceAndAskedForAfterEachChange) {
    Images kept;
    kept.images.beginFrame(true);
    EXPECT_EQ(kept.find(5), nullptr);
    const Pixel* const made = kept.make(5);
    EXPECT_EQ(kept.find(5), made);
    EXPECT_EQ(kept.find(5, {1}), nullptr) << "the texture has moved";
    std::vector<Pixel> column(64);
    lightColumn(column.data(), 9, 0, 64, {kept.level, LitFace::floor, {}, {}}, kept.nodes);
    EXPECT_TRUE(std::equal(column.begin(), column.end(), made + 9 * 64));

    kept.images.beginFrame(false);
    EXPECT_EQ(kept.find(5), made);
    kept.images.beginFrame(true);
    EXPECT_EQ(kept.find(5), nullptr) << "its light may have changed";
    const std::vector<Pixel> before(made, made + 4096);
    kept.nodes = nodesByChance(kept.random);
    EXPECT_EQ(kept.make(5), made);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), made)) << "from the same light";
    kept.images.beginFrame(true);
    EXPECT_EQ(kept.make(5, {1, 2}), made) << "takes its old place";
    EXPECT_FALSE(std::equal(before.begin(), before.end(), made)) << "from other light";
}

// Ends of lines, weighted, against the formula.
TEST(LightLines, HoldTheLightOfTheirTexels) {
    Random random(11);
    LightLines lines;
    lines.beginFrame();
    for (int bits = 0; bits <= 10; ++bits) {
        const FaceNodes nodes = nodesByChance(random);
        const std::uint64_t key = LightLines::keyOf({bits, 3, 1, LitFace::top}, bits);
        EXPECT_EQ(lines.find(key, 1), LightLines::kNone);
        const std::uint32_t first = lines.make(key, 1, bits, nodes, 1);
        EXPECT_EQ(lines.find(key, 1), first);
        EXPECT_EQ(lines.find(key, 2), LightLines::kNone) << "its light may have changed";
        const int size = 1 << bits;
        for (int u = 0; u < size; u += std::max(1, size / 9)) {
            for (int v = 0; v < size; v += std::max(1, size / 7)) {
                const int a = placeOf(u, size, false, 0);
                const int b = placeOf(v, size, false, 0);
                const int line = (bits > 0 ? b >> 15 : 0) * size + u;
                const auto weight = static_cast<std::uint32_t>((b & 32767) >> 8);
                const U32x4 sum = dotPairs(
                    loadVector<U32x4>(lines.all() + first + static_cast<std::size_t>(line)),
                    allLanes((128 - weight) | weight << 16));
                Pixel lit = 0;
                for (int channel = 0; channel < 4; ++channel) {
                    const std::uint32_t light = (sum[channel] >> 14) + (sum[channel] >> 21);
                    lit |= (200 * light + 128) >> 8 << (8 * channel);
                }
                ASSERT_EQ(lit, litByFormula(0xc8c8c8c8, nodes, a, b))
                    << size << " texels, at " << u << ' ' << v;
            }
        }
    }
}

TEST(LightLines, AreMadeAgainFromOtherNodesOnly) {
    Random random(12);
    LightLines lines;
    const FaceNodes nodes = nodesByChance(random);
    const std::uint32_t first = lines.make(7, 1, 3, nodes, 1);
    const auto before = lines.all()[first + 5].ends;
    EXPECT_EQ(lines.make(7, 2, 3, nodesByChance(random), 1), first);
    EXPECT_EQ(lines.all()[first + 5].ends, before) << "from the same light";
    EXPECT_EQ(lines.make(7, 3, 3, nodesByChance(random), 3), first);
    EXPECT_NE(lines.all()[first + 5].ends, before) << "from other light";
}

// Somebody walks over a large map: 200 tiles are seen at a time.
TEST(LitImages, KeepAtMostTwiceWhatAPictureNeeds) {
    constexpr int kSeen = 200;
    Images kept;
    std::size_t most = 0;
    std::size_t first = 0;
    for (int step = 0; step < 2000; ++step) {
        kept.images.beginFrame(true);
        for (int tile = step; tile < step + kSeen; ++tile) {
            if (kept.find(tile) == nullptr) kept.make(tile);
        }
        if (step == 0) first = kept.images.kept();
        most = std::max(most, kept.images.kept());
    }
    EXPECT_GE(first, kSeen * 4096u);
    EXPECT_LE(most, 3 * first) << "twice, and what the last picture needed more";
    EXPECT_GT(most, 3 * first / 2);
}

}  // namespace
}  // namespace slicecast

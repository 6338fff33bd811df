// Blended texels: known answers, and every way to fill rows against the plain one.
#include "render/pixels/smooth_texels.h"

#include "base/random.h"
#include "render/light/smooth_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace slicecast {
namespace {

constexpr std::uint32_t placeOf(double fraction) {
    return static_cast<std::uint32_t>(fraction * 4294967296.0);
}

constexpr Pixel grey(std::uint8_t value, std::uint8_t alpha = 255) {
    return toPixel({value, value, value, alpha});
}

// 8 x 8 texels, all of one colour but for the first column of them.
struct Board {
    std::vector<Pixel> texels = std::vector<Pixel>(64, grey(0));

    SmoothTexture texture(bool uReversed = false, bool seeThrough = false) const {
        return {texels.data(), 3, uReversed, false, seeThrough};
    }
};

int red(Pixel pixel) {
    return toColour(pixel).r;
}

TEST(SmoothTexels, ShowATexelAtItsMiddleAndTheMeanBetweenTwo) {
    Board board;
    for (std::size_t v = 0; v < 8; ++v) board.texels[v] = grey(128);
    const auto shown = [&](double u) {
        return red(smoothTexel(board.texture(), placeOf(u), placeOf(0.3)));
    };
    EXPECT_EQ(shown(0.5 / 8), 128);
    EXPECT_EQ(shown(0.75 / 8), 96);
    EXPECT_EQ(shown(1.0 / 8), 64);
    EXPECT_EQ(shown(1.25 / 8), 32);
    EXPECT_EQ(shown(1.5 / 8), 0);
}

TEST(SmoothTexels, GoOnAtTheBorderAsIfRepeated) {
    Board board;
    for (std::size_t v = 0; v < 8; ++v) board.texels[v] = grey(128);
    const auto shown = [&](double u, bool reversed) {
        return red(smoothTexel(board.texture(reversed), placeOf(u), placeOf(0.3)));
    };
    EXPECT_EQ(shown(0.0, false), 64);
    EXPECT_EQ(shown(7.5 / 8, false), 0);
    EXPECT_EQ(shown(7.75 / 8, false), 32);
    EXPECT_EQ(shown(7.5 / 8, true), 128) << "the first texel, counted from the other end";
    EXPECT_EQ(shown(0.0, true), 64);
}

TEST(SmoothTexels, TakeNoColourFromHoles) {
    Board board;
    for (Pixel& texel : board.texels) texel = grey(200, 0);
    board.texels[9] = grey(40, 120);
    const auto shown = [&](double u) {
        return smoothTexel(board.texture(false, true), placeOf(u), placeOf(1.4 / 8));
    };
    EXPECT_EQ(shown(1.5 / 8), grey(40, 120));
    EXPECT_EQ(shown(1.01 / 8), grey(40, 120)) << "up to its edge";
    EXPECT_EQ(toColour(shown(0.99 / 8)).a, 0);
}

Image noise(Random& random, int size, bool holes) {
    Image image(size, size);
    for (Pixel& pixel : image.pixels) {
        pixel = static_cast<Pixel>(random.next());
        pixel = holes && random.oneIn(3) ? pixel & 0xffffff : pixel | 0xff000000;
    }
    return image;
}

// Every way to fill rows, for all sizes and numbers of rows.
TEST(SmoothTexels, RowsAreAsPointsAre) {
    Random random(1);
    for (int size = 8; size <= 1024; size *= 2) {
        for (const bool holes : {false, true}) {
            const Texture texture = makeTexture("noise", noise(random, size, holes));
            const TextureLevel& level = texture.levels[0];
            for (int rows = 0; rows < 40; ++rows) {
                const SmoothTexture from = {level.texels.data(), level.bits, random.oneIn(2),
                                            random.oneIn(2), holes};
                const auto u = static_cast<std::uint32_t>(random.next());
                TexelColumn column;
                column.start = random.next() >> 16;
                column.step = (kWholeTexture - 1 - column.start) / 50;
                std::vector<Pixel> colours(44, 7);
                SmoothTexture side = from;
                side.vReversed = false;
                blendSide(colours.data(), rows, side, u, column);
                for (int row = 0; row < rows; ++row) {
                    const std::uint64_t at =
                        column.start + static_cast<std::uint64_t>(row) * column.step;
                    ASSERT_EQ(colours[static_cast<std::size_t>(row)],
                              smoothTexel(side, u, static_cast<std::uint32_t>(at >> 16)))
                        << size << " row " << row;
                }
                EXPECT_EQ(colours[static_cast<std::size_t>(rows)], 7u);
                const PlaneLine line = {random.unit(), random.unit(), random.between(-9.0, 9.0),
                                        random.between(-9.0, 9.0), from.vReversed};
                std::vector<double> inverses(44);
                for (double& inverse : inverses) inverse = random.unit();
                const int first = random.below(rows + 1);
                blendPlane(colours.data(), first, rows, from, line, inverses.data());
                for (int row = first; row < rows; ++row) {
                    const double inverse = inverses[static_cast<std::size_t>(row)];
                    ASSERT_EQ(colours[static_cast<std::size_t>(row)],
                              smoothTexel(from,
                                          PlaneLine::fractionBits(line.eastStart,
                                                                  line.eastPerInverse, inverse),
                                          PlaneLine::fractionBits(line.southStart,
                                                                  line.southPerInverse, inverse)))
                        << size << " row " << row;
                }
            }
        }
    }
}

FaceNodes anyNodes(Random& random) {
    FaceNodes nodes;
    for (Pixel& node : nodes.nodes) node = static_cast<Pixel>(random.next()) | 0xff000000;
    return nodes;
}

// The light of rows is that of their points.
TEST(SmoothLight, RowsAreAsPointsAre) {
    Random random(3);
    for (int rows = 0; rows < 40; ++rows) {
        const FaceNodes nodes = anyNodes(random);
        std::vector<Pixel> texels(44);
        for (Pixel& texel : texels) texel = static_cast<Pixel>(random.next());
        const int a = random.below(65536);
        const Coordinate rise = {random.below(65536)};
        TexelColumn column;
        column.start = random.next() >> 16;
        column.step = (kWholeTexture - 1 - column.start) / 50;
        std::vector<Pixel> lit = texels;
        lightSide(lit.data(), rows, nodes, a, column, rise);
        for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
            const auto down = static_cast<int>((column.start + row * column.step) >> 32);
            ASSERT_EQ(lit[row], litAt(texels[row], nodes, a,
                                      std::min(65535, 65536 - ((down - rise.raw) & 65535))));
        }
        EXPECT_EQ(lit[static_cast<std::size_t>(rows)], texels[static_cast<std::size_t>(rows)]);
        const PlaneLine line = {random.unit(), random.unit(), 3.0, -2.0, false};
        std::vector<double> inverses(44);
        for (double& inverse : inverses) inverse = random.unit();
        lit = texels;
        lightPlane(lit.data(), 0, rows, nodes, line, inverses.data());
        for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
            const auto place = [&](double start, double perInverse) {
                return static_cast<int>(PlaneLine::fractionBits(start, perInverse, inverses[row]) >>
                                        16);
            };
            ASSERT_EQ(lit[row],
                      litAt(texels[row], nodes, place(line.eastStart, line.eastPerInverse),
                            place(line.southStart, line.southPerInverse)));
        }
    }
}

}  // namespace
}  // namespace slicecast

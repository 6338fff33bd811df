// Columns of texels cut into pieces: every row is in the piece that its texel asks for.
#include "render/spans/texel_cut.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace slicecast {
namespace {

// Runs of a few texels up to all.
std::vector<Pixel> anyColumn(Random& random, int height) {
    std::vector<Pixel> texels;
    while (static_cast<int>(texels.size()) < height) {
        const int kind = random.below(3);
        const std::uint32_t alpha = kind == 0 ? 0 : kind == 1 ? 255 : 100;
        for (int n = random.between(1, height); n > 0; --n) texels.push_back(alpha << 24);
    }
    texels.resize(static_cast<std::size_t>(height));
    return texels;
}

TEST(TexelCut, EachRowByItsTexel) {
    Random random(1);
    int holes = 0;
    int opaque = 0;
    for (int i = 0; i < 3000 && !testing::Test::HasFailure(); ++i) {
        const int height = 1 << random.between(0, 7);
        const std::vector<Pixel> texels = anyColumn(random, height);
        const TexelRuns runs(texels, height);
        const int first = random.between(0, 40);
        const int last = first + random.between(1, 300);
        const auto end = static_cast<std::uint64_t>(height) << 32;
        TexelColumn column = {.texels = texels.data(), .shift = 32};
        column.start = random.next() % end;
        column.step = random.oneIn(9) ? 0 : (end - column.start - 1) / 300;
        const auto alphaAt = [&](const TexelColumn& piece, int rows) {
            const std::uint64_t at = piece.start + static_cast<std::uint64_t>(rows) * piece.step;
            return piece.texels[at >> piece.shift] >> 24;
        };
        const auto expectHoles = [&](int from, int to) {
            for (int row = from; row < to; ++row, ++holes)
                EXPECT_EQ(alphaAt(column, row - first), 0u);
        };
        int next = first;
        const int margin = random.oneIn(2) ? 0 : random.between(1, 20);
        cutTexels(column, runs.of(0), first, last, CutMargin{margin, 0},
                  [&](const TexelColumn& piece, int from, int to, bool layer) {
                      EXPECT_LT(from, to);
                      expectHoles(next, from);
                      for (int row = from; row < to; ++row) {
                          const std::uint32_t alpha = alphaAt(piece, row - from);
                          EXPECT_EQ(alpha, alphaAt(column, row - first));
                          if (layer) continue;
                          EXPECT_EQ(alpha, 255u);
                          ++opaque;
                      }
                      for (int row = std::max(first, from - (from > 0 ? margin : 0));
                           !layer && row < to + margin; ++row)
                          EXPECT_EQ(alphaAt(column, row - first), 255u) << "in the margin";
                      next = to;
                  });
        expectHoles(next, last);
    }
    EXPECT_GT(holes, 10000);
    EXPECT_GT(opaque, 10000);
}

TEST(TexelCut, OpaqueRowsButForTheMargin) {
    std::vector<int> layers;
    std::vector<int> closed;
    const auto cut = [&](int first, int last, int margin, int horizon = 0) {
        layers.clear();
        closed.clear();
        cutOpaque({.start = 100, .step = 7}, first, last, CutMargin{margin, horizon},
                  [&](const TexelColumn& piece, int from, int to, bool layer) {
                      EXPECT_EQ(piece.start, 100u + 7u * static_cast<unsigned>(from - first));
                      for (int row = from; row < to; ++row)
                          (layer ? layers : closed).push_back(row);
                  });
    };
    cut(3, 9, 0);
    EXPECT_EQ(layers, std::vector<int>{});
    EXPECT_EQ(closed, (std::vector<int>{3, 4, 5, 6, 7, 8}));
    cut(3, 9, 2);
    EXPECT_EQ(layers, (std::vector<int>{3, 4, 7, 8}));
    EXPECT_EQ(closed, (std::vector<int>{5, 6}));
    cut(3, 9, 3);
    EXPECT_EQ(layers, (std::vector<int>{3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(closed, std::vector<int>{});
    cut(3, 9, 3, 8);
    EXPECT_EQ(layers, (std::vector<int>{8}));
    EXPECT_EQ(closed, (std::vector<int>{3, 4, 5, 6, 7}));
    cut(3, 9, 3, 9);
    EXPECT_EQ(layers, std::vector<int>{});
}

}  // namespace
}  // namespace slicecast

// Columns of texels cut into pieces: every row is in the piece that its texel asks for.
#include "render/texel_cut.h"

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
        cutTexels(column, runs.of(0), first, last,
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
                      next = to;
                  });
        expectHoles(next, last);
    }
    EXPECT_GT(holes, 10000);
    EXPECT_GT(opaque, 10000);
}

}  // namespace
}  // namespace slicecast

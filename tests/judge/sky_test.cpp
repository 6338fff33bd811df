// The shape of clouds before the judge's own.
#include "tracer_sky.h"

#include "world/cloud_cover.h"

#include <gtest/gtest.h>

namespace slicecast::judge {
namespace {

TEST(JudgeSky, CloudsHaveTheDefinedShape) {
    for (const auto& [seed, size] : {std::pair{0u, 1.0}, {7u, 0.1}, {1'000'000'000u, 10.0}}) {
        const auto cover = makeCloudCover(seed, size);
        ASSERT_EQ(cover->density.size(), 1024u * 256u);
        for (int i = 0; i < 1024; i += 5) {
            for (int j = 0; j < 256; j += 3) {
                ASSERT_EQ(cover->density[static_cast<std::size_t>(i * 256 + j)],
                          cloudDensity(seed, size, i, j))
                    << "column " << i << ", row " << j << " of seed " << seed;
            }
        }
    }
}

}  // namespace
}  // namespace slicecast::judge

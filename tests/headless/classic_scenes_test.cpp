// Without any of its old ways, the classic method draws the shipped scenes as the exact method
// does: also gates, lifts, mirrors, portals and objects that move.
#include "base/random.h"
#include "files/scene_file.h"
#include "session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

namespace slicecast {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 100;

Image drawn(Session& session, const char* method) {
    session.setOption("method", method);
    Image image(kWidth, kHeight);
    EXPECT_TRUE(session.draw({image.pixels.data(), kWidth, kHeight, kWidth}));
    return image;
}

Eye anyEye(Random& random, const World& world) {
    const int map = random.below(static_cast<int>(world.maps.size()));
    const Map& m = world.maps[static_cast<std::size_t>(map)];
    return {.map = map,
            .x = {random.between(0, m.width * 65536 - 1)},
            .y = {random.between(0, m.depth * 65536 - 1)},
            .z = {random.between(1, (m.levels + 1) * 65536)},
            .headingDegrees = random.between(0.0, 360.0),
            .look = random.oneIn(2) ? 0.0 : random.between(-0.5, 0.5)};
}

class ClassicScenes : public testing::TestWithParam<const char*> {};

TEST_P(ClassicScenes, EqualTheExactMethodsPictures) {
    LoadedScene scene = readSceneFile(std::string(SLICECAST_SOURCE_FOLDER "/tests/frozen/scenes/") +
                                      GetParam() + ".json");
    ASSERT_TRUE(scene.world.has_value());
    Session session(std::move(*scene.world));
    session.setOption("detail", "off");
    Random random(7);
    int different = 0;
    constexpr int kViews = 8;
    for (int view = 0; view < kViews; ++view) {
        // Gates half open, lifts on their way
        for (int step = 0; step < 50; ++step) session.step({.use = view == 0 && step == 0});
        if (view > 0) session.setEye(anyEye(random, session.world()));
        const Image exact = drawn(session, "exact");
        const Image classic = drawn(session, "classic");
        for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
            const Colour a = toColour(exact.pixels[i]);
            const Colour b = toColour(classic.pixels[i]);
            if (std::abs(a.r - b.r) > 1 || std::abs(a.g - b.g) > 1 || std::abs(a.b - b.b) > 1)
                ++different;
        }
    }
    // Where a ray meets an edge within a rounding, and glass that is joined through a portal
    EXPECT_LE(different, kViews * kWidth * kHeight / 500);
}

INSTANTIATE_TEST_SUITE_P(Frozen, ClassicScenes,
                         testing::Values("castle", "garden", "glassworks", "harbour-town",
                                         "library", "night-works", "water-palace", "wayhouse"),
                         [](const auto& scene) {
                             std::string name = scene.param;
                             name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                             return name;
                         });

}  // namespace
}  // namespace slicecast

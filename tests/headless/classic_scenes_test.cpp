// Without any of its old ways, the classic method draws the shipped scenes as the exact method
// does: also gates, lifts, mirrors, portals and objects that move.
#include "base/random.h"
#include "files/scene_file.h"
#include "session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

namespace slicecast {
namespace {

Image drawn(Session& session, const char* method, int width, int height) {
    session.setOption("method", method);
    Image image(width, height);
    EXPECT_TRUE(session.draw({image.pixels.data(), width, height, width}));
    return image;
}

Session sessionOf(const std::string& path) {
    LoadedScene scene = readSceneFile(std::string(SLICECAST_SOURCE_FOLDER "/") + path);
    if (!scene.world.has_value()) throw std::runtime_error(path + " has faults");
    return Session(std::move(*scene.world));
}

// To the byte, but where a ray meets an edge within a rounding.
TEST(ClassicShipped, EqualsTheExactPictureAtTheStart) {
    constexpr int kWidth = 640;
    constexpr int kHeight = 400;
    int scenes = 0;
    for (const auto& file :
         std::filesystem::directory_iterator(SLICECAST_SOURCE_FOLDER "/assets/scenes")) {
        const std::string name = file.path().filename().string();
        if (name == "index.json") continue;
        ++scenes;
        Session session = sessionOf("assets/scenes/" + name);
        const Image exact = drawn(session, "exact", kWidth, kHeight);
        const Image classic = drawn(session, "classic", kWidth, kHeight);
        int equal = 0;
        for (std::size_t i = 0; i < exact.pixels.size(); ++i)
            equal += exact.pixels[i] == classic.pixels[i] ? 1 : 0;
        EXPECT_GE(equal, kWidth * kHeight / 100 * 99) << name;
    }
    EXPECT_GE(scenes, 13);
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
    constexpr int kWidth = 160;
    constexpr int kHeight = 100;
    Session session = sessionOf(std::string("tests/frozen/scenes/") + GetParam() + ".json");
    Random random(7);
    int different = 0;
    constexpr int kViews = 8;
    for (int view = 0; view < kViews; ++view) {
        // Gates half open, lifts on their way
        for (int step = 0; step < 50; ++step) session.step({.use = view == 0 && step == 0});
        if (view > 0) session.setEye(anyEye(random, session.world()));
        const Image exact = drawn(session, "exact", kWidth, kHeight);
        const Image classic = drawn(session, "classic", kWidth, kHeight);
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

// A crew of threads: each hand does each job once, and a picture that they draw together has the
// bytes that one draws.
#include "app/thread_crew.h"
#include "base/image.h"
#include "files/scene_file.h"
#include "session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

constexpr int kMostHands = 5;

TEST(ThreadCrew, EveryHandDoesEveryJobOnce) {
    for (int hands = 1; hands <= kMostHands; ++hands) {
        ThreadCrew crew(hands);
        ASSERT_EQ(crew.hands(), hands);
        std::vector<int> done(static_cast<std::size_t>(hands));
        for (int job = 1; job <= 500; ++job) {
            crew.work([&](int hand) { ++done[static_cast<std::size_t>(hand)]; });
            ASSERT_EQ(done, std::vector<int>(done.size(), job));
        }
    }
}

TEST(ThreadCrew, TheCallerHasAHandAndTheOthersAreThreads) {
    ThreadCrew crew(3);
    std::vector<std::thread::id> who(3);
    crew.work([&](int hand) { who[static_cast<std::size_t>(hand)] = std::this_thread::get_id(); });
    EXPECT_EQ(who[0], std::this_thread::get_id());
    EXPECT_NE(who[1], who[0]);
    EXPECT_NE(who[2], who[0]);
    EXPECT_NE(who[2], who[1]);
}

TEST(ThreadCrew, IsLimitedToThePossibleThreads) {
    EXPECT_EQ(ThreadCrew(0).hands(), 1);
    EXPECT_EQ(ThreadCrew(kMostThreads + 1).hands(), kMostThreads);
    EXPECT_GE(threadsOfMachine(), 1);
    EXPECT_LE(threadsOfMachine(), kMostThreads);
}

TEST(ThreadCrew, MayEndWithoutAJob) {
    for (int i = 0; i < 100; ++i) ThreadCrew(4).hands();
}

// ---- Pictures

struct PictureSize {
    int width, height;
};

// Not all of whole strips, and some of fewer strips than hands.
constexpr PictureSize kSizes[] = {{320, 180}, {333, 101}, {1, 1},    {16, 16},  {17, 40},
                                  {47, 64},   {64, 9},    {65, 300}, {640, 360}};

std::unique_ptr<Session> sessionOf(const std::string& scene) {
    LoadedScene loaded = readSceneFile(std::filesystem::path(SLICECAST_SOURCE_FOLDER) /
                                       "tests/frozen/scenes" / (scene + ".json"));
    EXPECT_TRUE(loaded.world.has_value()) << scene;
    return std::make_unique<Session>(std::move(loaded.world).value_or(World{}));
}

std::vector<Pixel> drawn(Session& session, PictureSize size, double fraction = 1.0) {
    Image image(size.width, size.height);
    EXPECT_TRUE(session.draw({image.pixels.data(), size.width, size.height, size.width}, fraction));
    return image.pixels;
}

bool isSame(const FrameReport& a, const FrameReport& b) {
    return a.tilesWalked == b.tilesWalked && a.blocksMet == b.blocksMet &&
           a.spansDrawn == b.spansDrawn && a.partsBehindPortals == b.partsBehindPortals &&
           a.deepestPortal == b.deepestPortal && a.mirroredRows == b.mirroredRows &&
           a.layers == b.layers && a.objectSlices == b.objectSlices && a.rowsFilled == b.rowsFilled;
}

class CrewPictures : public testing::TestWithParam<const char*> {};

TEST_P(CrewPictures, EqualThoseOfOneRenderer) {
    const std::unique_ptr<Session> alone = sessionOf(GetParam());
    const std::unique_ptr<Session> together = sessionOf(GetParam());
    for (int hands = 1; hands <= kMostHands; ++hands) {
        ThreadCrew crew(hands);
        together->renderer().setCrew(&crew);
        for (const PictureSize size : kSizes) {
            for (Session* session : {alone.get(), together.get()}) {
                for (int i = 0; i < 7; ++i) session->step({.forward = 1.0, .turn = 0.5});
            }
            SCOPED_TRACE(std::to_string(hands) + " hands, " + std::to_string(size.width) + "x" +
                         std::to_string(size.height));
            ASSERT_EQ(drawn(*together, size, 0.5), drawn(*alone, size, 0.5));
            EXPECT_TRUE(isSame(together->report(), alone->report()));
        }
        together->renderer().setCrew(nullptr);
    }
}

// The left part of a comparison is the old way's: the crew begins within a strip.
TEST_P(CrewPictures, StartWhereAComparisonEnds) {
    const std::unique_ptr<Session> alone = sessionOf(GetParam());
    const std::unique_ptr<Session> together = sessionOf(GetParam());
    ThreadCrew crew(3);
    together->renderer().setCrew(&crew);
    for (const char* share : {"0.1", "0.37", "1"}) {
        ASSERT_EQ(alone->setOption("compare", share), "");
        ASSERT_EQ(together->setOption("compare", share), "");
        EXPECT_EQ(drawn(*together, {150, 60}), drawn(*alone, {150, 60})) << share;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, CrewPictures,
                         testing::Values("castle", "glassworks", "water-palace", "wayhouse"),
                         [](const testing::TestParamInfo<const char*>& scene) {
                             std::string name = scene.param;
                             name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                             return name;
                         });

TEST(CrewPictures, InvalidPicturesAreNotChanged) {
    const std::unique_ptr<Session> session = sessionOf("castle");
    ThreadCrew crew(3);
    CrewRenderer renderer;
    renderer.setCrew(&crew);
    std::vector<Pixel> pixels(64 * 32, 77);
    Eye below = session->eye();
    below.z = Coordinate{};
    EXPECT_FALSE(renderer.draw(session->world(), below, {}, {pixels.data(), 64, 32, 64}));
    EXPECT_EQ(pixels, std::vector<Pixel>(64 * 32, 77));
    EXPECT_EQ(renderer.report().rowsFilled, 0);
}

// The same crew serves one game after another, as in the program.
TEST(CrewPictures, GamesShareACrew) {
    ThreadCrew crew(2);
    for (const char* scene : {"castle", "wayhouse", "castle"}) {
        const std::unique_ptr<Session> session = sessionOf(scene);
        const std::vector<Pixel> alone = drawn(*session, {200, 120});
        session->renderer().setCrew(&crew);
        EXPECT_EQ(drawn(*session, {200, 120}), alone) << scene;
    }
}

}  // namespace
}  // namespace slicecast

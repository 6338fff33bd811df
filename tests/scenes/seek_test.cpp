// Any step of a recording of a shipped scene, gone to from anywhere, is byte for byte what playing
// through leads to: its state, its pictures, and what follows.
#include "base/random.h"
#include "files/recording_file.h"
#include "sanitized.h"
#include "scenes/shipped.h"
#include "session/session.h"
#include "world/mover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace slicecast {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 24;
constexpr int kSeeks = kSanitized ? 6 : 24;
constexpr int kStepsAfter = 40;

struct Seen {
    std::uint64_t state = 0;
    std::vector<Pixel> now;
    std::vector<Pixel> between;  // half-way from the step before

    friend bool operator==(const Seen&, const Seen&) = default;
};

std::vector<Pixel> drawn(Session& session, double fraction) {
    std::vector<Pixel> pixels(std::size_t{kWidth} * kHeight);
    EXPECT_TRUE(session.draw({pixels.data(), kWidth, kHeight, kWidth}, fraction));
    return pixels;
}

Seen seen(Session& session) {
    return {session.fingerprint(), drawn(session, 1.0), drawn(session, 0.5)};
}

// Goes to random steps, in an order that goes forth and back, and on for a while from each.
void expectSameAnywhere(const std::string& scene, const Recording& recording) {
    Random random(static_cast<std::uint64_t>(recording.steps));
    std::vector<int> steps;
    const int last = static_cast<int>(recording.steps) - kStepsAfter;
    for (int i = 0; i < kSeeks; ++i) steps.push_back(random.below(last));
    std::vector<int> wanted;
    for (const int step : steps) {
        wanted.push_back(step);
        wanted.push_back(step + kStepsAfter);
    }
    std::sort(wanted.begin(), wanted.end());

    const World world = shippedWorld(scene);
    std::vector<Seen> played(static_cast<std::size_t>(recording.steps) + 1);
    Session through(world.copy());
    Replay all(recording);
    for (const int step : wanted) {
        while (all.stepsDone() < step) ASSERT_TRUE(all.step(through));
        played[static_cast<std::size_t>(step)] = seen(through);
    }

    Session session(world.copy());
    Replay replay(recording);
    for (const int step : steps) {
        while (!replay.seek(session, step, 50)) {
        }
        EXPECT_TRUE(seen(session) == played[static_cast<std::size_t>(step)]) << "step " << step;
        for (int i = 0; i < kStepsAfter; ++i) replay.step(session);
        EXPECT_TRUE(seen(session) == played[static_cast<std::size_t>(step + kStepsAfter)])
            << "after step " << step;
        // Somebody else plays before the next one
        replay.leave();
        session.setFlying(random.oneIn(2));
        for (int i = 0; i < kStepsAfter; ++i) session.step({.forward = 1.0, .use = i == 0});
        if (random.oneIn(3)) session.reset();
    }
}

// Somebody who walks about, opens gates, rides on what moves, goes from place to place and changes
// cells.
class Rover {
public:
    Rover(const World& world, const std::string& scene)
        : session_(world.copy()), recorder_(scene), random_(scene.size()) {
        session_.record(&recorder_);
    }

    Recording rove(int legs) {
        for (int leg = 0; leg < legs; ++leg) {
            doSomething();
            Input input;
            input.forward = random_.oneIn(4) ? random_.between(-1.0, 1.0) : 1.0;
            input.turn = random_.oneIn(2) ? random_.between(-1.0, 1.0) : 0.0;
            input.fly = random_.oneIn(4) ? random_.between(-1.0, 1.0) : 0.0;
            input.jump = random_.oneIn(3);
            input.use = random_.oneIn(2);
            const int steps = random_.between(1, 90);
            for (int i = 0; i < steps; ++i) session_.step(input);
        }
        EXPECT_GT(edits_, 0);
        return recorder_.finish(session_);
    }

private:
    void doSomething() {
        const World& world = session_.world();
        switch (random_.below(8)) {
            case 0:
                return session_.setFlying(random_.oneIn(2));
            case 1:
                session_.goToMap(random_.below(static_cast<int>(world.maps.size())));
                return;
            case 2:
                return goTo(world.quest.finds);
            case 3:
                return goToMover();
            case 4:
                if (random_.oneIn(4)) session_.reset();
                return;
            default:
                return edit();
        }
    }
    void goTo(const std::vector<Find>& finds) {
        if (finds.empty()) return;
        const Find& find =
            finds[static_cast<std::size_t>(random_.below(static_cast<int>(finds.size())))];
        if (find.object < 0) return;
        const Object& object = session_.world()
                                   .maps[static_cast<std::size_t>(find.map)]
                                   .objects[static_cast<std::size_t>(find.object)];
        session_.setEye({find.map, object.x, object.y, object.z + kStandingEye});
        session_.setFlying(false);
    }
    void goToMover() {
        const World& world = session_.world();
        if (world.movers.empty()) return;
        const Mover& mover = world.movers[static_cast<std::size_t>(
            random_.below(static_cast<int>(world.movers.size())))];
        const Box box = boundsOf(world, mover);
        session_.setEye({mover.map, box.west, box.north, box.top + kStandingEye});
        session_.setFlying(false);
    }
    void edit() {
        const Player& player = session_.player();
        const Map& map = session_.world().maps[static_cast<std::size_t>(player.map)];
        if (map.legend.empty()) return;
        const LegendEntry& entry = map.legend[static_cast<std::size_t>(
            random_.below(static_cast<int>(map.legend.size())))];
        const CellAt at = {player.map, random_.below(map.levels),
                           player.x.tile() + random_.between(-3, 3),
                           player.y.tile() + random_.between(-3, 3)};
        edits_ += session_.setCell(at, random_.oneIn(2) ? entry.sign : std::string(".")).empty();
    }

    Session session_;
    Recorder recorder_;
    Random random_;
    int edits_ = 0;
};

TEST(SeekShipped, EveryTour) {
    for (const auto& entry : std::filesystem::directory_iterator(assetsFolder() / "tours")) {
        const std::string scene = entry.path().stem().string();
        SCOPED_TRACE(scene);
        ReadRecording read = readRecordingFile(entry.path().string());
        ASSERT_TRUE(read.recording);
        expectSameAnywhere(scene, *read.recording);
    }
}

TEST(SeekShipped, RandomPlay) {
    for (const std::string& scene : shippedScenes()) {
        SCOPED_TRACE(scene);
        Rover rover(shippedWorld(scene), scene);
        expectSameAnywhere(scene, rover.rove(kSanitized ? 20 : 80));
    }
}

}  // namespace
}  // namespace slicecast

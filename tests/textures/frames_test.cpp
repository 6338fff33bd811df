// Pictures in frames: loops close, gates open, water falls.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "textures/committed.h"

namespace slicecast::textures {
namespace {

// How much each frame differs from the next; the last from the first.
std::vector<double> stepsOf(const Entry& entry) {
    std::vector<double> steps;
    for (int frame = 0; frame < entry.frames; ++frame) {
        steps.push_back(
            difference(frameOf(entry, frame), frameOf(entry, (frame + 1) % entry.frames)));
    }
    return steps;
}

TEST(Frames, LoopsCloseWithoutAJump) {
    int loops = 0;
    for (const Entry& entry : catalogue()) {
        if (!entry.loops) {
            continue;
        }
        ++loops;
        std::vector<double> steps = stepsOf(entry);
        const double closing = steps.back();
        steps.pop_back();
        EXPECT_LE(closing, 1.25 * *std::max_element(steps.begin(), steps.end())) << entry.name;
        EXPECT_GE(closing, 0.75 * *std::min_element(steps.begin(), steps.end())) << entry.name;
    }
    EXPECT_GE(loops, 9);
}

TEST(Frames, NoFrameStandsStillAndNoneLeaps) {
    int moving = 0;
    for (const Entry& entry : catalogue()) {
        if (!entry.loops) {
            continue;
        }
        ++moving;
        const std::vector<double> steps = stepsOf(entry);
        // A glow that breathes is slow where it turns
        EXPECT_GT(*std::min_element(steps.begin(), steps.end()), 0.4) << entry.name;
        EXPECT_LT(*std::max_element(steps.begin(), steps.end()),
                  5.5 * *std::min_element(steps.begin(), steps.end()))
            << entry.name;
    }
    EXPECT_GE(moving, 9);
}

TEST(Frames, GatesOpenStepByStep) {
    for (const char* name : {"portcullis", "double-door"}) {
        const Entry entry = entryNamed(name);
        ASSERT_EQ(entry.frames, 8);
        for (int frame = 0; frame + 1 < entry.frames; ++frame) {
            EXPECT_GT(coverage(frameOf(entry, frame)), coverage(frameOf(entry, frame + 1)))
                << name << " frame " << frame;
        }
        EXPECT_GT(coverage(frameOf(entry, 0)), 0.5) << name;
        EXPECT_LT(coverage(frameOf(entry, entry.frames - 1)), 0.35) << name;
    }
    EXPECT_EQ(coverage(frameOf(entryNamed("double-door"), 0)), 1.0);
}

// Where a frame is looked at `rows` further down, it is like the frame before.
double differenceMoved(const Image& before, const Image& after, int rows) {
    Image moved(before.width, before.height);
    for (int y = 0; y < before.height; ++y) {
        for (int x = 0; x < before.width; ++x) {
            moved.at(x, y) = after.at(x, (y + rows + before.height) % before.height);
        }
    }
    return difference(before, moved);
}

TEST(Frames, TheWaterfallFalls) {
    const Entry entry = entryNamed("waterfall");
    for (int frame = 0; frame < entry.frames; ++frame) {
        const Image before = frameOf(entry, frame);
        const Image after = frameOf(entry, (frame + 1) % entry.frames);
        const double down = differenceMoved(before, after, 16);
        EXPECT_LT(down, 0.85 * differenceMoved(before, after, 0)) << frame;
        EXPECT_LT(down, 0.85 * differenceMoved(before, after, -16)) << frame;
    }
}

}  // namespace
}  // namespace slicecast::textures

// Objects found piece by piece are those that are found at once.
#include "render/view/frame_objects.h"

#include "base/random.h"
#include "scenes.h"
#include "slice_stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace slicecast::known {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr int kWidth = 200;

World forest(Random& random, int trees) {
    World world = emptyWorld(60, 60, 1, plain("floor", {60, 60, 60, 255}));
    const SpriteId tree = addSprite(world, 8, 16);
    for (int i = 0; i < trees; ++i)
        addObject(world, tree, random.between(0.0, 60.0), random.between(0.0, 60.0), 0.0,
                  random.between(0.1, 3.0), random.between(0.1, 2.0));
    return world;
}

// Those that cover a column, as far as they are asked for.
std::vector<int> shownIn(FrameObjects& objects, const Projection& projection, int column,
                         const ColumnObjects& list, double from, double to) {
    std::vector<int> shown;
    for (const int i : list.objects) {
        const FrameObject& object = objects[i];
        const double share =
            (projection.sidewaysSlope(column) * object.depth - object.left) / object.width;
        if (share >= 0.0 && share < 1.0 && object.depth >= from && object.depth < to)
            shown.push_back(object.index);
    }
    return shown;
}

// Asks for random columns and depths, alone and then together, and compares with a view of its own
// that is asked once for all.
void expectSameInPieces(int trees, std::uint64_t seed) {
    Random random(seed);
    const World world = forest(random, trees);
    const Eye eye = {.map = 0,
                     .x = toCoordinate(30.3),
                     .y = toCoordinate(29.6),
                     .z = toCoordinate(0.5),
                     .headingDegrees = random.below(360) + 0.5};
    SliceStage stage(world, eye, kWidth, 100);
    Vista& vista = stage.ofEye();
    FrameObjects pieces = vista.objects;
    FrameObjectRoom room;
    const Detail detail({.fovDegrees = 90.0}, vista.projection->distance);
    pieces.beginFrame(world, *vista.cells, vista.viewpoint, *vista.projection, detail,
                      vista.lighting, room);
    int seen = 0;
    for (int i = 0; i < 400; ++i) {
        const int column = random.below(kWidth);
        const double from = random.oneIn(3) ? random.below(30) : -1.0;
        const double to = random.oneIn(9) ? kEndless : from + random.below(20);
        const std::vector<int> asked =
            shownIn(pieces, *vista.projection, column, pieces.inColumn(column, from, to), from, to);
        const std::vector<int> all =
            shownIn(vista.objects, *vista.projection, column,
                    vista.objects.inColumn(column, -1.0, kEndless), from, to);
        ASSERT_EQ(asked, all) << "seed " << seed << ", ask " << i << ", column " << column
                              << ", depths " << from << " to " << to;
        seen += static_cast<int>(all.size());
    }
    EXPECT_GT(seen, trees / 10);
}

TEST(FrameObjects, AreTheSameInPieces) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        expectSameInPieces(30, seed);     // together from the first ask on
        expectSameInPieces(1'000, seed);  // after 15 asks
        expectSameInPieces(5'000, seed);
    }
}

}  // namespace
}  // namespace slicecast::known

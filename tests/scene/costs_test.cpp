// The time that loading and a step take at most: the sum of what scene/limits.h and world/limits.h
// list. The constants are nanoseconds, measured with scenes that do little else, on a machine on
// which a frame of the castle takes a millisecond; tests/worst/bounds.cpp makes such scenes, and
// measures them again.
#include "scene/limits.h"
#include "world/crowd.h"
#include "world/gate.h"
#include "world/mover.h"
#include "world/object_motion.h"
#include "world/quest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace slicecast {
namespace {

constexpr double kCastle = 1e6;      // nanoseconds
constexpr double kMostLoad = 100.0;  // castles
constexpr double kMostStep = 5.0;
constexpr double kBytes = 200'000.0;  // of a scene's text
constexpr double kFilled = kMaxFilledCells;
static_assert(kFilled >= kBytes, "rows of such a text set fewer");

struct Cost {
    const char* what;
    double count;
    double each;  // nanoseconds
};

double castles(const std::vector<Cost>& costs) {
    double sum = 0.0;
    for (const Cost& cost : costs) sum += cost.count * cost.each / kCastle;
    return sum;
}

// No more than a limit, or than the text has room for.
double inText(double limit, double bytesEach) {
    return std::min(limit, kBytes / bytesEach);
}

TEST(Costs, OfAStepAreWithinThePromise) {
    constexpr double kObjects = kMaxMovingObjects;
    constexpr double kGates = kMaxGateCells;
    const std::vector<Cost> costs = {
        {"movers", kMaxMovers, 40.0},
        {"parts of movers", kMaxMoverParts, 5.0},
        {"cells of movers", inText(kMaxMovingCells, 1.0), 0.8},
        {"levels of moving objects", kMaxMovingLevels, 370.0},
        {"others in the way", kObjects * kMostNeighbours, 4.0},
        {"looks for the player", kObjects / kLookSteps, 600.0},
        {"lists that objects have left", kMaxObjects, 4.0},
        {"ways to follow", kKeptPortals * inText(kMaxPortals, 43.0), 1.5},
        {"ways of patrols", kMostPortalLooks, 1.5},
        {"gates", kGates, 100.0},
        {"followers", kGates * kGates / 4.0, 0.2},
        {"who is near a gate", kMostApproachLooks, 3.0},
        {"finds and messages", kMaxFinds + kMaxNotices, 10.0},
        {"looks of messages", kMostNoticeLooks, 1000.0},
    };
    // The constants are rounded up
    EXPECT_LE(castles(costs), 1.1 * kMostStep);
}

TEST(Costs, OfLoadingAreWithinThePromise) {
    const std::vector<Cost> costs = {
        {"text", kBytes, 50.0},
        {"cells", kFilled * kMaxLevels, 1.5},
        {"blocks", kFilled, 60.0},
        {"parts of movers", kMaxMoverParts, 150.0},
        {"cells of movers", inText(kMaxMovingCells, 1.0), 15.0},
        {"sowing", kFilled * kMaxSowings, 12.0},
        {"areas", inText(kMaxNotices, 50.0) * kMaxMapWidth, 0.5},
        {"portals", inText(kMaxPortals, 43.0) * static_cast<double>(kMaxPortalWays), 1.5},
        {"legends", inText(kMaxMaps, 44.0) * static_cast<double>(kMaxLegend), 3.0},
    };
    // What a text spends on one of these it does not have for another: sowing takes most
    double most = 0.0;
    for (const Cost& cost : costs) most = std::max(most, castles({cost}));
    EXPECT_LE(castles(costs), 1.5 * kMostLoad);
    EXPECT_LE(most, kMostLoad);
    EXPECT_LE(castles({{"colours", kMaxPlainTextures, 45'000.0}}), kMostLoad);
    EXPECT_LE(castles({{"clouds", kMaxCloudShapes, 14'000'000.0}}), kMostLoad);
}

}  // namespace
}  // namespace slicecast

#include "base/coordinate.h"

#include <gtest/gtest.h>

#include <limits>

namespace slicecast {
namespace {

TEST(Coordinate, RoundsToTheNearestAndHalvesUp) {
    EXPECT_EQ(toCoordinate(1.5).raw, 98304);
    EXPECT_EQ(toCoordinate(0.5 / 65536).raw, 1);
    EXPECT_EQ(toCoordinate(0.49 / 65536).raw, 0);
    EXPECT_EQ(toCoordinate(-0.5 / 65536).raw, 0);
    EXPECT_EQ(toCoordinate(-0.51 / 65536).raw, -1);
    EXPECT_EQ(toCoordinate(-2.25).raw, -147456);
}

TEST(Coordinate, SplitsIntoTileAndFraction) {
    EXPECT_EQ(toCoordinate(3.25).tile(), 3);
    EXPECT_EQ(toCoordinate(3.25).fraction(), 0.25);
    EXPECT_EQ(toCoordinate(-0.25).tile(), -1);
    EXPECT_EQ(toCoordinate(-0.25).fraction(), 0.75);
    EXPECT_EQ(tileEdge(7), toCoordinate(7.0));
}

TEST(Coordinate, ClampsWhatItCannotHold) {
    EXPECT_EQ(toCoordinate(1e30).value(), kCoordinateLimit);
    EXPECT_EQ(toCoordinate(-1e30).value(), -kCoordinateLimit);
    EXPECT_EQ(toCoordinate(std::numeric_limits<double>::infinity()).value(), kCoordinateLimit);
    EXPECT_EQ(toCoordinate(std::numeric_limits<double>::quiet_NaN()).raw, 0);
}

}  // namespace
}  // namespace slicecast

#include "base/angle.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(Angle, QuarterTurnsAreExact) {
    EXPECT_EQ(sinDegrees(90), 1);
    EXPECT_EQ(cosDegrees(90), 0);
}

}  // namespace
}  // namespace slicecast

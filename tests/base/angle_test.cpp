#include "base/angle.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicecast {
namespace {

TEST(Angle, QuarterTurnsAreExact) {
    const double sines[] = {0, 1, 0, -1};
    for (int turn = -8; turn <= 8; ++turn) {
        const int quadrant = ((turn % 4) + 4) % 4;
        EXPECT_EQ(sinDegrees(90.0 * turn), sines[quadrant]) << turn;
        EXPECT_EQ(cosDegrees(90.0 * turn), sines[(quadrant + 1) % 4]) << turn;
    }
}

TEST(Angle, EighthTurnsHaveEqualSineAndCosine) {
    EXPECT_EQ(sinDegrees(45), cosDegrees(45));
    EXPECT_EQ(sinDegrees(135), -cosDegrees(135));
    EXPECT_EQ(tanDegrees(45), 1);
    EXPECT_EQ(atanDegrees(1), 45);
}

TEST(Angle, AQuarterTurnSwapsAndNegatesExactly) {
    Random random(1);
    for (int i = 0; i < 10'000; ++i) {
        // Multiples of 1/1024, to which 90 can be added without rounding.
        const double degrees = random.between(-400'000, 400'000) / 1024.0;
        const SineCosine here = sineCosineDegrees(degrees);
        const SineCosine turned = sineCosineDegrees(degrees + 90.0);
        ASSERT_EQ(turned.sine, here.cosine) << degrees;
        ASSERT_EQ(turned.cosine, -here.sine) << degrees;
    }
}

TEST(Angle, AgreesWithTheLibrary) {
    Random random(2);
    for (int i = 0; i < 100'000; ++i) {
        const double degrees = random.between(-720.0, 720.0);
        const long double radians =
            static_cast<long double>(degrees) * 3.14159265358979323846264338327950288L / 180;
        ASSERT_NEAR(sinDegrees(degrees), static_cast<double>(std::sin(radians)), 3e-16) << degrees;
        ASSERT_NEAR(cosDegrees(degrees), static_cast<double>(std::cos(radians)), 3e-16) << degrees;
        const double slope = random.between(-50.0, 50.0);
        ASSERT_NEAR(atanDegrees(slope),
                    static_cast<double>(std::atan(static_cast<long double>(slope)) * 180 /
                                        3.14159265358979323846264338327950288L),
                    3e-14)
            << slope;
    }
}

// The same bits from every compiler: written down once.
TEST(Angle, BitsAreFixed) {
    EXPECT_EQ(sinDegrees(30), 0x1.fffffffffffffp-2);
    EXPECT_EQ(sinDegrees(1), 0x1.1df0b2b89dd1ep-6);
    EXPECT_EQ(cosDegrees(33.3), cosDegrees(-33.3));
    EXPECT_EQ(sinDegrees(33.3), -sinDegrees(-33.3));
}

TEST(Angle, WrapsHeadings) {
    EXPECT_EQ(wrapDegrees(0), 0);
    EXPECT_EQ(wrapDegrees(360), 0);
    EXPECT_EQ(wrapDegrees(-90), 270);
    EXPECT_EQ(wrapDegrees(725), 5);
    EXPECT_LT(wrapDegrees(-1e-20), 360);
    EXPECT_GE(wrapDegrees(-1e-20), 0);
}

}  // namespace
}  // namespace slicecast

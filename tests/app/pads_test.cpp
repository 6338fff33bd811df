#include "app/pads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slicecast {
namespace {

TEST(Pads, TheCursorIsCentredInTheMiddleAndFullAtTheEdge) {
    for (const double inside : {0.0, 0.1, -0.2, 0.2})
        EXPECT_EQ(pastDeadZone(inside, kCursorDeadZone), 0.0) << inside;
    EXPECT_NEAR(pastDeadZone(0.2001, kCursorDeadZone), 0.0001 / 0.8, 1e-12)
        << "no jump at its edge";
    EXPECT_NEAR(pastDeadZone(0.6, kCursorDeadZone), 0.5, 1e-12);
    EXPECT_NEAR(pastDeadZone(-0.6, kCursorDeadZone), -0.5, 1e-12);
    EXPECT_EQ(pastDeadZone(1.0, kCursorDeadZone), 1.0);
    EXPECT_EQ(pastDeadZone(-7.0, kCursorDeadZone), -1.0);
    EXPECT_EQ(pastDeadZone(std::numeric_limits<double>::quiet_NaN(), kCursorDeadZone), 0.0);
}

TEST(Pads, TheCursorTurnsSidewaysAndLooksUpAndDown) {
    const Input right = cursorInput(1.0, 0.1);
    EXPECT_EQ(right.turn, 1.0);
    EXPECT_EQ(right.look, 0.0);
    const Input above = cursorInput(-0.1, -1.0);
    EXPECT_EQ(above.turn, 0.0);
    EXPECT_EQ(above.look, 1.0);
}

TEST(Pads, AStickHasARoundZone) {
    const Stick rest = pastDeadZone(Stick{0.1, 0.1}, kStickDeadZone);
    EXPECT_EQ(rest.x, 0.0);
    EXPECT_EQ(rest.y, 0.0);
    const Stick slanted = pastDeadZone(Stick{0.9, -0.9}, kStickDeadZone);
    EXPECT_NEAR(slanted.x, std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(slanted.y, -std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(pastDeadZone(Stick{0.0, 0.575}, kStickDeadZone).y, 0.5, 1e-12);
}

TEST(Pads, AGamepadDoesWhatTheKeysDo) {
    Gamepad gamepad;
    EXPECT_FALSE(isAnything(gamepadInput(gamepad)));
    gamepad.left = {1.0, 0.0};
    gamepad.right = {0.0, -1.0};
    gamepad.rightTrigger = 1.0;
    gamepad.buttons = kPadJump | kPadSlow;
    Input input = gamepadInput(gamepad);
    EXPECT_EQ(input.strafe, 1.0);
    EXPECT_EQ(input.look, 1.0);
    EXPECT_EQ(input.fly, 1.0);
    EXPECT_TRUE(input.jump);
    EXPECT_TRUE(input.slow);
    EXPECT_FALSE(input.fast);

    gamepad = {};
    gamepad.left = {0.0, -1.0};
    gamepad.right = {1.0, 0.0};
    gamepad.buttons = kPadUp | kPadLeft | kPadCrouch | kPadFast | kPadUse;
    input = gamepadInput(gamepad);
    EXPECT_EQ(input.forward, 1.0) << "both at once are no more than one";
    EXPECT_EQ(input.strafe, -1.0);
    EXPECT_EQ(input.turn, 1.0);
    EXPECT_EQ(input.fly, -1.0);
    EXPECT_TRUE(input.fast);
    EXPECT_TRUE(input.use);

    // A button for gates counts as input, and is joined like the others.
    for (bool Input::*button : {&Input::use, &Input::open, &Input::close}) {
        Input gate;
        gate.*button = true;
        EXPECT_TRUE(isAnything(gate));
        EXPECT_TRUE(together(gate, input).*button);
        EXPECT_TRUE(together(input, gate).*button);
    }
}

}  // namespace
}  // namespace slicecast

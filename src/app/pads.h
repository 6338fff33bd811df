// Turns gamepads, touch controls and the cursor's place in the picture into the input of a step.
// Sticks and the cursor have a dead zone: inside it they count as centred; beyond it values rise
// from 0, so that nothing jumps at its edge.
#pragma once

#include "slicecast/input.h"

namespace slicecast {

// Part of the way from the middle of the picture to its edge.
inline constexpr double kCursorDeadZone = 0.2;
// Part of a stick's way; worn sticks rest off centre.
inline constexpr double kStickDeadZone = 0.15;
inline constexpr double kTriggerDeadZone = 0.08;  // part of a trigger's way

// -1 to 1: 0 inside the zone, then rising linearly to 1 at 1. NaN counts as centred.
double pastDeadZone(double value, double zone);

// The position of a stick or a thumb: -1 to 1, right and down positive.
struct Stick {
    double x = 0.0;
    double y = 0.0;
};

// The same for a stick, whose zone is round. The result lies inside the unit circle.
Stick pastDeadZone(Stick stick, double zone);

// Steers by the cursor: left and right turn, up and down look. -1 to 1 is from the middle to the
// right and bottom edges.
Input cursorInput(double x, double y);

// Gamepad buttons as the web's standard gamepad numbers them; bit n is button n.
enum GamepadButton : unsigned {
    kPadJump = 1u << 0,     // the lower one of the four
    kPadCrouch = 1u << 1,   // the right one
    kPadLevel = 1u << 2,    // the left one
    kPadFly = 1u << 3,      // the upper one
    kPadSlow = 1u << 4,     // left shoulder
    kPadFast = 1u << 5,     // right shoulder
    kPadMinimap = 1u << 8,  // back
    kPadPause = 1u << 9,    // start
    kPadUse = 1u << 11,     // the right stick, pressed
    kPadUp = 1u << 12,
    kPadDown = 1u << 13,
    kPadLeft = 1u << 14,
    kPadRight = 1u << 15,
};

struct Gamepad {
    Stick left;                 // walks
    Stick right;                // turns and looks
    double leftTrigger = 0.0;   // 0 to 1; crouches, sinks
    double rightTrigger = 0.0;  // rises
    unsigned buttons = 0;       // sum of GamepadButton
};

// The input of what is held on a gamepad. The program itself handles buttons that act once per
// press.
Input gamepadInput(const Gamepad& gamepad);

// Two inputs at once: sums, with axes clamped to -1 to 1.
Input together(const Input& a, const Input& b);

// True if any input is active.
bool isAnything(const Input& input);

}  // namespace slicecast

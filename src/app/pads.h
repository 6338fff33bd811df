// What is not a key as a step's input: a gamepad, thumbs on a screen, the cursor's place in the
// picture. Sticks and the cursor have a dead zone: what lies within it is rest, and the rest of the
// way is stretched, so that nothing jumps at its edge.
#pragma once

#include "slicecast/input.h"

namespace slicecast {

inline constexpr double kCursorDeadZone =
    0.2;  // of the way from the middle of the picture to its edge
inline constexpr double kStickDeadZone =
    0.15;  // of a stick's way; worn sticks rest off their middle
inline constexpr double kTriggerDeadZone = 0.08;  // of a trigger's way

// From -1 to 1: 0 within the zone, then rising evenly to 1 at 1.
double pastDeadZone(double value, double zone);

// A stick's place, or a thumb's: -1 to 1 to the right and down.
struct Stick {
    double x = 0.0;
    double y = 0.0;
};

// The same for a stick, whose zone is round; it is never further out than 1.
Stick pastDeadZone(Stick stick, double zone);

// The notes' mouse: left and right turn, up and down look. The cursor is at -1 to 1 from the middle
// to the right and bottom edges.
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

// What is held on a gamepad. Presses that do something once are the program's.
Input gamepadInput(const Gamepad& gamepad);

// Two inputs at once: axes are added up to 1.
Input together(const Input& a, const Input& b);

// True if somebody does anything.
bool isAnything(const Input& input);

}  // namespace slicecast

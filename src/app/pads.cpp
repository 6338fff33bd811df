#include "app/pads.h"

#include <algorithm>
#include <cmath>

namespace slicecast {

namespace {

// Clamps to -1 to 1. NaN counts as centred.
double axis(double value) {
    return value == value ? std::clamp(value, -1.0, 1.0) : 0.0;
}

}  // namespace

double pastDeadZone(double value, double zone) {
    const double size = std::abs(axis(value));
    if (size <= zone) return 0.0;
    const double past = (size - zone) / (1.0 - zone);
    return value < 0.0 ? -past : past;
}

Stick pastDeadZone(Stick stick, double zone) {
    const double x = axis(stick.x);
    const double y = axis(stick.y);
    const double size = std::sqrt(x * x + y * y);
    if (size <= zone) return {};
    const double scale = std::min(1.0, (size - zone) / (1.0 - zone)) / size;
    return {x * scale, y * scale};
}

Input cursorInput(double x, double y) {
    Input input;
    input.turn = pastDeadZone(x, kCursorDeadZone);
    input.look = -pastDeadZone(y, kCursorDeadZone);
    return input;
}

Input gamepadInput(const Gamepad& gamepad) {
    const auto isDown = [&](GamepadButton button) {
        return (gamepad.buttons & button) != 0 ? 1.0 : 0.0;
    };
    const Stick left = pastDeadZone(gamepad.left, kStickDeadZone);
    const Stick right = pastDeadZone(gamepad.right, kStickDeadZone);
    Input input;
    input.forward = axis(-left.y + isDown(kPadUp) - isDown(kPadDown));
    input.strafe = axis(left.x + isDown(kPadRight) - isDown(kPadLeft));
    input.turn = right.x;
    input.look = -right.y;
    input.fly = axis(pastDeadZone(gamepad.rightTrigger, kTriggerDeadZone) -
                     pastDeadZone(gamepad.leftTrigger, kTriggerDeadZone) - isDown(kPadCrouch));
    input.jump = isDown(kPadJump) > 0.0;
    input.fast = isDown(kPadFast) > 0.0;
    input.slow = isDown(kPadSlow) > 0.0;
    input.use = isDown(kPadUse) > 0.0;
    return input;
}

Input together(const Input& a, const Input& b) {
    return {.forward = axis(a.forward + b.forward),
            .strafe = axis(a.strafe + b.strafe),
            .turn = axis(a.turn + b.turn),
            .look = axis(a.look + b.look),
            .fly = axis(a.fly + b.fly),
            .turnDegrees = a.turnDegrees + b.turnDegrees,
            .lookHeights = a.lookHeights + b.lookHeights,
            .jump = a.jump || b.jump,
            .fast = a.fast || b.fast,
            .slow = a.slow || b.slow,
            .use = a.use || b.use,
            .open = a.open || b.open,
            .close = a.close || b.close};
}

bool isAnything(const Input& input) {
    return input.forward != 0.0 || input.strafe != 0.0 || input.turn != 0.0 || input.look != 0.0 ||
           input.fly != 0.0 || input.turnDegrees != 0.0 || input.lookHeights != 0.0 || input.jump ||
           input.use || input.open || input.close;
}

}  // namespace slicecast

#include "app/keys.h"

#include <cstddef>

namespace slicecast {

namespace {

constexpr auto kKeys = std::to_array<Key>({
    {SDL_SCANCODE_W, "KeyW", Action::forward},
    {SDL_SCANCODE_S, "KeyS", Action::back},
    {SDL_SCANCODE_A, "KeyA", Action::strafeLeft},
    {SDL_SCANCODE_D, "KeyD", Action::strafeRight},
    {SDL_SCANCODE_Q, "KeyQ", Action::strafeLeft},
    {SDL_SCANCODE_E, "KeyE", Action::strafeRight},
    {SDL_SCANCODE_LEFT, "ArrowLeft", Action::turnLeft},
    {SDL_SCANCODE_RIGHT, "ArrowRight", Action::turnRight},
    {SDL_SCANCODE_UP, "ArrowUp", Action::lookUp},
    {SDL_SCANCODE_DOWN, "ArrowDown", Action::lookDown},
    {SDL_SCANCODE_SPACE, "Space", Action::jump},
    {SDL_SCANCODE_PAGEUP, "PageUp", Action::rise},
    {SDL_SCANCODE_PAGEDOWN, "PageDown", Action::sink},
    {SDL_SCANCODE_C, "KeyC", Action::sink},
    {SDL_SCANCODE_LSHIFT, "ShiftLeft", Action::fast},
    {SDL_SCANCODE_RSHIFT, "ShiftRight", Action::fast},
    {SDL_SCANCODE_LCTRL, "ControlLeft", Action::slow},
    {SDL_SCANCODE_RCTRL, "ControlRight", Action::slow},
    {SDL_SCANCODE_X, "KeyX", Action::use},
    {SDL_SCANCODE_PERIOD, "Period", Action::open},
    {SDL_SCANCODE_COMMA, "Comma", Action::close},
    {SDL_SCANCODE_R, "KeyR", Action::levelLook},
    {SDL_SCANCODE_KP_6, "Numpad6", Action::heading, 0.0},
    {SDL_SCANCODE_KP_3, "Numpad3", Action::heading, 45.0},
    {SDL_SCANCODE_KP_2, "Numpad2", Action::heading, 90.0},
    {SDL_SCANCODE_KP_1, "Numpad1", Action::heading, 135.0},
    {SDL_SCANCODE_KP_4, "Numpad4", Action::heading, 180.0},
    {SDL_SCANCODE_KP_7, "Numpad7", Action::heading, 225.0},
    {SDL_SCANCODE_KP_8, "Numpad8", Action::heading, 270.0},
    {SDL_SCANCODE_KP_9, "Numpad9", Action::heading, 315.0},
    {SDL_SCANCODE_V, "KeyV", Action::fly},
    {SDL_SCANCODE_INSERT, "Insert", Action::intensityUp},
    {SDL_SCANCODE_DELETE, "Delete", Action::intensityDown},
    {SDL_SCANCODE_HOME, "Home", Action::multiplierUp},
    {SDL_SCANCODE_END, "End", Action::multiplierDown},
    {SDL_SCANCODE_KP_PLUS, "NumpadAdd", Action::mirrorsUp},
    {SDL_SCANCODE_KP_MINUS, "NumpadSubtract", Action::mirrorsDown},
    {SDL_SCANCODE_EQUALS, "Equal", Action::mirrorsUp},
    {SDL_SCANCODE_MINUS, "Minus", Action::mirrorsDown},
    {SDL_SCANCODE_L, "KeyL", Action::lightPreset},
    {SDL_SCANCODE_M, "KeyM", Action::minimap},
    {SDL_SCANCODE_B, "KeyB", Action::minimapTurns},
    {SDL_SCANCODE_O, "KeyO", Action::minimapRays},
    {SDL_SCANCODE_LEFTBRACKET, "BracketLeft", Action::minimapLevelDown},
    {SDL_SCANCODE_RIGHTBRACKET, "BracketRight", Action::minimapLevelUp},
    {SDL_SCANCODE_J, "KeyJ", Action::playerPanel},
    {SDL_SCANCODE_U, "KeyU", Action::processPanel},
    {SDL_SCANCODE_G, "KeyG", Action::inspector},
    {SDL_SCANCODE_F1, "F1", Action::sliceLeft},
    {SDL_SCANCODE_F2, "F2", Action::sliceRight},
    {SDL_SCANCODE_T, "KeyT", Action::hits},
    {SDL_SCANCODE_K, "KeyK", Action::grid},
    {SDL_SCANCODE_Y, "KeyY", Action::slowDrawing},
    {SDL_SCANCODE_F3, "F3", Action::slowerSlices},
    {SDL_SCANCODE_F4, "F4", Action::fasterSlices},
    {SDL_SCANCODE_0, "Digit0", Action::map, 0.0, 0},
    {SDL_SCANCODE_1, "Digit1", Action::map, 0.0, 1},
    {SDL_SCANCODE_2, "Digit2", Action::map, 0.0, 2},
    {SDL_SCANCODE_3, "Digit3", Action::map, 0.0, 3},
    {SDL_SCANCODE_4, "Digit4", Action::map, 0.0, 4},
    {SDL_SCANCODE_5, "Digit5", Action::map, 0.0, 5},
    {SDL_SCANCODE_6, "Digit6", Action::map, 0.0, 6},
    {SDL_SCANCODE_7, "Digit7", Action::map, 0.0, 7},
    {SDL_SCANCODE_8, "Digit8", Action::map, 0.0, 8},
    {SDL_SCANCODE_9, "Digit9", Action::map, 0.0, 9},
    {SDL_SCANCODE_H, "KeyH", Action::help},
    {SDL_SCANCODE_I, "KeyI", Action::rate},
    {SDL_SCANCODE_P, "KeyP", Action::pause},
    {SDL_SCANCODE_F, "KeyF", Action::fullscreen},
    {SDL_SCANCODE_N, "KeyN", Action::cursor},
    {SDL_SCANCODE_F9, "F9", Action::record},
    {SDL_SCANCODE_ESCAPE, "Escape", Action::leave},
});

constexpr auto kHelp = std::to_array<KeyHelp>({
    {"W S", "walk ahead and back"},
    {"A D, Q E", "step left and right"},
    {"Arrows", "turn and look up and down"},
    {"Click", "look with the mouse"},
    {"N", "steer by the mouse's place in the picture"},
    {"Space", "jump"},
    {"Page Down, C", "crouch; sink when flying"},
    {"Page Up", "rise when flying"},
    {"Shift, Ctrl", "faster, slower"},
    {"X", "open or close the gates nearby"},
    {". ,", "open them; close them"},
    {"V", "fly or walk"},
    {"R", "look straight ahead"},
    {"Number pad", "face east (6), south (2), west (4), north (8) or between"},
    {"Ins Del, Home End", "brighter and darker, nearby and far"},
    {"+ -", "mirrors more and less strongly"},
    {"L", "day, dusk, night, fog, or as it was"},
    {"0-9", "go to another map of the scene"},
    {"M, B, O", "minimap; it turns; its rays"},
    {"[ ]", "minimap of a lower or higher level"},
    {"J, U", "where you are; what drawing takes"},
    {"G, F1 F2", "inspect a slice; another one"},
    {"T", "what that slice meets, as text"},
    {"K", "grid of pixels"},
    {"Y, F3 F4", "draw slice by slice; slower, faster"},
    {"H", "these keys"},
    {"I", "frame rate"},
    {"P", "pause"},
    {"F", "full screen"},
    {"F9", "record from the start; again: save"},
    {"Escape", "leave the mouse, then the program"},
});

constexpr std::size_t index(Action action) {
    return static_cast<std::size_t>(action);
}

}  // namespace

std::span<const Key> allKeys() {
    return kKeys;
}

std::span<const KeyHelp> keyHelp() {
    return kHelp;
}

const Key* findKey(SDL_Scancode scancode) {
    for (const Key& key : kKeys) {
        if (key.scancode == scancode) return &key;
    }
    return nullptr;
}

const Key* findKeyByCode(std::string_view code) {
    for (const Key& key : kKeys) {
        if (key.code == code) return &key;
    }
    return nullptr;
}

void HeldKeys::press(const Key& key) {
    bool& down = down_[static_cast<std::size_t>(key.scancode)];
    if (down || !isHeld(key.action)) return;
    down = true;
    ++count_[index(key.action)];
    pressed_[index(key.action)] = true;
}

void HeldKeys::release(const Key& key) {
    bool& down = down_[static_cast<std::size_t>(key.scancode)];
    if (!down) return;
    down = false;
    --count_[index(key.action)];
}

void HeldKeys::releaseAll() {
    *this = HeldKeys();
}

bool HeldKeys::isDown(Action action) const {
    return count_[index(action)] > 0;
}

Input HeldKeys::takeInput() {
    const auto active = [this](Action action) {
        return count_[index(action)] > 0 || pressed_[index(action)];
    };
    const auto axis = [active](Action positive, Action negative) {
        return (active(positive) ? 1.0 : 0.0) - (active(negative) ? 1.0 : 0.0);
    };
    Input input;
    input.forward = axis(Action::forward, Action::back);
    input.strafe = axis(Action::strafeRight, Action::strafeLeft);
    input.turn = axis(Action::turnRight, Action::turnLeft);
    input.look = axis(Action::lookUp, Action::lookDown);
    input.fly = axis(Action::rise, Action::sink);
    input.jump = active(Action::jump);
    input.fast = active(Action::fast);
    input.slow = active(Action::slow);
    input.use = active(Action::use);
    input.open = active(Action::open);
    input.close = active(Action::close);
    pressed_ = {};
    return input;
}

}  // namespace slicecast

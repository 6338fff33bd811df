#include "app/keyboard.h"

#include <array>

namespace slicecast {

namespace {

constexpr auto kPositions = std::to_array<KeyPosition>({
    {"KeyA", "A", SDL_SCANCODE_A},
    {"KeyB", "B", SDL_SCANCODE_B},
    {"KeyC", "C", SDL_SCANCODE_C},
    {"KeyD", "D", SDL_SCANCODE_D},
    {"KeyE", "E", SDL_SCANCODE_E},
    {"KeyF", "F", SDL_SCANCODE_F},
    {"KeyG", "G", SDL_SCANCODE_G},
    {"KeyH", "H", SDL_SCANCODE_H},
    {"KeyI", "I", SDL_SCANCODE_I},
    {"KeyJ", "J", SDL_SCANCODE_J},
    {"KeyK", "K", SDL_SCANCODE_K},
    {"KeyL", "L", SDL_SCANCODE_L},
    {"KeyM", "M", SDL_SCANCODE_M},
    {"KeyN", "N", SDL_SCANCODE_N},
    {"KeyO", "O", SDL_SCANCODE_O},
    {"KeyP", "P", SDL_SCANCODE_P},
    {"KeyQ", "Q", SDL_SCANCODE_Q},
    {"KeyR", "R", SDL_SCANCODE_R},
    {"KeyS", "S", SDL_SCANCODE_S},
    {"KeyT", "T", SDL_SCANCODE_T},
    {"KeyU", "U", SDL_SCANCODE_U},
    {"KeyV", "V", SDL_SCANCODE_V},
    {"KeyW", "W", SDL_SCANCODE_W},
    {"KeyX", "X", SDL_SCANCODE_X},
    {"KeyY", "Y", SDL_SCANCODE_Y},
    {"KeyZ", "Z", SDL_SCANCODE_Z},
    {"Digit0", "0", SDL_SCANCODE_0},
    {"Digit1", "1", SDL_SCANCODE_1},
    {"Digit2", "2", SDL_SCANCODE_2},
    {"Digit3", "3", SDL_SCANCODE_3},
    {"Digit4", "4", SDL_SCANCODE_4},
    {"Digit5", "5", SDL_SCANCODE_5},
    {"Digit6", "6", SDL_SCANCODE_6},
    {"Digit7", "7", SDL_SCANCODE_7},
    {"Digit8", "8", SDL_SCANCODE_8},
    {"Digit9", "9", SDL_SCANCODE_9},
    {"F1", "F1", SDL_SCANCODE_F1},
    {"F2", "F2", SDL_SCANCODE_F2},
    {"F3", "F3", SDL_SCANCODE_F3},
    {"F4", "F4", SDL_SCANCODE_F4},
    {"F5", "F5", SDL_SCANCODE_F5},
    {"F6", "F6", SDL_SCANCODE_F6},
    {"F7", "F7", SDL_SCANCODE_F7},
    {"F8", "F8", SDL_SCANCODE_F8},
    {"F9", "F9", SDL_SCANCODE_F9},
    {"F10", "F10", SDL_SCANCODE_F10},
    {"F11", "F11", SDL_SCANCODE_F11},
    {"F12", "F12", SDL_SCANCODE_F12},
    {"ArrowLeft", "Left", SDL_SCANCODE_LEFT},
    {"ArrowRight", "Right", SDL_SCANCODE_RIGHT},
    {"ArrowUp", "Up", SDL_SCANCODE_UP},
    {"ArrowDown", "Down", SDL_SCANCODE_DOWN},
    {"Space", "Space", SDL_SCANCODE_SPACE},
    {"Enter", "Enter", SDL_SCANCODE_RETURN},
    {"Backspace", "Backspace", SDL_SCANCODE_BACKSPACE},
    {"PageUp", "Page Up", SDL_SCANCODE_PAGEUP},
    {"PageDown", "Page Down", SDL_SCANCODE_PAGEDOWN},
    {"Home", "Home", SDL_SCANCODE_HOME},
    {"End", "End", SDL_SCANCODE_END},
    {"Insert", "Ins", SDL_SCANCODE_INSERT},
    {"Delete", "Del", SDL_SCANCODE_DELETE},
    {"ShiftLeft", "Shift", SDL_SCANCODE_LSHIFT},
    {"ShiftRight", "Shift", SDL_SCANCODE_RSHIFT},
    {"ControlLeft", "Ctrl", SDL_SCANCODE_LCTRL},
    {"ControlRight", "Ctrl", SDL_SCANCODE_RCTRL},
    {"CapsLock", "Caps Lock", SDL_SCANCODE_CAPSLOCK},
    {"Equal", "+", SDL_SCANCODE_EQUALS},
    {"Minus", "-", SDL_SCANCODE_MINUS},
    {"BracketLeft", "[", SDL_SCANCODE_LEFTBRACKET},
    {"BracketRight", "]", SDL_SCANCODE_RIGHTBRACKET},
    {"Backslash", "\\", SDL_SCANCODE_BACKSLASH},
    {"IntlBackslash", "<", SDL_SCANCODE_NONUSBACKSLASH},
    {"Semicolon", ";", SDL_SCANCODE_SEMICOLON},
    {"Quote", "'", SDL_SCANCODE_APOSTROPHE},
    {"Backquote", "`", SDL_SCANCODE_GRAVE},
    {"Comma", ",", SDL_SCANCODE_COMMA},
    {"Period", ".", SDL_SCANCODE_PERIOD},
    {"Slash", "/", SDL_SCANCODE_SLASH},
    {"Escape", "Escape", SDL_SCANCODE_ESCAPE},
    {"Numpad0", "Num 0", SDL_SCANCODE_KP_0},
    {"Numpad1", "Num 1", SDL_SCANCODE_KP_1},
    {"Numpad2", "Num 2", SDL_SCANCODE_KP_2},
    {"Numpad3", "Num 3", SDL_SCANCODE_KP_3},
    {"Numpad4", "Num 4", SDL_SCANCODE_KP_4},
    {"Numpad5", "Num 5", SDL_SCANCODE_KP_5},
    {"Numpad6", "Num 6", SDL_SCANCODE_KP_6},
    {"Numpad7", "Num 7", SDL_SCANCODE_KP_7},
    {"Numpad8", "Num 8", SDL_SCANCODE_KP_8},
    {"Numpad9", "Num 9", SDL_SCANCODE_KP_9},
    {"NumpadAdd", "Num +", SDL_SCANCODE_KP_PLUS},
    {"NumpadSubtract", "Num -", SDL_SCANCODE_KP_MINUS},
    {"NumpadMultiply", "Num *", SDL_SCANCODE_KP_MULTIPLY},
    {"NumpadDivide", "Num /", SDL_SCANCODE_KP_DIVIDE},
    {"NumpadDecimal", "Num .", SDL_SCANCODE_KP_PERIOD},
    {"NumpadEnter", "Num Enter", SDL_SCANCODE_KP_ENTER},
});

}  // namespace

std::span<const KeyPosition> allPositions() {
    return kPositions;
}

const KeyPosition* findPosition(std::string_view code) {
    for (const KeyPosition& position : kPositions) {
        if (position.code == code) return &position;
    }
    return nullptr;
}

std::vector<std::string_view> keyCodes() {
    std::vector<std::string_view> codes;
    codes.reserve(kPositions.size());
    for (const KeyPosition& position : kPositions) codes.emplace_back(position.code);
    return codes;
}

}  // namespace slicecast

// The keys of a keyboard, each known by its position, not by the letter printed on it, so W A S D
// are the same four keys on every keyboard. In a page a position is a KeyboardEvent.code, for SDL a
// scancode.
#pragma once

#include <SDL2/SDL_scancode.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

struct KeyPosition {
    const char* code;   // "PageUp"
    const char* label;  // "Page Up", on an American keyboard
    SDL_Scancode scancode;
};

std::span<const KeyPosition> allPositions();

// Null for what is no key, or one that the program cannot have: Tab, those of the system.
const KeyPosition* findPosition(std::string_view code);

// All codes, for messages.
std::vector<std::string_view> keyCodes();

}  // namespace slicecast

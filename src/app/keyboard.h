// The keys of a keyboard. A key is known by its position, not by the letter printed on it, so W A S
// D are the same four keys on every layout. A page names positions by KeyboardEvent.code, SDL by
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
    const char* label;  // "Page Up", as on an American keyboard
    SDL_Scancode scancode;
};

std::span<const KeyPosition> allPositions();

// Null for an unknown code, and for keys that the program cannot use: Tab and those of the system.
const KeyPosition* findPosition(std::string_view code);

// All codes, for messages.
std::vector<std::string_view> keyCodes();

}  // namespace slicecast

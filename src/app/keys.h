// The keys: which key does what, the text that says so, and the keys held down as a step's input.
//
// A key is known by its position (the scancode, in a page KeyboardEvent.code), not by the letter
// printed on it, so W A S D are the same four keys on every keyboard. One table serves the program,
// the help text and the page.
#pragma once

#include "session/input.h"

#include <SDL2/SDL_scancode.h>

#include <array>
#include <span>
#include <string_view>

namespace slicecast {

enum class Action {
    // While held.
    forward,
    back,
    strafeLeft,
    strafeRight,
    turnLeft,
    turnRight,
    lookUp,
    lookDown,
    rise,
    sink,
    jump,
    fast,
    slow,
    use,
    open,
    close,
    // Once for each press.
    levelLook,
    heading,
    fly,
    minimap,
    minimapTurns,
    minimapRays,
    playerPanel,
    processPanel,
    inspector,
    hits,
    grid,
    slowDrawing,
    lightPreset,
    map,
    help,
    rate,
    pause,
    fullscreen,
    cursor,
    record,
    leave,
    // Once for each press, again and again while held.
    intensityUp,
    intensityDown,
    multiplierUp,
    multiplierDown,
    mirrorsUp,
    mirrorsDown,
    minimapLevelDown,
    minimapLevelUp,
    sliceLeft,
    sliceRight,
    slowerSlices,
    fasterSlices,
};
inline constexpr int kHeldActions = static_cast<int>(Action::close) + 1;

constexpr bool isHeld(Action action) {
    return static_cast<int>(action) < kHeldActions;
}
constexpr bool repeats(Action action) {
    return action >= Action::intensityUp;
}

struct Key {
    SDL_Scancode scancode;
    std::string_view code;  // the same key in a page: KeyboardEvent.code
    Action action;
    double headingDegrees = 0.0;  // for Action::heading
    int map = 0;                  // for Action::map, its number
};

// One line of the help: "W S" "walk ahead and back".
struct KeyHelp {
    std::string_view keys;
    std::string_view does;
};

std::span<const Key> allKeys();
std::span<const KeyHelp> keyHelp();

// Null where the key has no meaning.
const Key* findKey(SDL_Scancode scancode);
const Key* findKeyByCode(std::string_view code);

// The held keys. Two keys may stand for one action; it lasts until both are up. A press shorter
// than a step still counts for one.
class HeldKeys {
public:
    void press(const Key& key);
    void release(const Key& key);
    void releaseAll();
    bool isDown(Action action) const;

    // The axes and buttons for the next step; presses that are over by then are forgotten.
    Input takeInput();

private:
    std::array<bool, SDL_NUM_SCANCODES> down_ = {};
    std::array<int, kHeldActions> count_ = {};     // how many keys hold each action
    std::array<bool, kHeldActions> pressed_ = {};  // since the last takeInput
};

}  // namespace slicecast

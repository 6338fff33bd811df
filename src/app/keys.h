// Which key does what, and the keys held down as a step's input.
//
//     KeyBindings keys;                                 the standard keys (app/actions.h)
//     keys.bind("ArrowUp", "forward");                  "" on success; else what was wrong
//     keys.actionOf(SDL_SCANCODE_UP);                   Action::forward
//     keys.help();                                      {{"W", "S", "Up"}, "walk ahead and back"}
#pragma once

#include "app/actions.h"
#include "app/keyboard.h"
#include "slicecast/input.h"

#include <SDL2/SDL_scancode.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

// One line of the help: "W" "S", "walk ahead and back".
struct KeyHelp {
    std::vector<std::string_view> keys;  // labels; none if its actions have no key
    std::string_view does;
    Action first;  // the line's actions
    Action last;
};

class KeyBindings {
public:
    KeyBindings() { reset(); }

    // The standard keys.
    void reset();

    // This key does that, besides the action's other keys, and nothing else any more. Escape stays
    // as it is, and has no second action.
    std::string bind(std::string_view code, std::string_view action);
    // This key does nothing.
    std::string unbind(std::string_view code);
    // From texts such as "forward=ArrowUp" or "forward=ArrowUp+KeyW,fly=KeyJ": those actions have
    // those keys alone. Nothing has changed where the text has a fault.
    std::string read(std::string_view text);

    std::optional<Action> actionOf(SDL_Scancode scancode) const;

    // The keys of an action, in the order of allPositions, from the first one; null behind the
    // last.
    const KeyPosition* keyOf(Action action, int number = 0) const;

    // What all keys do, for people; lines without a key too, so that one can be given to them.
    std::vector<KeyHelp> help() const;

private:
    bool isStandard(Action first, Action last) const;
    std::vector<std::string_view> labels(Action first, Action last) const;
    void set(const KeyPosition& position, Action action);

    std::array<std::uint8_t, SDL_NUM_SCANCODES> actions_{};  // kActions for none
};

// "W S", "A D, Q E" and so on, the names of a line's keys with a space between them.
std::string keysText(const KeyHelp& line);

// The held keys. Two keys may stand for one action; it lasts until both are up. A press shorter
// than a step still counts for one.
class HeldKeys {
public:
    // Nothing for an action that is not held.
    void press(SDL_Scancode scancode, Action action);
    void release(SDL_Scancode scancode);
    void releaseAll();
    bool isDown(Action action) const;

    // The axes and buttons for the next step; presses that are over by then are forgotten.
    Input takeInput();

private:
    std::array<std::uint8_t, SDL_NUM_SCANCODES> down_{};  // 1 + what each key is held for, or 0
    std::array<int, kActions> count_{};                   // how many keys hold each action
    std::array<bool, kActions> pressed_{};                // since the last takeInput
};

}  // namespace slicecast

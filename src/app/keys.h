// Which key triggers which action, and the held keys as the input of a step.
//
//     KeyBindings keys;                                 the standard keys (app/actions.h)
//     keys.bind("ArrowUp", "forward");                  "" on success, else a message
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
    Action first;  // the line is about all actions from `first` to `last`
    Action last;
};

class KeyBindings {
public:
    KeyBindings() { reset(); }

    // Restores the standard keys.
    void reset();

    // Binds a key (a KeyboardEvent.code) to an action by its name. The action keeps its other keys,
    // and the key loses its old action. Escape keeps its own action. Like the next two, returns ""
    // on success, else a message.
    std::string bind(std::string_view code, std::string_view action);
    // Leaves the key without an action.
    std::string unbind(std::string_view code);
    // Reads texts such as "forward=ArrowUp" or "forward=ArrowUp+KeyW,fly=KeyJ": each named action
    // has only those keys afterwards. Changes nothing if the text has an error.
    std::string read(std::string_view text);

    std::optional<Action> actionOf(SDL_Scancode scancode) const;

    // One of the keys of an action: number 0 is the first in the order of allPositions. Null if the
    // action has fewer keys.
    const KeyPosition* keyOf(Action action, int number = 0) const;

    // The help text of all keys. Includes lines without a key, so that a user can bind one.
    std::vector<KeyHelp> help() const;

private:
    bool isStandard(Action first, Action last) const;
    std::vector<std::string_view> labels(Action first, Action last) const;
    void set(const KeyPosition& position, Action action);

    std::array<std::uint8_t, SDL_NUM_SCANCODES> actions_{};  // kActions for none
};

// The labels of a line's keys, separated by spaces: "W S", "A D Q E".
std::string keysText(const KeyHelp& line);

// The held keys. An action with two keys lasts until both are up. A press shorter than a step still
// counts for one step.
class HeldKeys {
public:
    // Ignores actions that do not act while held.
    void press(SDL_Scancode scancode, Action action);
    void release(SDL_Scancode scancode);
    void releaseAll();
    bool isDown(Action action) const;

    // The axes and buttons for the next step. Forgets presses that have ended.
    Input takeInput();

private:
    std::array<std::uint8_t, SDL_NUM_SCANCODES> down_{};  // 1 + the action that the key holds, or 0
    std::array<int, kActions> count_{};                   // how many keys hold each action
    std::array<bool, kActions> pressed_{};                // since the last takeInput
};

}  // namespace slicecast

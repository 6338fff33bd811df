// All actions that keys can trigger: one table, a row for each action. The keys, the help, the
// settings of a page, the table in web/docs/play.md and the values of `<ray-caster keys="move">`
// follow from it.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace slicecast {

// In the order of the table and of the help.
enum class Action {
    forward,
    back,
    strafeLeft,
    strafeRight,
    jump,
    sink,
    rise,
    fast,
    slow,
    fly,
    turnLeft,
    turnRight,
    lookUp,
    lookDown,
    mouse,  // no key: only a line of the help
    cursor,
    levelLook,
    faceEast,  // then clockwise in steps of 45 degrees
    faceSouthEast,
    faceSouth,
    faceSouthWest,
    faceWest,
    faceNorthWest,
    faceNorth,
    faceNorthEast,
    use,
    open,
    close,
    intensityUp,
    intensityDown,
    multiplierUp,
    multiplierDown,
    mirrorsUp,
    mirrorsDown,
    lightPreset,
    minimap,
    minimapTurns,
    minimapRays,
    minimapLevelDown,
    minimapLevelUp,
    playerPanel,
    processPanel,
    inspector,
    sliceLeft,
    sliceRight,
    hits,
    grid,
    slowDrawing,
    slowerSlices,
    fasterSlices,
    map0,
    map1,
    map2,
    map3,
    map4,
    map5,
    map6,
    map7,
    map8,
    map9,
    help,
    rate,
    pause,
    sound,
    fullscreen,
    record,
    leave,
};
inline constexpr int kActions = static_cast<int>(Action::leave) + 1;

enum class ActionGroup : unsigned char { move, look, gates, light, show, program };

// When it acts: while its key is held; once for each press; or repeatedly while held.
enum class Press : unsigned char { hold, once, repeat };

// Where its keys are active. Each scope includes the ones before it.
enum class KeyScope : unsigned char {
    move,     // <ray-caster keys="move">: moving, looking, gates
    element,  // <ray-caster>
    page,     // a page that shows only the picture, and the program in a window
};

struct ActionInfo {
    Action action;
    const char* name;  // as bindKey takes it
    ActionGroup group;
    Press press;
    KeyScope scope;
    const char* codes;  // its standard keys as KeyboardEvent.code, separated by spaces
    const char* does;   // help for this action alone: "walk ahead"
    // The line of the help that begins here: its text ("" for `does`, null if the action belongs to
    // the line above), and a shorter name for its standard keys or null.
    const char* line = "";
    const char* lineKeys = nullptr;
    // An option that it changes: toggles it, selects the next choice, or adds `by` to a number.
    const char* option = nullptr;
    double by = 0.0;
};

std::span<const ActionInfo> allActions();
const ActionInfo& infoOf(Action action);

// True for what the program in a window cannot do: it has no sound.
constexpr bool isOfPagesOnly(Action action) {
    return action == Action::sound;
}

// Empty if no action has this name.
std::optional<Action> findAction(std::string_view name);
// All actions that can have keys.
std::vector<std::string_view> actionNames();

const char* groupName(ActionGroup group);
const char* pressName(Press press);
const char* scopeName(KeyScope scope);

}  // namespace slicecast

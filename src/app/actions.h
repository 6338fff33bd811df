// What keys can do: one table, a row for each action. The keys, the help, the settings of a page,
// the table in web/docs/play.md and what `<ray-caster keys="move">` takes all follow from it.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace slicecast {

// In the order of the table, which is that of the help.
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
    mouse,  // no key: a line of the help
    cursor,
    levelLook,
    faceEast,  // and clockwise, 45 degrees from one to the next
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
    fullscreen,
    record,
    leave,
};
inline constexpr int kActions = static_cast<int>(Action::leave) + 1;

enum class ActionGroup : unsigned char { move, look, gates, light, show, program };

// When it acts: while its key is held; once for each press; or again and again while held.
enum class Press : unsigned char { hold, once, repeat };

// Who has a use for its keys. Each of these has those before it, too.
enum class KeyScope : unsigned char {
    move,     // <ray-caster keys="move">: moving, looking, gates
    element,  // <ray-caster>
    page,     // a page that is all about the picture, and the program in a window
};

struct ActionInfo {
    Action action;
    const char* name;  // as bindKey takes it
    ActionGroup group;
    Press press;
    KeyScope scope;
    const char* codes;  // its standard keys, as KeyboardEvent.code, with a space between them
    const char* does;   // of this action alone: "walk ahead"
    // The line of the help that begins here: what it says ("" for `does`, null where the action
    // stands on the line above) and, if not null, a shorter name for its standard keys.
    const char* line = "";
    const char* lineKeys = nullptr;
    // An option that it changes: on and off, to the next word of a choice, or a number by so much.
    const char* option = nullptr;
    double by = 0.0;
};

std::span<const ActionInfo> allActions();
const ActionInfo& infoOf(Action action);

// Empty for a name that no action has.
std::optional<Action> findAction(std::string_view name);
// Of the actions that can have keys.
std::vector<std::string_view> actionNames();

const char* groupName(ActionGroup group);
const char* pressName(Press press);
const char* scopeName(KeyScope scope);

}  // namespace slicecast

#include "app/actions.h"

#include "base/named.h"

#include <array>
#include <cstddef>

namespace slicecast {

namespace {

using enum ActionGroup;
using enum Press;

constexpr double kIntensityStep = 0.1;
constexpr double kMultiplierStep = 0.5;  // units
constexpr double kMirrorsStep = 0.1;

constexpr KeyScope kMove = KeyScope::move;
constexpr KeyScope kElement = KeyScope::element;
constexpr KeyScope kPage = KeyScope::page;
constexpr const char* kJoins = nullptr;  // belongs to the line above

constexpr auto kRows = std::to_array<ActionInfo>({
    {Action::forward, "forward", move, hold, kMove, "KeyW", "walk ahead", "walk ahead and back"},
    {Action::back, "back", move, hold, kMove, "KeyS", "walk back", kJoins},
    {Action::strafeLeft, "strafeLeft", move, hold, kMove, "KeyA KeyQ", "step left",
     "step left and right"},
    {Action::strafeRight, "strafeRight", move, hold, kMove, "KeyD KeyE", "step right", kJoins},
    {Action::jump, "jump", move, hold, kMove, "Space", "jump; rise when flying"},
    {Action::sink, "sink", move, hold, kMove, "KeyC PageDown", "crouch; sink when flying"},
    {Action::rise, "rise", move, hold, kMove, "PageUp", "rise when flying"},
    {Action::fast, "fast", move, hold, kMove, "ShiftLeft ShiftRight", "faster", "faster, slower"},
    {Action::slow, "slow", move, hold, kMove, "ControlLeft ControlRight", "slower", kJoins},
    {Action::fly, "fly", move, once, kMove, "KeyV", "fly or walk"},

    {Action::turnLeft, "turnLeft", look, hold, kMove, "ArrowLeft", "turn left",
     "turn, look up and down", "Arrows"},
    {Action::turnRight, "turnRight", look, hold, kMove, "ArrowRight", "turn right", kJoins},
    {Action::lookUp, "lookUp", look, hold, kMove, "ArrowUp", "look up", kJoins},
    {Action::lookDown, "lookDown", look, hold, kMove, "ArrowDown", "look down", kJoins},
    {Action::mouse, "", look, once, kMove, "", "look with the mouse", "", "Click"},
    {Action::cursor, "cursor", look, once, kMove, "KeyN",
     "steer by the mouse's place in the picture"},
    {Action::levelLook, "levelLook", look, once, kMove, "KeyR", "look straight ahead"},
    {Action::faceEast, "faceEast", look, once, kMove, "Numpad6", "face east",
     "face east (6), south (2), west (4), north (8) or between", "Number pad"},
    {Action::faceSouthEast, "faceSouthEast", look, once, kMove, "Numpad3", "face south-east",
     kJoins},
    {Action::faceSouth, "faceSouth", look, once, kMove, "Numpad2", "face south", kJoins},
    {Action::faceSouthWest, "faceSouthWest", look, once, kMove, "Numpad1", "face south-west",
     kJoins},
    {Action::faceWest, "faceWest", look, once, kMove, "Numpad4", "face west", kJoins},
    {Action::faceNorthWest, "faceNorthWest", look, once, kMove, "Numpad7", "face north-west",
     kJoins},
    {Action::faceNorth, "faceNorth", look, once, kMove, "Numpad8", "face north", kJoins},
    {Action::faceNorthEast, "faceNorthEast", look, once, kMove, "Numpad9", "face north-east",
     kJoins},

    {Action::use, "use", gates, hold, kMove, "KeyX", "open or close the gates nearby"},
    {Action::open, "open", gates, hold, kMove, "Period", "open the gates nearby",
     "open gates; close gates"},
    {Action::close, "close", gates, hold, kMove, "Comma", "close the gates nearby", kJoins},

    {Action::intensityUp, "intensityUp", light, repeat, kElement, "Insert", "brighter nearby",
     "brighter and darker nearby", nullptr, "intensity", kIntensityStep},
    {Action::intensityDown, "intensityDown", light, repeat, kElement, "Delete", "darker nearby",
     kJoins, nullptr, "intensity", -kIntensityStep},
    {Action::multiplierUp, "multiplierUp", light, repeat, kElement, "Home", "brighter far away",
     "brighter and darker far away", nullptr, "multiplier", kMultiplierStep},
    {Action::multiplierDown, "multiplierDown", light, repeat, kElement, "End", "darker far away",
     kJoins, nullptr, "multiplier", -kMultiplierStep},
    {Action::mirrorsUp, "mirrorsUp", light, repeat, kElement, "Equal NumpadAdd", "stronger mirrors",
     "stronger and weaker mirrors", nullptr, "mirrors", kMirrorsStep},
    {Action::mirrorsDown, "mirrorsDown", light, repeat, kElement, "Minus NumpadSubtract",
     "weaker mirrors", kJoins, nullptr, "mirrors", -kMirrorsStep},
    {Action::lightPreset, "lightPreset", light, once, kElement, "KeyL",
     "day, dusk, night, fog, or the scene's own", "", nullptr, "lightPreset"},

    {Action::minimap, "minimap", show, once, kElement, "KeyM", "minimap",
     "minimap; turn it; show its rays", nullptr, "minimap"},
    {Action::minimapTurns, "minimapTurns", show, once, kElement, "KeyB", "the minimap turns",
     kJoins, nullptr, "minimapTurns"},
    {Action::minimapRays, "minimapRays", show, once, kElement, "KeyO", "rays on the minimap",
     kJoins, nullptr, "minimapRays"},
    {Action::minimapLevelDown, "minimapLevelDown", show, repeat, kElement, "BracketLeft",
     "minimap of a lower level", "minimap of a lower or higher level"},
    {Action::minimapLevelUp, "minimapLevelUp", show, repeat, kElement, "BracketRight",
     "minimap of a higher level", kJoins},
    {Action::playerPanel, "playerPanel", show, once, kElement, "KeyJ", "your position",
     "your position; drawing times", nullptr, "playerPanel"},
    {Action::processPanel, "processPanel", show, once, kElement, "KeyU", "drawing times", kJoins,
     nullptr, "processPanel"},
    {Action::inspector, "inspector", show, once, kElement, "KeyG", "inspect a slice",
     "inspect a slice; move left, right", nullptr, "inspector"},
    {Action::sliceLeft, "sliceLeft", show, repeat, kElement, "F1", "inspect a slice further left",
     kJoins},
    {Action::sliceRight, "sliceRight", show, repeat, kElement, "F2",
     "inspect a slice further right", kJoins},
    {Action::hits, "hits", show, once, kPage, "KeyT", "list that slice's hits as text"},
    {Action::grid, "grid", show, once, kElement, "KeyK", "grid of pixels", "", nullptr, "grid"},
    {Action::slowDrawing, "slowDrawing", show, once, kElement, "KeyY", "draw slice by slice",
     "draw slice by slice; slower, faster", nullptr, "slow"},
    {Action::slowerSlices, "slowerSlices", show, repeat, kElement, "F3", "slices come slower",
     kJoins, nullptr, "slowSlices", -1.0},
    {Action::fasterSlices, "fasterSlices", show, repeat, kElement, "F4", "slices come faster",
     kJoins, nullptr, "slowSlices", 1.0},

    {Action::map0, "map0", program, once, kElement, "Digit0", "go to map 0",
     "go to another map of the scene", "0-9"},
    {Action::map1, "map1", program, once, kElement, "Digit1", "go to map 1", kJoins},
    {Action::map2, "map2", program, once, kElement, "Digit2", "go to map 2", kJoins},
    {Action::map3, "map3", program, once, kElement, "Digit3", "go to map 3", kJoins},
    {Action::map4, "map4", program, once, kElement, "Digit4", "go to map 4", kJoins},
    {Action::map5, "map5", program, once, kElement, "Digit5", "go to map 5", kJoins},
    {Action::map6, "map6", program, once, kElement, "Digit6", "go to map 6", kJoins},
    {Action::map7, "map7", program, once, kElement, "Digit7", "go to map 7", kJoins},
    {Action::map8, "map8", program, once, kElement, "Digit8", "go to map 8", kJoins},
    {Action::map9, "map9", program, once, kElement, "Digit9", "go to map 9", kJoins},
    {Action::help, "help", program, once, kElement, "KeyH", "these keys"},
    {Action::rate, "rate", program, once, kPage, "KeyI", "frame rate"},
    {Action::pause, "pause", program, once, kElement, "KeyP", "pause"},
    {Action::sound, "sound", program, once, kElement, "Semicolon", "sound on or off"},
    {Action::fullscreen, "fullscreen", program, once, kElement, "KeyF", "full screen"},
    {Action::record, "record", program, once, kPage, "F9",
     "record from the start; press again to save"},
    {Action::leave, "leave", program, once, kElement, "Escape", "release the mouse, then leave"},
});
static_assert([] {
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        if (kRows[i].action != static_cast<Action>(i)) return false;
    }
    return kRows.size() == kActions;
}());

constexpr Named<ActionGroup> kGroups[] = {{move, "move"},   {look, "look"}, {gates, "gates"},
                                          {light, "light"}, {show, "show"}, {program, "program"}};
constexpr Named<Press> kPresses[] = {{hold, "hold"}, {once, "press"}, {repeat, "repeat"}};
constexpr Named<KeyScope> kScopes[] = {{kMove, "move"}, {kElement, "element"}, {kPage, "page"}};

}  // namespace

std::span<const ActionInfo> allActions() {
    return kRows;
}

const ActionInfo& infoOf(Action action) {
    return kRows[static_cast<std::size_t>(action)];
}

std::optional<Action> findAction(std::string_view name) {
    for (const ActionInfo& row : kRows) {
        if (!name.empty() && name == row.name) return row.action;
    }
    return std::nullopt;
}

std::vector<std::string_view> actionNames() {
    std::vector<std::string_view> names;
    for (const ActionInfo& row : kRows) {
        if (*row.name != '\0') names.emplace_back(row.name);
    }
    return names;
}

const char* groupName(ActionGroup group) {
    return nameOf(kGroups, group);
}

const char* pressName(Press press) {
    return nameOf(kPresses, press);
}

const char* scopeName(KeyScope scope) {
    return nameOf(kScopes, scope);
}

}  // namespace slicecast

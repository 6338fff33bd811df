#include "app/actions.h"

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
    {"forward", move, hold, kMove, "KeyW", "walk ahead", "walk ahead and back"},
    {"back", move, hold, kMove, "KeyS", "walk back", kJoins},
    {"strafeLeft", move, hold, kMove, "KeyA KeyQ", "step left", "step left and right"},
    {"strafeRight", move, hold, kMove, "KeyD KeyE", "step right", kJoins},
    {"jump", move, hold, kMove, "Space", "jump"},
    {"sink", move, hold, kMove, "KeyC PageDown", "crouch; sink when flying"},
    {"rise", move, hold, kMove, "PageUp", "rise when flying"},
    {"fast", move, hold, kMove, "ShiftLeft ShiftRight", "faster", "faster, slower"},
    {"slow", move, hold, kMove, "ControlLeft ControlRight", "slower", kJoins},
    {"fly", move, once, kMove, "KeyV", "fly or walk"},

    {"turnLeft", look, hold, kMove, "ArrowLeft", "turn left", "turn, look up and down", "Arrows"},
    {"turnRight", look, hold, kMove, "ArrowRight", "turn right", kJoins},
    {"lookUp", look, hold, kMove, "ArrowUp", "look up", kJoins},
    {"lookDown", look, hold, kMove, "ArrowDown", "look down", kJoins},
    {"", look, once, kMove, "", "look with the mouse", "", "Click"},
    {"cursor", look, once, kMove, "KeyN", "steer by the mouse's place in the picture"},
    {"levelLook", look, once, kMove, "KeyR", "look straight ahead"},
    {"faceEast", look, once, kMove, "Numpad6", "face east",
     "face east (6), south (2), west (4), north (8) or between", "Number pad"},
    {"faceSouthEast", look, once, kMove, "Numpad3", "face south-east", kJoins},
    {"faceSouth", look, once, kMove, "Numpad2", "face south", kJoins},
    {"faceSouthWest", look, once, kMove, "Numpad1", "face south-west", kJoins},
    {"faceWest", look, once, kMove, "Numpad4", "face west", kJoins},
    {"faceNorthWest", look, once, kMove, "Numpad7", "face north-west", kJoins},
    {"faceNorth", look, once, kMove, "Numpad8", "face north", kJoins},
    {"faceNorthEast", look, once, kMove, "Numpad9", "face north-east", kJoins},

    {"use", gates, hold, kMove, "KeyX", "open or close the gates nearby"},
    {"open", gates, hold, kMove, "Period", "open the gates nearby", "open gates; close gates"},
    {"close", gates, hold, kMove, "Comma", "close the gates nearby", kJoins},

    {"intensityUp", light, repeat, kElement, "Insert", "brighter nearby",
     "brighter and darker nearby", nullptr, "intensity", kIntensityStep},
    {"intensityDown", light, repeat, kElement, "Delete", "darker nearby", kJoins, nullptr,
     "intensity", -kIntensityStep},
    {"multiplierUp", light, repeat, kElement, "Home", "brighter far away",
     "brighter and darker far away", nullptr, "multiplier", kMultiplierStep},
    {"multiplierDown", light, repeat, kElement, "End", "darker far away", kJoins, nullptr,
     "multiplier", -kMultiplierStep},
    {"mirrorsUp", light, repeat, kElement, "Equal NumpadAdd", "stronger mirrors",
     "stronger and weaker mirrors", nullptr, "mirrors", kMirrorsStep},
    {"mirrorsDown", light, repeat, kElement, "Minus NumpadSubtract", "weaker mirrors", kJoins,
     nullptr, "mirrors", -kMirrorsStep},
    {"lightPreset", light, once, kElement, "KeyL", "day, dusk, night, fog, or the scene's own", "",
     nullptr, "lightPreset"},

    {"minimap", show, once, kElement, "KeyM", "minimap", "minimap; turn it; show its rays", nullptr,
     "minimap"},
    {"minimapTurns", show, once, kElement, "KeyB", "the minimap turns", kJoins, nullptr,
     "minimapTurns"},
    {"minimapRays", show, once, kElement, "KeyO", "rays on the minimap", kJoins, nullptr,
     "minimapRays"},
    {"minimapLevelDown", show, repeat, kElement, "BracketLeft", "minimap of a lower level",
     "minimap of a lower or higher level"},
    {"minimapLevelUp", show, repeat, kElement, "BracketRight", "minimap of a higher level", kJoins},
    {"playerPanel", show, once, kElement, "KeyJ", "your position", "your position; drawing times",
     nullptr, "playerPanel"},
    {"processPanel", show, once, kElement, "KeyU", "drawing times", kJoins, nullptr,
     "processPanel"},
    {"inspector", show, once, kElement, "KeyG", "inspect a slice",
     "inspect a slice; move left, right", nullptr, "inspector"},
    {"sliceLeft", show, repeat, kElement, "F1", "inspect a slice further left", kJoins},
    {"sliceRight", show, repeat, kElement, "F2", "inspect a slice further right", kJoins},
    {"hits", show, once, kPage, "KeyT", "list that slice's hits as text"},
    {"grid", show, once, kElement, "KeyK", "grid of pixels", "", nullptr, "grid"},
    {"slowDrawing", show, once, kElement, "KeyY", "draw slice by slice",
     "draw slice by slice; slower, faster", nullptr, "slow"},
    {"slowerSlices", show, repeat, kElement, "F3", "slices come slower", kJoins, nullptr,
     "slowSlices", -1.0},
    {"fasterSlices", show, repeat, kElement, "F4", "slices come faster", kJoins, nullptr,
     "slowSlices", 1.0},

    {"map0", program, once, kElement, "Digit0", "go to map 0", "go to another map of the scene",
     "0-9"},
    {"map1", program, once, kElement, "Digit1", "go to map 1", kJoins},
    {"map2", program, once, kElement, "Digit2", "go to map 2", kJoins},
    {"map3", program, once, kElement, "Digit3", "go to map 3", kJoins},
    {"map4", program, once, kElement, "Digit4", "go to map 4", kJoins},
    {"map5", program, once, kElement, "Digit5", "go to map 5", kJoins},
    {"map6", program, once, kElement, "Digit6", "go to map 6", kJoins},
    {"map7", program, once, kElement, "Digit7", "go to map 7", kJoins},
    {"map8", program, once, kElement, "Digit8", "go to map 8", kJoins},
    {"map9", program, once, kElement, "Digit9", "go to map 9", kJoins},
    {"help", program, once, kElement, "KeyH", "these keys"},
    {"rate", program, once, kPage, "KeyI", "frame rate"},
    {"pause", program, once, kElement, "KeyP", "pause"},
    {"fullscreen", program, once, kElement, "KeyF", "full screen"},
    {"record", program, once, kPage, "F9", "record from the start; press again to save"},
    {"leave", program, once, kElement, "Escape", "release the mouse, then leave"},
});
static_assert(kRows.size() == kActions);

}  // namespace

std::span<const ActionInfo> allActions() {
    return kRows;
}

const ActionInfo& infoOf(Action action) {
    return kRows[static_cast<std::size_t>(action)];
}

std::optional<Action> findAction(std::string_view name) {
    for (int i = 0; i < kActions; ++i) {
        if (!name.empty() && name == kRows[static_cast<std::size_t>(i)].name)
            return static_cast<Action>(i);
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
    constexpr auto kNames =
        std::to_array<const char*>({"move", "look", "gates", "light", "show", "program"});
    return kNames[static_cast<std::size_t>(group)];
}

const char* pressName(Press press) {
    constexpr auto kNames = std::to_array<const char*>({"hold", "press", "repeat"});
    return kNames[static_cast<std::size_t>(press)];
}

const char* scopeName(KeyScope scope) {
    constexpr auto kNames = std::to_array<const char*>({"move", "element", "page"});
    return kNames[static_cast<std::size_t>(scope)];
}

}  // namespace slicecast

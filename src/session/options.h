// Everything about a running game that can be set by name: on a command line ("--set fov=75"), in a
// page's settings, by a key. One table holds the name, the kind, the range, the default and the
// description of each.
#pragma once

#include "render/classic/classic_options.h"
#include "render/options.h"
#include "session/light_presets.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace slicecast {

// Who makes the pictures.
enum class DrawMethod : std::uint8_t {
    exact,    // the fast renderer
    classic,  // the slow one for lessons, by the old ways that ClassicOptions names
};

inline constexpr double kGreatestMirrors =
    4.0;  // times the strength that a scene gives its mirrors

struct SessionOptions {
    RenderOptions render;
    DrawMethod method = DrawMethod::exact;
    ClassicOptions classic;
    double compare = 0.0;  // the columns left of this share of the width are drawn by the classic
                           // method, the others by the exact one; 0 for no comparison
    std::optional<double> intensity;   // of the light, in all maps; each map's own when empty
    std::optional<double> multiplier;  // of the light, units; each map's own when empty
    LightPreset lightPreset = LightPreset::map;
    std::optional<Colour> hazeColour;  // of the fog and the far floor; each map's own when empty
    bool minimap = false;
    int minimapLevel = -1;  // the level shown; -1 for the eye's
    bool minimapRays = false;
    bool minimapTurns = false;  // with the way that the player looks up; else north
    double minimapReach = 2.0;  // radius of the circle about the player, units; 0 for none
    bool playerPanel = false;
    bool processPanel = false;
    bool inspector = false;    // the line of one slice, and that slice from the side
    int inspectorColumn = -1;  // which slice; -1 for the middle one
    bool grid = false;         // over the picture, in pixels
    bool slow = false;         // the picture builds up slice by slice
    int slowSlices = 1;     // so many more with each picture; one every n pictures where it is -n
    int drawnColumns = -1;  // so many slices of the picture are drawn; -1 for all
    double speed = 1.0;     // multiplies the player's moving speeds
    bool bob = true;        // a swimmer's eye goes up and down with the water
};

enum class OptionKind {
    onOff,        // "on" or "off"
    number,       // within least and greatest
    wholeNumber,  // the same, without a fraction
    ownOrNumber,  // "map" for each map's own value, or a number
    choice,       // one of some words
    ownOrColour,  // "map" for each map's own value, or a colour as "#rrggbb"
};

struct OptionInfo {
    const char* name;
    const char* label;  // for a settings dialog
    const char* group;  // "view", "light", "overlays", "moving" or "classic"
    OptionKind kind;
    double least;  // of numbers
    double greatest;
    const char* standard;  // the default, as it would be given
    const char* description;
    const char* choices = "";  // the words of a choice, with a space between them
};

// All options, in the order in which to list them.
std::span<const OptionInfo> knownOptions();
// Null for an unknown name.
const OptionInfo* findOption(std::string_view name);

// Sets one option. An empty string on success; else what is wrong, and nothing has changed:
// "Unknown option 'fvo'. Did you mean 'fov'?"
std::string setOption(SessionOptions& options, std::string_view name, std::string_view value);

// The same for an option that is a number, which is brought into its range.
void setOption(SessionOptions& options, std::string_view name, double number);

// The word after `value` among those of a choice, the first one after the last; empty if there is
// no such choice or word.
std::string nextChoice(std::string_view name, std::string_view value);

// The value as setOption would take it; empty for an unknown name.
std::string optionValue(const SessionOptions& options, std::string_view name);

// Of an option that is a number; 0 for any other, and where each map has its own.
double optionNumber(const SessionOptions& options, std::string_view name);

// Whether anything is drawn over the picture, or not all of it: an option of the group "overlays"
// is on.
bool showsOverlay(const SessionOptions& options);

}  // namespace slicecast

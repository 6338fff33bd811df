// The options of a running game, set by name: on a command line ("--set fov=75"), in a page's
// settings, or by a key. One table holds the name, kind, range, default and description of each.
#pragma once

#include "classic/classic_options.h"
#include "render/options.h"
#include "session/light_presets.h"
#include "slicecast/option.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace slicecast {

// The renderer that draws the pictures.
enum class DrawMethod : std::uint8_t {
    exact,    // the fast renderer
    classic,  // the slow one for lessons, with the defects of ClassicOptions
};

// Multiplies the strength that a scene gives its mirrors.
inline constexpr double kGreatestMirrors = 4.0;

struct SessionOptions {
    RenderOptions render;
    DrawMethod method = DrawMethod::exact;
    ClassicOptions classic;
    double compare = 0.0;  // share of the width, from the left, that the classic method draws while
                           // the exact one draws the rest; 0 for no comparison
    bool wideFov = false;  // in wider pictures than 16:10 `fov` is the angle of a picture with
                           // these sides and the same height, so that more is seen at both sides
    std::optional<double> intensity;   // of the light in all maps; empty: each map's own
    std::optional<double> multiplier;  // of the light, units; empty: each map's own
    LightPreset lightPreset = LightPreset::map;
    std::optional<Colour> hazeColour;  // of the fog and the far floor; empty: each map's own
    bool minimap = false;
    int minimapLevel = -1;  // the level shown; -1 for the player's
    bool minimapRays = false;
    bool minimapTurns = false;  // the player's heading is up; else north is up
    double minimapReach = 2.0;  // radius of the circle around the player, units; 0 for none
    bool playerPanel = false;
    bool processPanel = false;
    bool inspector = false;    // marks one slice, and shows it from the side
    int inspectorColumn = -1;  // which slice; -1 for the middle one
    double overlayTop = 0.0;   // shares of the picture's height that panels and map keep free
    double overlayBottom = 0.0;
    bool grid = false;      // over the picture, in pixels
    bool slow = false;      // the picture builds up slice by slice
    int slowSlices = 1;     // slices added with each picture; -n adds one every n pictures
    int drawnColumns = -1;  // slices drawn, from the left; -1 for all
    double speed = 1.0;     // multiplies the player's moving speeds
    bool bob = true;        // a swimmer's eye bobs with the water
};

// All options, in the order of a list.
std::span<const OptionInfo> knownOptions();
// Null for an unknown name.
const OptionInfo* findOption(std::string_view name);

// Sets one option. Returns an empty text on success, else changes nothing and returns a message:
// "Unknown option 'fvo'. Did you mean 'fov'?"
std::string setOption(SessionOptions& options, std::string_view name, std::string_view value);

// The same for an option that is a number. Clamps the number to the option's range. Does nothing
// for NaN and for any other name.
void setOption(SessionOptions& options, std::string_view name, double number);

// How a picture of this size is drawn.
RenderOptions renderOptions(const SessionOptions& options, int width, int height);

// The word that follows `value` in a choice; the first one after the last. Empty for an unknown
// option or word.
std::string nextChoice(std::string_view name, std::string_view value);

// The value in the form that setOption takes; empty for an unknown name.
std::string optionValue(const SessionOptions& options, std::string_view name);

// The number of a numeric option; 0 for any other, and where each map has its own.
double optionNumber(const SessionOptions& options, std::string_view name);

// Whether an option of the group "overlays" is on: something is drawn over the picture, or only
// part of the picture is drawn.
bool showsOverlay(const SessionOptions& options);

}  // namespace slicecast

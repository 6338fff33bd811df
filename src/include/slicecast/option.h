// An option of a running game: its name and what it takes. Game::options() lists all of them.
#pragma once

#include <cstdint>

namespace slicecast {

enum class OptionKind : std::uint8_t {
    onOff,        // "on" or "off"
    number,       // from least to greatest
    wholeNumber,  // the same, without a fraction
    ownOrNumber,  // "map" for each map's own value, or a number
    choice,       // one word of a list
    ownOrColour,  // "map" for each map's own value, or a colour as "#rrggbb"
};

struct OptionInfo {
    const char* name;
    const char* label;  // for a settings dialog
    const char* group;  // "view", "light", "overlays", "moving" or "classic"
    OptionKind kind;
    double least;  // of numbers
    double greatest;
    const char* standard;  // the default, as Game::setOption takes it
    const char* description;
    const char* choices = "";  // the words of a choice, separated by spaces
};

}  // namespace slicecast

// The command line of the program in a window.
#pragma once

#ifndef __EMSCRIPTEN__

#include "app/window_shell.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {

struct Arguments {
    std::string scene;  // empty: the opening scene
    std::string map;    // empty: where the scene starts
    WindowSettings window;
    std::vector<std::pair<std::string, std::string>> options;  // name and value
};

// The arguments, or the exit status where there is nothing to play (help, a fault; both have been printed).
struct ReadArguments {
    std::optional<Arguments> arguments;
    int exitStatus = 0;
};

ReadArguments readArguments(int argc, char** argv);

}  // namespace slicecast

#endif

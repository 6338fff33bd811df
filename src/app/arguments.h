// The command line of the program in a window.
#pragma once

#ifndef __EMSCRIPTEN__

#include "app/keys.h"
#include "app/thread_crew.h"
#include "app/window_shell.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {

struct Arguments {
    std::string scene;   // empty: the opening scene, or that of the replay
    std::string map;     // empty: where the scene starts
    std::string record;  // file to write what is played to; empty: none
    std::string replay;  // recording to play; empty: none
    WindowSettings window;
    int threads = threadsOfMachine();  // that draw a picture
    KeyBindings keys;
    std::vector<std::pair<std::string, std::string>> options;  // name and value
};

// The arguments, or the exit status where there is nothing to play (help, a fault; both have been
// printed).
struct ReadArguments {
    std::optional<Arguments> arguments;
    int exitStatus = 0;
};

ReadArguments readArguments(int argc, char** argv);

}  // namespace slicecast

#endif

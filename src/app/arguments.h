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
    std::string scene;   // empty: the opening scene, or the replay's
    std::string map;     // empty: the map where the scene starts
    std::string record;  // file for the recording; empty: none
    std::string replay;  // recording to play; empty: none
    WindowSettings window;
    int threads = threadsOfMachine();  // threads that draw one picture
    KeyBindings keys;
    std::vector<std::pair<std::string, std::string>> options;  // name and value
};

// The arguments, or the exit status if there is nothing to play (help or an error, already
// printed).
struct ReadArguments {
    std::optional<Arguments> arguments;
    int exitStatus = 0;
};

ReadArguments readArguments(int argc, char** argv);

}  // namespace slicecast

#endif

// Named settings of the classic method, as a person would ask for them, and what it cannot show.
#pragma once

#include "session/options.h"
#include "world/world.h"

#include <span>
#include <string>
#include <vector>

namespace slicecast {

struct OldWay {
    const char* name;
    const char* description;  // a sentence: what is seen, and why
    const char* options;      // "classic.march=on classic.step=0.2"; others as they are by default
};

// In the order in which to list them. Every option of the classic method is in one of them.
std::span<const OldWay> knownOldWays();

// What of a world the present method leaves out of the picture, a sentence each. None for the exact
// one.
std::vector<std::string> leftOut(const World& world, const SessionOptions& options);

}  // namespace slicecast

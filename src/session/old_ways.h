// Named settings of the classic method, each with the defect that it shows, and what that method
// cannot draw.
#pragma once

#include "session/options.h"
#include "world/world.h"

#include <span>
#include <string>
#include <vector>

namespace slicecast {

struct OldWay {
    const char* name;
    const char* description;  // one sentence: what one sees, and why
    const char* options;      // "classic.march=on classic.step=0.2"; all others keep their defaults
};

// In the order of a list. Each option of the classic method occurs in at least one of them.
std::span<const OldWay> knownOldWays();

// The features of a world that the present method does not draw, a sentence each. Empty for the
// exact method.
std::vector<std::string> leftOut(const World& world, const SessionOptions& options);

}  // namespace slicecast

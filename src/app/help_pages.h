// The keys as texts for panels on the picture: one page if all fit, else as many readable pages as
// needed, which the same key shows in turn.
#pragma once

#ifndef __EMSCRIPTEN__

#include "app/fit.h"
#include "app/keys.h"

#include <string>
#include <vector>

namespace slicecast {

// Each page fits a picture of that size unless a single word is too wide. Omits lines without a
// key.
std::vector<std::string> helpPages(const KeyBindings& keys, Size picture);

}  // namespace slicecast

#endif

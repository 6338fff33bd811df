// The keys as texts for panels on the picture: one if it has room for all, else as many pages of
// readable size as it takes, which the same key shows one after another.
#pragma once

#ifndef __EMSCRIPTEN__

#include "app/fit.h"
#include "app/keys.h"

#include <string>
#include <vector>

namespace slicecast {

// Each fits a picture of that size wherever single words do. Lines without a key are left out.
std::vector<std::string> helpPages(const KeyBindings& keys, Size picture);

}  // namespace slicecast

#endif

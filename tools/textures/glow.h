// What shines by itself, in frames: a panel of runes, a brazier.
#pragma once

#include "picture.h"

namespace slicecast::textures {

Picture paintRunePanel();
Picture paintBrazier();

}  // namespace slicecast::textures

// The round arch of dressed stone for doors and passages.
#pragma once

#include "surface.h"

namespace slicecast::textures {

// How far a texel lies outside the opening; negative within it.
double outsideArch(int x, int y);

// Draws the surround: wedges around the arch, quoins below it. The opening is left as it is.
void drawArch(Surface& surface);

// A wall of dressed blocks with the arch in it, and nothing within the arch.
Picture paintArchway();

}  // namespace slicecast::textures

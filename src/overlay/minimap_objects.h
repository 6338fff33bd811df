// Draws the objects on a minimap.
#pragma once

#include "overlay/minimap_view.h"
#include "slicecast/picture.h"
#include "world/world.h"

namespace slicecast {

// Dots as large as the objects are wide, within limits: pale for still ones, magenta for moving
// ones, with a line ahead that is longer for faster ones. Objects that reach into the level are
// bright, those below it faint, those above it hidden.
void drawMinimapObjects(const World& world, int map, int level, const MinimapView& view,
                        const Picture& picture);

}  // namespace slicecast

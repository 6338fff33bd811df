// The objects on a minimap.
#pragma once

#include "overlay/minimap_view.h"
#include "slicecast/picture.h"
#include "world/world.h"

namespace slicecast {

// Dots as large as the objects are wide, within limits: pale for what stands still, magenta with a
// line ahead for what moves, the longer the faster. Those that reach into the level are bright,
// those below it faint; what is above it is not shown.
void drawMinimapObjects(const World& world, int map, int level, const MinimapView& view,
                        const Picture& picture);

}  // namespace slicecast

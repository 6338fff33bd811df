// Lines in the world, which tools lay over the picture: outlines of cells, boxes, ways. What
// something hides is dashed.
//
//     drawMarks(world, eye, options, {{{2.0, 3.0, 1.0}, {3.0, 3.0, 1.0}, {236, 200, 98, 255}}},
//               picture);
//
// A line joins two points of the eye's map, within the limit of coordinates; see-through blocks and
// objects hide nothing, and behind portals nothing is drawn. It is where the exact method draws
// such an edge.
#pragma once

#include "render/eye.h"
#include "render/options.h"
#include "slicecast/mark.h"
#include "slicecast/picture.h"
#include "world/world.h"

#include <span>

namespace slicecast {

// How often a picture asks whether something hides a place: once for each pixel of usual marks;
// more of them are asked about in longer pieces. Each time takes as long as a ray.
inline constexpr int kMostSights = 8192;

// The eye must be in one of the world's maps, and above the floor.
void drawMarks(const World& world, const Eye& eye, const RenderOptions& options,
               std::span<const Mark> marks, const Picture& picture);

}  // namespace slicecast

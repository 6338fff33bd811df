// Boards, beams and what is made of them.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintPlanksFloor();
Picture paintPlanksWall();
Picture paintTimberFrame();
Picture paintTimberFrameBrace();
Picture paintCeilingBeams();
Picture paintCrate();

// The bare timber-framed wall, for pictures that put something else on it.
Surface timberFrameSurface();
Lighting timberLighting();

}  // namespace slicecast::textures

// What one walks on out of doors.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintGrass();
Picture paintGrassMeadow();
Picture paintMoss();
Picture paintPath();
Picture paintSand();
Picture paintCobbles();
Picture paintFlagstones();
Picture paintWater();

}  // namespace slicecast::textures

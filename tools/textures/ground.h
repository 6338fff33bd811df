// Grounds to walk on outdoors, and banks beside them.
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
Picture paintEarth();  // a bank of soil
Picture paintTurf();   // its uppermost block, with grass hanging over the edge

}  // namespace slicecast::textures

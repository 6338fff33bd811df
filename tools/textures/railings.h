// Barriers that one can see through: bars, grates, fences, nets.
#pragma once

#include "picture.h"

namespace slicecast::textures {

Picture paintIronBars();
Picture paintGrate();  // seen from above, to walk on
Picture paintFence();
Picture paintNet();
Picture paintRopeRailing();

}  // namespace slicecast::textures

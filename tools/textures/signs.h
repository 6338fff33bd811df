// Signs: boards with a word, and carved jambs that mark special passages.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintSignClimb();
Picture paintSignCourt();
Picture paintSignDeep();
Picture paintSignInn();
Picture paintSignLane();
Picture paintSignMoor();
Picture paintSignNight();
Picture paintSignRound();
Picture paintSignShore();

Picture paintCarvedJamb();

}  // namespace slicecast::textures

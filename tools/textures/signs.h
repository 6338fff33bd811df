// What tells a traveller where a way leads: boards with a word, and carved jambs that mark a way
// out of the ordinary.
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

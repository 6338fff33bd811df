// What stands about in a street, as sprites.
#pragma once

#include "picture.h"

namespace slicecast::textures {

Picture paintStreetLamp();
Picture paintStandingBarrel();
Picture paintCrateStack();
Picture paintMarketStall();

}  // namespace slicecast::textures

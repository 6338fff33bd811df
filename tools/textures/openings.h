// Doors and windows painted on a wall. Around the opening lies the same wall as in the texture that
// they go with, so their borders continue it.
#pragma once

#include "surface.h"

namespace slicecast::textures {

Picture paintDoor();             // in stone-blocks
Picture paintWindowBrick();      // in brick
Picture paintWindowLit();        // in brick, a lamp behind the panes
Picture paintWindowTimber();     // in timber-frame, with shutters
Picture paintWindowTimberLit();  // the same, a lamp behind the panes

}  // namespace slicecast::textures

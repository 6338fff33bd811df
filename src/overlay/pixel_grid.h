// A grid over the picture for reading positions: a fine line every 10 pixels, a strong one with its
// number every 100.
#pragma once

#include "slicecast/picture.h"

namespace slicecast {

void drawPixelGrid(const Picture& picture);

}  // namespace slicecast

// A grid over the picture, to tell where on it something lies: a fine line every 10 pixels, a clear
// one every 100, with its number.
#pragma once

#include "slicecast/picture.h"

namespace slicecast {

void drawPixelGrid(const Picture& picture);

}  // namespace slicecast

// The line between two halves of a picture that were drawn in two ways.
#pragma once

#include "slicecast/picture.h"

namespace slicecast {

// Between the columns left of `column` and those from it on; nothing at the picture's edges.
void drawDivider(const Picture& picture, int column);

}  // namespace slicecast

// Draws the line between two parts of a picture that were drawn by different methods.
#pragma once

#include "slicecast/picture.h"

namespace slicecast {

// Separates the columns left of `column` from the others; draws nothing at the picture's edges.
void drawDivider(const Picture& picture, int column);

}  // namespace slicecast

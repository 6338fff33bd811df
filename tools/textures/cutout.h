// Finishes pictures with holes after painting, and joins frames side by side.
#pragma once

#include <vector>

#include "picture.h"

namespace slicecast::textures {

// Whether the borders of a picture meet copies of itself, or nothing.
enum class Border { Repeats, Ends };

// Gives holes the colour of their neighbours, so that no wrong colour shows where a picture is
// blended or enlarged.
Picture holesFilled(Picture picture, Border border);

// Edges blended over about a texel. The lowest row stands on the ground and stays whole.
Picture edgesSoftened(const Picture& picture);

// A fully transparent block texture, for missing faces such as the top of a fence.
Picture paintNothing();

// Frames of equal size side by side.
Picture inARow(const std::vector<Picture>& frames);

}  // namespace slicecast::textures

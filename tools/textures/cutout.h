// What is done to pictures with holes after they are painted, and frames put into a row.
#pragma once

#include <vector>

#include "picture.h"

namespace slicecast::textures {

// Do the borders of a picture meet their own copies, or nothing?
enum class Border { Repeats, Ends };

// Holes get the colour of what is next to them, so that nothing foreign shows where a picture is
// blended or enlarged.
Picture holesFilled(Picture picture, Border border);

// Edges blended over about a texel. The lowest row stands on the ground and stays whole.
Picture edgesSoftened(const Picture& picture);

// A block texture of which nothing is seen, for faces that a block goes without: the top of a
// fence.
Picture paintNothing();

// Frames of equal size side by side.
Picture inARow(const std::vector<Picture>& frames);

}  // namespace slicecast::textures

// The test card: a word, an arrow that points up and the four points of the compass, so that a
// picture drawn mirrored, upside down or turned is seen at once.
#pragma once

#include "picture.h"

namespace slicecast::textures {

Picture paintLettering();

}  // namespace slicecast::textures

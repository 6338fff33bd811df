// Tall arched windows of a palace, two blocks high, in whitewash: one through whose panes one
// looks, and one whose panes, and the lake behind them, are only painted; and the opening alone,
// for the other side of the wall. Foot and head are pictures of their own, for two blocks on top of
// each other.
#pragma once

#include "picture.h"

namespace slicecast::textures {

Picture paintPalaceWindowFoot();
Picture paintPalaceWindowHead();
Picture paintPalaceOpeningFoot();
Picture paintPalaceOpeningHead();
Picture paintPaintedWindowFoot();
Picture paintPaintedWindowHead();

}  // namespace slicecast::textures

// What a palace is furnished with, as sprites, and its floor of dark polished marble.
#pragma once

#include "picture.h"

namespace slicecast::textures {

Picture paintMarbleDark();
Picture paintColumn();
Picture paintChandelier();

}  // namespace slicecast::textures

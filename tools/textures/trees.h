// Trees and bushes, as sprites.
#pragma once

#include "picture.h"

namespace slicecast::textures {

Picture paintOak();
Picture paintPine();
Picture paintBirch();
Picture paintBush();
Picture paintFlowerBush();

}  // namespace slicecast::textures

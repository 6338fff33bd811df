// Slicecast, a raycasting engine: includes the whole library.
//
//     #include <slicecast/slicecast.h>
//
//     slicecast::LoadResult loaded = slicecast::loadSceneFile("castle.json");
//     slicecast::Game game(std::move(*loaded.scene));
//     slicecast::saveImage(game.picture(640, 400), "castle.png");
//
// These hold for all of it:
//
//   units      A block is 1 unit. x grows east, y grows south, z grows up. Tile i is the interval
//              [i, i + 1). Headings are degrees, 0 = east, growing clockwise seen from above (90 =
//              south). Pixels count from the upper left. Coordinates and heights are rounded to
//              1/65536 unit and kept within 32767 of 0; a NaN counts as 0.
//   errors     Only std::bad_alloc is thrown. Calls that can fail report it in their result: a list
//              of faults, a text that is empty on success, false, an empty image or an empty
//              optional. A call that failed has changed nothing. Calls name the ranges that they
//              check; the caller answers for all other indices.
//   lifetime   Every object owns what it needs. A scene is moved into its game; only copy() copies
//              one. An object that was moved from may only be destroyed or assigned.
//   threads    There is no global state. One object serves one thread at a time; different objects
//              serve different threads at the same time.
//   the same   The same calls give the same states and the same pictures, byte for byte, from every
//              compiler and on every machine.
#pragma once

#include "slicecast/blueprint.h"
#include "slicecast/cell_change.h"
#include "slicecast/colour.h"
#include "slicecast/face.h"
#include "slicecast/fault.h"
#include "slicecast/game.h"
#include "slicecast/image.h"
#include "slicecast/input.h"
#include "slicecast/mark.h"
#include "slicecast/option.h"
#include "slicecast/picture.h"
#include "slicecast/place.h"
#include "slicecast/ray.h"
#include "slicecast/save_image.h"
#include "slicecast/scene.h"
#include "slicecast/scene_builder.h"
#include "slicecast/sound.h"
#include "slicecast/trace.h"
#include "slicecast/version.h"

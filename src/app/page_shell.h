// The program in a page: a canvas is its screen and gives it keys and mouse
// (web/engine/engine-canvas.js). Several modules in one page are independent.
//
// SDL provides only the surface. Canvas, keys and mouse are used directly. SDL would swallow every
// key of the page, Tab and the browser's shortcuts too, and would not let a click give the focus.
// Its window code would be a third of the program.
#pragma once

#ifdef __EMSCRIPTEN__

#include "app/app.h"

namespace slicecast {

// The only program of this module. It exists before it starts, so a page can load a scene
// meanwhile.
App& pageProgram();

// Replaces it by a new one, which has no canvas yet.
void renewPageProgram();

// Starts drawing (the first picture at once) and listening. False if there is no canvas.
bool beginPageProgram();

// Stops both, if they have started.
void endPageProgram();

}  // namespace slicecast

#endif

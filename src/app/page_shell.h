// The program in a page: a canvas is its screen, its keys and its mouse
// (web/engine/engine-canvas.js). Several modules in one page do not see each other.
//
// SDL brings the surface. The canvas itself, its keys and its mouse are used directly: SDL takes
// every key of the page away, Tab and the browser's own combinations included, never lets a click
// give the focus, and its window would be a third of the program.
#pragma once

#ifdef __EMSCRIPTEN__

#include "app/app.h"

namespace slicecast {

// The one program of this module. It exists before it is begun, so a page can load a scene
// meanwhile.
App& pageProgram();

// Another one in its place, as in the beginning: no canvas knows of this one.
void renewPageProgram();

// Begins to draw, the first picture at once, and to listen. False if there is no canvas.
bool beginPageProgram();

// Ends both, if they have begun.
void endPageProgram();

}  // namespace slicecast

#endif

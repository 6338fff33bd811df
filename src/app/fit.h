// Fits a picture into a window. Pixels stay crisp: each becomes a square of n x n window pixels,
// unless the window is too small for the picture.
#pragma once

#include <SDL2/SDL_rect.h>

namespace slicecast {

// An ordinary machine draws pictures of about this many pixels at full rate.
inline constexpr int kSoftwarePixels = 1280 * 800;

struct Size {
    int width = 0;
    int height = 0;

    friend bool operator==(const Size&, const Size&) = default;
};

struct Fit {
    Size picture;    // pixels of the picture
    SDL_Rect place;  // where it is shown, in pixels of the window
};

// Fills the window: each pixel becomes a square of n x n, with the least n that gives at most
// kSoftwarePixels. The last column and row may extend beyond the window by less than one such
// square.
Fit fillWindow(Size window);

// Centres a picture in the window, enlarged by the largest whole number that fits; shrunk in
// proportion if the window is smaller.
Fit letterbox(Size picture, Size window);

}  // namespace slicecast

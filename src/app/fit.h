// How a picture fits a window: crisp, so every pixel of the picture becomes a square of whole
// pixels.
#pragma once

#include <SDL2/SDL_rect.h>

namespace slicecast {

inline constexpr int kSoftwarePixels =
    1280 * 800;  // a picture of about this many pixels is drawn at full rate on an ordinary machine

struct Size {
    int width = 0;
    int height = 0;

    friend bool operator==(const Size&, const Size&) = default;
};

// A picture's size, and where it stands in the window.
struct Fit {
    Size picture;
    SDL_Rect place;
};

// Fills the window with a picture made for it: each of its pixels becomes a square of n x n, for
// the least n that gives at most kSoftwarePixels. The last column and row may reach beyond the
// window's edge by less than one of them.
Fit fillWindow(Size window);

// Puts a picture of a given size into the middle of the window, enlarged by the largest whole
// number for which all of it is seen; where the window is smaller than the picture, shrunk in
// proportion.
Fit letterbox(Size picture, Size window);

}  // namespace slicecast

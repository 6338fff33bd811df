// Slow drawing: the picture builds up slice by slice, from left to right, and then over again.
//
//     SlowDrawing slow;
//     renderer.draw(...), picture complete
//     slow.show(picture, 3);        leaves of it the slices that are due, on what earlier calls
//     have shown
#pragma once

#include "base/image.h"
#include "render/picture.h"

namespace slicecast {

inline constexpr int kMostSlicesPerPicture =
    200;  // or so many pictures for one slice, as a negative number
inline constexpr Colour kNotYetDrawn = {20, 22, 26, 255};

class SlowDrawing {
public:
    // `slices` more of the picture are shown; a negative number -n shows one more with every n-th
    // call; 0 none.
    void show(const Picture& picture, int slices);

    // The slice that comes next.
    int next() const { return next_; }

    // Begins again with an empty picture.
    void restart();

private:
    Image shown_;
    int next_ = 0;
    int waited_ = 0;  // calls since the last slice, where one is shown every few calls
};

}  // namespace slicecast

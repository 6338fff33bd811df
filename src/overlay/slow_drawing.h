// Slow drawing: the picture builds up slice by slice, from left to right, and then over again.
//
//     drawColumns(picture, 40);     what is there when 40 slices have been drawn
//
//     SlowDrawing slow;             the same by itself, some slices more with each picture
//     renderer.draw(...)            picture complete
//     slow.show(picture, 3);        leaves of it the slices that are drawn by now
#pragma once

#include "base/image.h"
#include "slicecast/picture.h"

namespace slicecast {

inline constexpr int kMostSlicesPerPicture =
    200;  // or so many pictures for one slice, as a negative number
inline constexpr Colour kNotYetDrawn = {20, 22, 26, 255};

// Leaves the first `count` columns of a picture, marks the next one by a line, and covers the rest:
// by what `before` shows there, a picture of the same size, or by kNotYetDrawn.
void drawColumns(const Picture& picture, int count, const Image* before = nullptr);

class SlowDrawing {
public:
    // `slices` more of the picture are drawn; a negative number -n draws one more with every n-th
    // call; 0 none. Once all are, it begins again, over the picture that was complete then.
    void show(const Picture& picture, int slices);

    // The slice that comes next.
    int next() const { return next_; }

    // Begins again with an empty picture.
    void restart();

private:
    Image before_;  // what the slices to come still show
    int next_ = 0;
    int waited_ = 0;  // calls since the last slice, where one is shown every few calls
};

}  // namespace slicecast

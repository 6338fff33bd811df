// Slow drawing: the picture builds up slice by slice, from left to right, again and again.
//
//     drawColumns(picture, 40);     keeps the first 40 slices
//
//     SlowDrawing slow;             the same, adding slices with each picture
//     renderer.draw(...)            the complete picture
//     slow.show(picture, 3);        keeps the slices drawn so far
#pragma once

#include "base/image.h"
#include "slicecast/picture.h"

namespace slicecast {

// As a negative number: the most pictures per slice.
inline constexpr int kMostSlicesPerPicture = 200;
inline constexpr Colour kNotYetDrawn = {20, 22, 26, 255};

// Keeps the first `count` columns of a picture and marks the next one by a line. Covers the rest
// with `before`, a picture of the same size, or with kNotYetDrawn if that is null.
void drawColumns(const Picture& picture, int count, const Image* before = nullptr);

class SlowDrawing {
public:
    // Adds `slices` slices; a negative number -n adds one with every n-th call; 0 adds none. When
    // the picture is complete it starts again over that picture.
    void show(const Picture& picture, int slices);

    // The slice to be drawn next.
    int next() const { return next_; }

    // Starts again with an empty picture.
    void restart();

private:
    Image before_;  // shown where slices are still to come
    int next_ = 0;
    int waited_ = 0;  // calls since the last slice
};

}  // namespace slicecast

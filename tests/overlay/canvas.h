// A picture to draw on, with a border of pixels that must stay as they are.
#pragma once

#include "base/image.h"
#include "slicecast/picture.h"

namespace slicecast {

struct Canvas {
    static constexpr int kBorder = 3;
    static constexpr Pixel kUntouched = 0xff302010u;

    Image image;
    Picture picture;

    Canvas(int width, int height) : image(width + 2 * kBorder, height + 2 * kBorder) {
        for (Pixel& pixel : image.pixels) pixel = kUntouched;
        picture = {image.pixels.data() + kBorder * image.width + kBorder, width, height,
                   image.width};
    }

    Pixel at(int x, int y) const { return picture.row(y)[x]; }
    bool touched(int x, int y) const { return at(x, y) != kUntouched; }

    bool borderUntouched() const {
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const bool inside = x >= kBorder && y >= kBorder && x < image.width - kBorder &&
                                    y < image.height - kBorder;
                if (!inside && image.at(x, y) != kUntouched) return false;
            }
        }
        return true;
    }

    // Pixels of the picture that were drawn on.
    int touchedPixels() const {
        int count = 0;
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x) count += touched(x, y);
        }
        return count;
    }
};

}  // namespace slicecast

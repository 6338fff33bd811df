#include "overlay/slow_drawing.h"

#include "overlay/blend.h"

#include <algorithm>
#include <cstddef>

namespace slicecast {
namespace {

constexpr Colour kFrontLine = {255, 214, 74, 230};

}  // namespace

void drawColumns(const Picture& picture, int count, const Image* before) {
    if (count >= picture.width) return;
    for (int y = 0; y < picture.height; ++y) {
        Pixel* const rest = picture.row(y) + count;
        Pixel* const end = picture.row(y) + picture.width;
        if (before != nullptr) {
            const Pixel* const shown = before->pixels.data() + std::ptrdiff_t{y} * picture.width;
            std::copy(shown + count, shown + picture.width, rest);
        } else {
            std::fill(rest, end, toPixel(kNotYetDrawn));
        }
    }
    blendRect(picture, {count, 0, 1, picture.height}, kFrontLine);
}

void SlowDrawing::show(const Picture& picture, int slices) {
    // Restarts for a picture of another size.
    if (before_.width != picture.width || before_.height != picture.height) {
        before_ = Image(picture.width, picture.height);
        std::fill(before_.pixels.begin(), before_.pixels.end(), toPixel(kNotYetDrawn));
        next_ = waited_ = 0;
    }

    // Slices due now
    int due = std::min(slices, picture.width);
    if (slices < 0) {
        due = ++waited_ >= -slices ? 1 : 0;
        if (due > 0) waited_ = 0;
    }

    // When complete, this picture becomes the background of the next one
    next_ += due;
    if (next_ >= picture.width) {
        next_ -= picture.width;
        for (int y = 0; y < picture.height; ++y)
            std::copy(picture.row(y), picture.row(y) + picture.width, &before_.at(0, y));
    }
    drawColumns(picture, next_, &before_);
}

void SlowDrawing::restart() {
    before_ = Image();
}

}  // namespace slicecast

#include "overlay/slow_drawing.h"

#include "overlay/blend.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr Colour kFrontLine = {255, 214, 74, 230};

}  // namespace

void SlowDrawing::show(const Picture& picture, int slices) {
    // A picture of another size begins anew.
    if (shown_.width != picture.width || shown_.height != picture.height) {
        shown_ = Image(picture.width, picture.height);
        std::fill(shown_.pixels.begin(), shown_.pixels.end(), toPixel(kNotYetDrawn));
        next_ = waited_ = 0;
    }

    // How many are due
    int due = std::min(slices, picture.width);
    if (slices < 0) {
        due = ++waited_ >= -slices ? 1 : 0;
        if (due > 0) waited_ = 0;
    }

    // They are kept; the picture becomes what has been kept so far.
    for (int y = 0; y < picture.height; ++y) {
        Pixel* kept = &shown_.at(0, y);
        Pixel* row = picture.row(y);
        for (int i = 0; i < due; ++i) {
            const int x = (next_ + i) % picture.width;
            kept[x] = row[x];
        }
        std::copy(kept, kept + picture.width, row);
    }
    next_ = (next_ + due) % picture.width;
    blendRect(picture, {next_, 0, 1, picture.height}, kFrontLine);
}

void SlowDrawing::restart() {
    shown_ = Image();
}

}  // namespace slicecast

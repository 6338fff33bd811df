#include "app/fit.h"

#include <algorithm>
#include <cstdint>

namespace slicecast {

namespace {

constexpr int divideUp(int a, int b) {
    return (a + b - 1) / b;
}

}  // namespace

Fit fillWindow(Size window) {
    for (int scale = 1;; ++scale) {
        const Size picture = {std::max(1, divideUp(window.width, scale)),
                              std::max(1, divideUp(window.height, scale))};
        if (static_cast<std::int64_t>(picture.width) * picture.height <= kSoftwarePixels) {
            return {picture, {0, 0, picture.width * scale, picture.height * scale}};
        }
    }
}

Fit letterbox(Size picture, Size window) {
    int width = 0;
    int height = 0;
    const int scale = std::min(window.width / picture.width, window.height / picture.height);
    if (scale >= 1) {
        width = picture.width * scale;
        height = picture.height * scale;
    } else if (static_cast<std::int64_t>(window.width) * picture.height <=
               static_cast<std::int64_t>(window.height) * picture.width) {
        width = window.width;
        height = std::max(1, static_cast<int>(static_cast<std::int64_t>(picture.height) *
                                              window.width / picture.width));
    } else {
        height = window.height;
        width = std::max(1, static_cast<int>(static_cast<std::int64_t>(picture.width) *
                                             window.height / picture.height));
    }
    return {picture, {(window.width - width) / 2, (window.height - height) / 2, width, height}};
}

}  // namespace slicecast

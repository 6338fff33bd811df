#include "overlay/divider.h"

#include "overlay/blend.h"
#include "overlay/layout.h"

namespace slicecast {
namespace {

// Dark beside light, so that it shows on any scene.
constexpr Colour kDividerLine = {255, 255, 255, 235};
constexpr Colour kDividerRim = {0, 0, 0, 120};

}  // namespace

void drawDivider(const Picture& picture, int column) {
    if (column <= 0 || column >= picture.width) return;
    const int width = readableScale(picture.width, picture.height);
    blendRect(picture, {column - 2 * width, 0, width, picture.height}, kDividerRim);
    blendRect(picture, {column - width, 0, width, picture.height}, kDividerLine);
    blendRect(picture, {column, 0, width, picture.height}, kDividerRim);
}

}  // namespace slicecast

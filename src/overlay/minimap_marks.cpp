#include "overlay/minimap_marks.h"

#include "base/words.h"
#include "overlay/minimap_tiles.h"
#include "overlay/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace slicecast {
namespace {

constexpr Colour kPlayer = {255, 214, 74, 255};
constexpr Colour kPlayerRim = {20, 20, 20, 200};
constexpr int kFieldAlpha = 120;  // of the field of view, at the eye
constexpr Colour kReach = {160, 170, 180, 60};
constexpr Colour kReachRim = {235, 240, 245, 200};
constexpr Colour kAbove = {236, 240, 244, 44};  // levels above the shown one

// The share of a pixel inside an edge, from the distance of the pixel's middle to the edge in
// pixels.
double coverage(double distance) {
    return std::clamp(distance + 0.5, 0.0, 1.0);
}

int toAlpha(double part, int most) {
    return static_cast<int>(part * most + 0.5);
}

// How far a point is inside an arrow head, pixels; negative outside. `ahead` and `aside` are from
// its middle, `aside` to either side.
double insideArrow(double ahead, double aside, double size) {
    // From the tip to a corner, and from the corner back to the notch
    const double side = (1.5 * size - ahead) * 0.3810 - aside * 0.9246;
    const double notch = (ahead + 0.5 * size) * 0.8575 + aside * 0.5145;
    return std::min(side, notch);
}

}  // namespace

void drawMinimapReach(const MinimapView& view, double reach, const Picture& picture) {
    const double radius = reach * view.pixelsPerTile;
    drawDot(picture, view.area, view.centre(), radius, kReach);
    drawRing(picture, view.area, view.centre(), radius, kReachRim, view.line);
}

void drawMinimapNorth(const MinimapView& view, int scale, const Picture& picture) {
    const Point north = view.toPicture({0.0, -1.0});
    const double radius = view.area.width / 2.0 - 7.0 * scale;
    const Point at = {std::floor(view.centre().x + north.x * radius) + 0.5,
                      std::floor(view.centre().y + north.y * radius) + 0.5};
    drawDot(picture, view.area, at, 6.0 * scale, {16, 20, 28, 230});
    for (int i = 0; i < scale; ++i)
        drawRing(picture, view.area, at, 6.0 * scale - i, withAlpha(kPlayer, 210));
    drawText(picture, static_cast<int>(at.x - 2.5 * scale + 0.5),
             static_cast<int>(at.y - 3.5 * scale + 0.5), "N", {.scale = scale});
}

void drawMinimapLevels(const MinimapLevels& levels, const MinimapView& view, int scale,
                       const Picture& picture) {
    const int room = std::min(32 * scale, view.area.height / 3);
    const int step = std::clamp(room / levels.count, 1, 5 * scale);
    const int gap = step > 2 * scale ? scale : step > 2 ? 1 : 0;
    const int stack = step * levels.count - gap;
    std::array<char, 12> text;
    const std::string_view number = write(text, levels.shown);
    const int bar = 9 * scale;
    const int left = view.area.x + 5 * scale;
    const int bottom = view.area.y + view.area.height - 3 * scale;
    const int height = std::max(stack, 7 * scale);
    blendRect(picture,
              {view.area.x, bottom - height - 3 * scale,
               bar + textWidth(number, scale) + 13 * scale, height + 6 * scale},
              kPanelColour);
    for (int i = 0; i < levels.count; ++i) {
        const PixelRect place = {left, bottom - i * step - (step - gap), bar, step - gap};
        const int more = i == levels.shown ? 2 * scale : 0;  // the shown one sticks out
        blendRect(picture, {place.x, place.y, bar + more, place.height},
                  i > levels.shown    ? kAbove
                  : i == levels.shown ? Colour{150, 182, 224, 255}
                                      : minimapGround(levels.shown - 1 - i + 0.5));
        if (i == std::clamp(levels.eye, 0, levels.count - 1))
            blendRect(picture,
                      {place.x - 3 * scale, place.y + (place.height - scale) / 2, 2 * scale,
                       std::max(scale, std::min(2 * scale, place.height))},
                      kPlayer);
    }
    const int middle = bottom - levels.shown * step - (step - gap) / 2;
    const int y = std::clamp(middle - 3 * scale, bottom - height, bottom - 7 * scale);
    drawText(picture, left + bar + 5 * scale, y, number, {.scale = scale});
}

void drawMinimapEye(const MinimapView& view, const Eye& eye, double fovDegrees,
                    const Picture& picture) {
    const Point forward =
        view.toPicture({cosDegrees(eye.headingDegrees), sinDegrees(eye.headingDegrees)});
    const SineCosine half = sineCosineDegrees(fovDegrees / 2.0);
    const double reach = view.area.width * 0.42;
    const double size = std::max(2.0, view.area.width / 30.0);
    const double rimWidth = std::max(1.0, size / 4.0);
    const int most = static_cast<int>(reach);
    const PixelRect around =
        shared(view.area, {view.centreX - most, view.centreY - most, 2 * most + 1, 2 * most + 1});
    for (int y = around.y; y < around.y + around.height; ++y) {
        for (int x = around.x; x < around.x + around.width; ++x) {
            const double right = x - view.centreX;
            const double down = y - view.centreY;
            const double ahead = right * forward.x + down * forward.y;
            const double aside = std::abs(down * forward.x - right * forward.y);
            const double squared = right * right + down * down;
            if (squared > reach * reach || ahead < -2.0 * size) continue;
            const double inside = coverage(ahead * half.sine - aside * half.cosine);
            if (inside > 0.0) {
                const double near = std::max(0.0, 1.0 - std::sqrt(squared) / reach);
                blendPixel(picture, x, y, withAlpha(kPlayer, toAlpha(inside * near, kFieldAlpha)));
            }
            if (squared > 9.0 * size * size) continue;
            const double within = insideArrow(ahead, aside, size);
            const double rim = coverage(within + rimWidth);
            const double arrow = coverage(within);
            if (rim > 0.0)
                blendPixel(picture, x, y, withAlpha(kPlayerRim, toAlpha(rim, kPlayerRim.a)));
            if (arrow > 0.0) blendPixel(picture, x, y, withAlpha(kPlayer, toAlpha(arrow, 255)));
        }
    }
}

}  // namespace slicecast

#include "overlay/lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slicecast {
namespace {

constexpr int kWidestRing = 16;  // pixels

// Lays a part of a colour over a pixel, if it is inside.
void blendPart(const Picture& picture, PixelRect inside, int x, int y, Colour colour, double part) {
    if (x < inside.x || y < inside.y || x >= inside.x + inside.width ||
        y >= inside.y + inside.height)
        return;
    const int alpha = static_cast<int>(part * colour.a + 0.5);
    if (alpha > 0) blendPixel(picture, x, y, withAlpha(colour, alpha));
}

// The pixels that a circle may touch.
template <typename Part>
void drawRound(const Picture& picture, PixelRect inside, Point middle, double radius, Colour colour,
               Part part) {
    const int reach = static_cast<int>(radius) + kWidestRing / 2 + 2;
    const int centreX = static_cast<int>(std::floor(middle.x));
    const int centreY = static_cast<int>(std::floor(middle.y));
    const PixelRect around =
        shared(inside, {centreX - reach, centreY - reach, 2 * reach + 1, 2 * reach + 1});
    for (int y = around.y; y < around.y + around.height; ++y) {
        for (int x = around.x; x < around.x + around.width; ++x) {
            const double east = x + 0.5 - middle.x;
            const double south = y + 0.5 - middle.y;
            blendPart(picture, inside, x, y, colour, part(std::sqrt(east * east + south * south)));
        }
    }
}

}  // namespace

PixelRect shared(PixelRect a, PixelRect b) {
    const int x = std::max(a.x, b.x);
    const int y = std::max(a.y, b.y);
    const int width = std::min(a.x + a.width, b.x + b.width) - x;
    const int height = std::min(a.y + a.height, b.y + b.height) - y;
    return {x, y, std::max(0, width), std::max(0, height)};
}

// One step along the longer way at a time; the pixel's worth of colour is shared by the two pixels
// across, with whole ones between them where the line is wider.
void drawLine(const Picture& picture, PixelRect inside, Point from, Point to, Colour colour,
              int width) {
    const bool steep = std::abs(to.y - from.y) > std::abs(to.x - from.x);
    const auto along = [steep](Point p) { return steep ? p.y : p.x; };
    const auto across = [steep](Point p) { return steep ? p.x : p.y; };
    if (along(from) > along(to)) std::swap(from, to);
    const double length = along(to) - along(from);
    const double slope = length > 0.0 ? (across(to) - across(from)) / length : 0.0;

    // Only the steps inside
    const int least = steep ? inside.y : inside.x;
    const int most = steep ? inside.y + inside.height : inside.x + inside.width;
    const int first =
        static_cast<int>(std::clamp(std::floor(along(from)), double(least), double(most)));
    const int last = static_cast<int>(
        std::clamp(std::floor(along(to)), double(least) - 1.0, double(most) - 1.0));
    for (int step = first; step <= last; ++step) {
        const double middle = across(from) + (step + 0.5 - along(from)) * slope - 0.5 * width;
        if (!(std::abs(middle) < 1e6)) continue;
        const double whole = std::floor(middle);
        const double rest = middle - whole;
        const int near = static_cast<int>(whole);
        for (int place = near; place <= near + width; ++place) {
            const double part = place == near ? 1.0 - rest : place < near + width ? 1.0 : rest;
            blendPart(picture, inside, steep ? place : step, steep ? step : place, colour, part);
        }
    }
}

void drawDot(const Picture& picture, PixelRect inside, Point middle, double radius, Colour colour) {
    drawRound(picture, inside, middle, radius, colour,
              [radius](double distance) { return std::clamp(radius - distance + 0.5, 0.0, 1.0); });
}

void drawRing(const Picture& picture, PixelRect inside, Point middle, double radius, Colour colour,
              int width) {
    drawRound(picture, inside, middle, radius, colour, [radius, width](double distance) {
        return std::clamp(0.5 * (width + 1) - std::abs(distance - radius), 0.0, 1.0);
    });
}

}  // namespace slicecast

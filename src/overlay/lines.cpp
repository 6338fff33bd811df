#include "overlay/lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace slicecast {
namespace {

// Blends a part of a colour over a pixel; nothing if the part is negative. Takes a number instead
// of a Colour so that compilers keep it in a register.
__attribute__((always_inline)) inline void blendPart(Pixel& pixel, Pixel colour, double part) {
    const auto alpha = static_cast<int>(part * static_cast<int>(colour >> 24) + 0.5);
    if (alpha > 0) pixel = blended(pixel, (colour & 0x00ffffff) | static_cast<Pixel>(alpha) << 24);
}

int floored(double value) {
    const int whole = static_cast<int>(value);
    return whole - (value < whole ? 1 : 0);
}

PixelRect onPicture(PixelRect inside, const Picture& picture) {
    return shared(inside, {0, 0, picture.width, picture.height});
}

// Pixels of a row or a column, [first, last).
struct Run {
    int first;
    int last;
};

// A disc, or only its outline. The colour fades over `half` a pixel or more on both sides of the
// radius.
struct Round {
    Point middle;
    double radius;
    double half;
    bool hollow;
};

void drawRound(const Picture& picture, PixelRect inside, const Round& round, Colour colour) {
    const int reach = static_cast<int>(round.radius + round.half) + 2;
    const int left = floored(round.middle.x) - reach;
    const int top = floored(round.middle.y) - reach;
    const PixelRect around =
        onPicture(shared(inside, {left, top, 2 * reach + 1, 2 * reach + 1}), picture);
    const Pixel over = toPixel(colour);
    for (int y = around.y; y < around.y + around.height; ++y) {
        Pixel* const pixels = picture.row(y);
        const double south = y + 0.5 - round.middle.y;
        for (int x = around.x; x < around.x + around.width; ++x) {
            const double east = x + 0.5 - round.middle.x;
            const double beyond = std::sqrt(east * east + south * south) - round.radius;
            const double part = round.half - (round.hollow ? std::abs(beyond) : beyond);
            blendPart(pixels[x], over, part < 1.0 ? part : 1.0);
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

// Steps along the longer axis. At each step the colour is shared by the two pixels across, with
// full pixels between them if the line is wider.
void drawLine(const Picture& picture, PixelRect inside, Point from, Point to, Colour colour,
              int width) {
    const bool steep = std::abs(to.y - from.y) > std::abs(to.x - from.x);
    const auto along = [steep](Point p) { return steep ? p.y : p.x; };
    const auto across = [steep](Point p) { return steep ? p.x : p.y; };
    if (along(from) > along(to)) std::swap(from, to);
    const double length = along(to) - along(from);
    const double slope = length > 0.0 ? (across(to) - across(from)) / length : 0.0;

    // Only the steps inside the clip
    const PixelRect clip = onPicture(inside, picture);
    const Run steps = steep ? Run{clip.y, clip.y + clip.height} : Run{clip.x, clip.x + clip.width};
    const Run places = steep ? Run{clip.x, clip.x + clip.width} : Run{clip.y, clip.y + clip.height};
    const auto step = [&](double at) {
        return static_cast<int>(std::clamp(std::floor(at), steps.first - 1.0, double(steps.last)));
    };
    const std::ptrdiff_t pitch = picture.pitch;
    const Pixel over = toPixel(colour);
    const int last = std::min(step(along(to)), steps.last - 1);
    for (int at = std::max(step(along(from)), steps.first); at <= last; ++at) {
        const double middle = across(from) + (at + 0.5 - along(from)) * slope - 0.5 * width;
        if (!(std::abs(middle) < 1e6)) continue;
        const int near = floored(middle);
        const double rest = middle - near;
        Pixel* const pixels = picture.pixels + (steep ? at * pitch : at);
        for (int place = near; place <= near + width; ++place) {
            if (place < places.first || place >= places.last) continue;
            const double part = place == near ? 1.0 - rest : place < near + width ? 1.0 : rest;
            blendPart(pixels[steep ? place : place * pitch], over, part);
        }
    }
}

void drawDot(const Picture& picture, PixelRect inside, Point middle, double radius, Colour colour) {
    drawRound(picture, inside, {middle, radius, 0.5, false}, colour);
}

void drawRing(const Picture& picture, PixelRect inside, Point middle, double radius, Colour colour,
              int width) {
    drawRound(picture, inside, {middle, radius, 0.5 * (width + 1), true}, colour);
}

}  // namespace slicecast

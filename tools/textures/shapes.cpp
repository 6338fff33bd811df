#include "shapes.h"

#include <algorithm>
#include <cmath>

#include "cutout.h"
#include "marks.h"

namespace slicecast::textures {

namespace {

void lay(Surface& surface, int x, int y, const Paint& paint, double rise) {
    surface.at(x, y) = {.height = paint.height + paint.bulge * rise,
                        .tone = paint.tone,
                        .ramp = paint.ramp,
                        .alpha = paint.alpha};
}

}  // namespace

Picture spriteOf(const Surface& surface, const Lighting& lighting) {
    return holesFilled(edgesSoftened(lit(surface, lighting)), Border::Ends);
}

void addGrain(Surface& surface, const Ramp* ramp, double strength, std::uint32_t seed) {
    everyTexelIn(0, 0, surface.width, surface.height, [&](int x, int y) {
        Texel& texel = surface.at(x, y);
        if (texel.alpha > 0 && texel.ramp == ramp) {
            texel.tone += strength * woodGrain(y, x, seed);
        }
    });
}

void drawBall(Surface& surface, Place middle, double radiusX, double radiusY, const Paint& paint) {
    everyTexelOn(surface, middle.x - radiusX - 1.0, middle.y - radiusY - 1.0,
                 middle.x + radiusX + 2.0, middle.y + radiusY + 2.0, [&](int x, int y) {
                     const double dx = (x + 0.5 - middle.x) / radiusX;
                     const double dy = (y + 0.5 - middle.y) / radiusY;
                     const double rest = 1.0 - dx * dx - dy * dy;
                     if (rest >= 0.0) {
                         lay(surface, x, y, paint, std::min(radiusX, radiusY) * std::sqrt(rest));
                     }
                 });
}

void drawLimb(Surface& surface, Place from, double fromRadius, Place to, double toRadius,
              const Paint& paint) {
    const double reach = std::max(fromRadius, toRadius) + 1.0;
    const double lengthX = to.x - from.x;
    const double lengthY = to.y - from.y;
    const double square = std::max(1.0e-6, lengthX * lengthX + lengthY * lengthY);
    const double left = std::min(from.x, to.x) - reach;
    const double top = std::min(from.y, to.y) - reach;
    everyTexelOn(surface, left, top, std::max(from.x, to.x) + reach + 1.0,
                 std::max(from.y, to.y) + reach + 1.0, [&](int x, int y) {
                     const double along = std::clamp(
                         ((x + 0.5 - from.x) * lengthX + (y + 0.5 - from.y) * lengthY) / square,
                         0.0, 1.0);
                     const double dx = x + 0.5 - from.x - along * lengthX;
                     const double dy = y + 0.5 - from.y - along * lengthY;
                     const double radius = fromRadius + along * (toRadius - fromRadius);
                     const double rest = radius * radius - dx * dx - dy * dy;
                     if (rest >= 0.0) {
                         lay(surface, x, y, paint, std::sqrt(rest));
                     }
                 });
}

void drawOutline(Surface& surface, const std::vector<Place>& corners, const Paint& paint) {
    double left = corners.front().x;
    double top = corners.front().y;
    double right = left;
    double bottom = top;
    for (const Place& corner : corners) {
        left = std::min(left, corner.x);
        right = std::max(right, corner.x);
        top = std::min(top, corner.y);
        bottom = std::max(bottom, corner.y);
    }
    everyTexelOn(surface, left - 1.0, top - 1.0, right + 2.0, bottom + 2.0, [&](int x, int y) {
        // Inside where a line to the right crosses the outline an odd number of times
        const double middleX = x + 0.5;
        const double middleY = y + 0.5;
        bool inside = false;
        for (std::size_t index = 0; index < corners.size(); ++index) {
            const Place& a = corners[index];
            const Place& b = corners[(index + 1) % corners.size()];
            if ((a.y <= middleY) != (b.y <= middleY) &&
                middleX < a.x + (middleY - a.y) / (b.y - a.y) * (b.x - a.x)) {
                inside = !inside;
            }
        }
        if (inside) {
            lay(surface, x, y, paint, 0.0);
        }
    });
}

void drawBox(Surface& surface, int left, int top, int right, int bottom, const Paint& paint) {
    everyTexelOn(surface, left, top, right, bottom, [&](int x, int y) {
        const double half = 0.5 * (right - left);
        const double off = x + 0.5 - left - half;
        lay(surface, x, y, paint, std::sqrt(std::max(0.0, half * half - off * off)));
    });
}

}  // namespace slicecast::textures

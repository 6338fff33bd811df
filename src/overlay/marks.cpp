#include "overlay/marks.h"

#include "overlay/layout.h"
#include "overlay/lines.h"
#include "render/view/projection.h"
#include "world/line_of_sight.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace slicecast {
namespace {

constexpr double kFarthest = 32768.0;     // units, the limit of coordinates
constexpr double kNearest = 1.0 / 64.0;   // perpendicular depth, units: nearer parts are left out
constexpr double kOnFace = 1.0 / 1024.0;  // units: so close to a face, it does not hide the place
constexpr int kDash = 4;                  // pixels, and of the gap as well, of lines one pixel wide
constexpr int kHiddenAlpha = 170;
constexpr Colour kRim = {16, 20, 28, 150};  // makes lines visible on any ground

// A line on the screen. At the share t of its way there, its depth is 1 / (a + t (b - a)) with a
// and b the inverse depths of its ends.
struct ScreenLine {
    const Mark* mark;
    Point from;
    Point to;
    double inverseFrom;  // of the depths at the ends
    double inverseTo;
    double first = 0.0;  // the part of its way inside the picture, as shares
    double last = 1.0;
    double begin = 0.0;  // where the line begins, as a share of the mark's way in the world
    double end = 1.0;

    double length() const {
        const double x = (last - first) * (to.x - from.x);
        const double y = (last - first) * (to.y - from.y);
        return std::sqrt(x * x + y * y);
    }
    Point at(double t) const {
        return {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
    }
    Place placeAt(double t) const {
        const double inverse = inverseFrom + t * (inverseTo - inverseFrom);
        const double share = begin + (end - begin) * t * inverseTo / inverse;
        const Place& a = mark->from;
        const Place& b = mark->to;
        return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
    }
};

// Shortens the part from first to last to where from + t * change lies in [least, greatest].
void clip(double from, double change, double least, double greatest, ScreenLine& line) {
    if (change == 0.0) {
        if (from < least || from > greatest) line.last = line.first;
        return;
    }
    const auto [in, out] = std::minmax({(least - from) / change, (greatest - from) / change});
    line.first = std::max(line.first, in);
    line.last = std::min(line.last, out);
}

// Empty (last <= first) if the picture shows nothing of it.
ScreenLine projected(const Mark& mark, const Eye& eye, const Projection& projection) {
    const auto seen = [&](const Place& place, double& depth, double& sideways) {
        const double east = place.x - eye.x.value();
        const double south = place.y - eye.y.value();
        depth = east * projection.forward.x + south * projection.forward.y;
        sideways = east * projection.right.x + south * projection.right.y;
    };
    ScreenLine line{&mark, {}, {}, 0.0, 0.0};
    double depth[2];
    double sideways[2];
    seen(mark.from, depth[0], sideways[0]);
    seen(mark.to, depth[1], sideways[1]);
    line.last = 0.0;
    if (!(std::max(depth[0], depth[1]) > kNearest)) return line;
    const double whole = depth[1] - depth[0];
    if (depth[0] < kNearest) line.begin = (kNearest - depth[0]) / whole;
    if (depth[1] < kNearest) line.end = (kNearest - depth[0]) / whole;
    const auto pointAt = [&](double share, double& inverse) {
        const double d = depth[0] + share * whole;
        const double s = sideways[0] + share * (sideways[1] - sideways[0]);
        const double z = mark.from.z + share * (mark.to.z - mark.from.z) - eye.z.value();
        inverse = 1.0 / d;
        return Point{projection.width / 2.0 + s * projection.distance / d, projection.rowOf(z, d)};
    };
    line.from = pointAt(line.begin, line.inverseFrom);
    line.to = pointAt(line.end, line.inverseTo);
    line.last = 1.0;
    clip(line.from.x, line.to.x - line.from.x, 0.0, projection.width, line);
    clip(line.from.y, line.to.y - line.from.y, 0.0, projection.height, line);
    return line;
}

bool isWithinLimits(const Place& place) {
    const auto isNear = [](double value) { return std::abs(value) <= kFarthest; };
    return isNear(place.x) && isNear(place.y) && isNear(place.z);
}

}  // namespace

void drawMarks(const World& world, const Eye& eye, const RenderOptions& options,
               std::span<const Mark> marks, const Picture& picture) {
    const Projection projection(eye, options, picture.width, picture.height);
    std::vector<ScreenLine> lines;
    double length = 0.0;
    for (const Mark& mark : marks.first(std::min(marks.size(), kMostMarks))) {
        if (mark.map != eye.map || !isWithinLimits(mark.from) || !isWithinLimits(mark.to)) continue;
        const ScreenLine line = projected(mark, eye, projection);
        if (!(line.last > line.first)) continue;
        lines.push_back(line);
        length += line.length() + 1.0;
    }

    const Map& map = world.maps[static_cast<std::size_t>(eye.map)];
    const Place from = {eye.x.value(), eye.y.value(), eye.z.value()};
    const int width = readableScale(picture.width, picture.height);
    const PixelRect inside = {0, 0, picture.width, picture.height};
    const double dash = kDash * width;
    const double step = std::max(1.0, length / kMostSights);  // pixels between two sights
    const auto draw = [&](const ScreenLine& line, double begin, double end, bool isHidden) {
        const Point a = line.at(begin);
        const Point b = line.at(end);
        const Colour colour =
            isHidden ? withAlpha(line.mark->colour, kHiddenAlpha) : line.mark->colour;
        drawLine(picture, inside, a, b, kRim, width + 2);
        drawLine(picture, inside, a, b, colour, width);
    };
    for (const ScreenLine& line : lines) {
        const double pixels = line.length();
        const int pieces = static_cast<int>(pixels / step) + 1;
        const double share = (line.last - line.first) / pieces;
        const auto kindOf = [&](int piece) {
            const double middle = line.first + (piece + 0.5) * share;
            if (isInSight(world, map, from, line.placeAt(middle), kOnFace)) return 0;
            const double along = (middle - line.first) / (line.last - line.first) * pixels;
            return std::fmod(along, 2.0 * dash) < dash ? 1 : 2;  // a dash, a gap
        };
        int first = 0;
        int kind = kindOf(0);
        for (int piece = 1; piece <= pieces; ++piece) {
            const int next = piece < pieces ? kindOf(piece) : -1;
            if (next == kind) continue;
            if (kind != 2)
                draw(line, line.first + first * share, line.first + piece * share, kind == 1);
            first = piece;
            kind = next;
        }
    }
}

}  // namespace slicecast

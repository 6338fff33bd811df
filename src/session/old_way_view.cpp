#include "session/old_way_view.h"

#include "base/angle.h"
#include "base/image.h"
#include "classic/draw_classic.h"
#include "slicecast/colour.h"
#include "world/map_entry.h"
#include "world/player.h"

#include <algorithm>
#include <cstdlib>

namespace slicecast {
namespace {

constexpr int kPlaces = 120;
constexpr int kViewsOfPlace = 5;  // four directions, and one down
constexpr double kLookDown = -0.6;
// Nobody likes to see a wall from close by: with less room ahead, in units, only such a part
// counts.
constexpr double kRoom = 1.5;
constexpr double kShareWithoutRoom = 0.2;
constexpr Coordinate kFlight = tileEdge(2);  // above a standing eye
// Of the small pictures
constexpr int kWidth = 64;
constexpr int kHeight = 40;
constexpr int kVisible = 32;  // of 255, in one channel

// The digits of a number behind the point, in reverse order: neighbours lie far apart, and all
// together fill 0 to 1 evenly.
double spread(int number, int base) {
    double place = 0.0;
    for (double digit = 1.0 / base; number > 0; number /= base, digit /= base)
        place += number % base * digit;
    return place;
}

// Nothing if nobody can be there.
std::optional<OldWayView> placeOf(const World& world, int number) {
    if (number == 0) {
        const Start& start = world.start;
        return OldWayView{.eye = {.map = start.map,
                                  .x = start.x,
                                  .y = start.y,
                                  .z = start.z + kStandingEye,
                                  .headingDegrees = start.headingDegrees}};
    }
    const int maps = static_cast<int>(world.maps.size());
    const int map = number % maps;
    const Map& grid = world.maps[static_cast<std::size_t>(map)];
    const int spot = 1 + number / maps;
    const int x = static_cast<int>(spread(spot, 2) * grid.width);
    const int y = static_cast<int>(spread(spot, 3) * grid.depth);
    const std::optional<Coordinate> feet = findFooting(world, map, x, y, {});
    if (!feet) return std::nullopt;
    OldWayView view;
    const Coordinate half = {tileEdge(1).raw / 2};
    view.eye = {.map = map,
                .x = tileEdge(x) + half,
                .y = tileEdge(y) + half,
                .z = *feet + kStandingEye,
                .headingDegrees = 45.0 * (spot % 2)};
    view.flying = spot % 3 == 0;
    if (view.flying) view.eye.z = view.eye.z + kFlight;
    return view;
}

bool hasRoomAhead(const World& world, const Eye& eye, const RenderOptions& options) {
    LitMaps lit;
    // The middle of the view
    const SliceTrace ahead = traceClassic(world, eye, options, {}, lit, {1, 1, 0, 0});
    return ahead.seen.empty() || ahead.seen.back().texel.depth >= kRoom;
}

Image drawn(const World& world, const Eye& eye, const RenderOptions& options,
            const ClassicOptions& ways) {
    Image image(kWidth, kHeight);
    LitMaps lit;
    const Picture picture = {image.pixels.data(), kWidth, kHeight, kWidth};
    return drawClassic(world, eye, options, ways, lit, picture) ? image : Image();
}

bool looksDifferent(Pixel one, Pixel other) {
    const Colour a = toColour(one);
    const Colour b = toColour(other);
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) >= kVisible;
}

}  // namespace

std::optional<OldWayView> tryOldWay(const World& world, const Eye& eye, bool flying,
                                    const RenderOptions& options, const ClassicOptions& ways,
                                    int number) {
    if (number < 0 || number >= kPlaces * kViewsOfPlace) return std::nullopt;
    const int place = number / kViewsOfPlace;
    const int direction = number % kViewsOfPlace;
    std::optional<OldWayView> view =
        place == 0 ? OldWayView{.eye = eye, .flying = flying} : placeOf(world, place - 1);
    if (!view) return OldWayView{};
    view->eye.headingDegrees = wrapDegrees(view->eye.headingDegrees + 90.0 * direction);
    if (direction == kViewsOfPlace - 1) view->eye.look = kLookDown;
    RenderOptions dark = options;
    dark.baked = false;  // its work is not needed to see a difference
    const Image with = drawn(world, view->eye, dark, ways);
    const Image without = drawn(world, view->eye, dark, {});
    int different = 0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i)
        different += looksDifferent(with.pixels[i], without.pixels[i]) ? 1 : 0;
    view->share = static_cast<double>(different) / (kWidth * kHeight);
    if (number > 0 && view->eye.look == 0.0 && !hasRoomAhead(world, view->eye, dark))
        view->share *= kShareWithoutRoom;
    return view;
}

}  // namespace slicecast

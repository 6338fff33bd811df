#include "overlay/minimap_objects.h"

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

constexpr Colour kStill = {242, 232, 206, 235};
constexpr Colour kMoving = {255, 92, 196, 255};
constexpr Colour kDotRim = {20, 20, 20, 150};
constexpr double kFaint = 0.35;        // part of the alpha, for objects below the level
constexpr double kRadius = 0.3;        // of an object's width
constexpr double kLeastRadius = 0.14;  // of a tile
constexpr double kMostRadius = 0.3;
constexpr double kShortestLine = 0.4;  // units
constexpr double kLinePerSpeed = 0.3;  // seconds

Colour faded(Colour colour, double part) {
    return withAlpha(colour, static_cast<int>(colour.a * part + 0.5));
}

// How visible an object is on a level, 0 to 1.
double strengthOn(int level, const Object& object) {
    if (object.z >= tileEdge(level + 1)) return 0.0;
    return object.z + object.height > tileEdge(level) ? 1.0 : kFaint;
}

double radiusOf(const Object& object, const MinimapView& view) {
    return std::max(1.0, std::clamp(kRadius * object.width.value(), kLeastRadius, kMostRadius) *
                             view.pixelsPerTile);
}

bool isInside(const MinimapView& view, Point place, double margin) {
    const PixelRect& area = view.area;
    return place.x > area.x - margin && place.y > area.y - margin &&
           place.x < area.x + area.width + margin && place.y < area.y + area.height + margin;
}

void drawObject(const MinimapView& view, const Object& object, Colour colour, double strength,
                const Picture& picture) {
    const Point at = view.place(object.x.value(), object.y.value());
    const double radius = radiusOf(object, view);
    if (!isInside(view, at, radius + 1.0)) return;
    drawDot(picture, view.area, at, radius + 1.0, faded(kDotRim, strength));
    drawDot(picture, view.area, at, radius, faded(colour, strength));
}

// A line towards where the object moves.
void drawHeading(const MinimapView& view, const Object& object, const ObjectMotion& motion,
                 double strength, const Picture& picture) {
    const double length = kShortestLine + kLinePerSpeed * motion.speed;
    const Point from = view.place(object.x.value(), object.y.value());
    const bool isActor = motion.isActor();
    const double x = isActor ? object.facingX.value() : cosDegrees(motion.headingDegrees);
    const double y = isActor ? object.facingY.value() : sinDegrees(motion.headingDegrees);
    const Point to = view.place(object.x.value() + length * x, object.y.value() + length * y);
    if (isInside(view, from, length * view.pixelsPerTile))
        drawLine(picture, view.area, from, to, faded(kMoving, strength), view.line);
}

}  // namespace

void drawMinimapObjects(const World& world, int map, int level, const MinimapView& view,
                        const Picture& picture) {
    const std::vector<Object>& objects = world.maps[static_cast<std::size_t>(map)].objects;
    for (const Object& object : objects) {
        const double strength = strengthOn(level, object);
        if (strength > 0.0) drawObject(view, object, kStill, strength, picture);
    }
    // Moving objects again, over the others
    for (const ObjectMotion& motion : world.movingObjects.motions) {
        if (motion.map != map) continue;
        const Object& object = objects[static_cast<std::size_t>(motion.object)];
        const double strength = strengthOn(level, object);
        if (strength == 0.0) continue;
        drawHeading(view, object, motion, strength, picture);
        drawObject(view, object, kMoving, strength, picture);
    }
}

}  // namespace slicecast

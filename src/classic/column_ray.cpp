#include "classic/column_ray.h"

#include "base/angle.h"
#include "world/player.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicecast::classic {
namespace {

// If only one level is drawn, the eye stays inside it: above its base and below its top.
constexpr double kLowestEyeOfOneLevel = 1.0 / 65536.0;
constexpr double kHighestEyeOfOneLevel = 65535.0 / 65536.0;

// Height of a standing player's eye at the start, where a drifting horizon is in the middle.
double startEyeZ(const World& world) {
    return (world.start.z + kStandingEye).value();
}

}  // namespace

double SineTable::sine(double degrees) const {
    if (steps == 0) return sinDegrees(degrees);
    return sinDegrees(std::floor(wrapDegrees(degrees) * steps / 360.0) * 360.0 / steps);
}

double SineTable::cosine(double degrees) const {
    if (steps == 0) return cosDegrees(degrees);
    return cosDegrees(std::floor(wrapDegrees(degrees) * steps / 360.0) * 360.0 / steps);
}

View::View(const World& world, const Eye& eye, const RenderOptions& options,
           const ClassicOptions& classic, int pictureWidth, int pictureHeight)
    : width(pictureWidth),
      height(pictureHeight),
      distance((pictureWidth / 2.0) / tanDegrees(options.fovDegrees / 2.0)),
      horizon(pictureHeight / 2.0 + eye.look * pictureHeight),
      fovDegrees(options.fovDegrees),
      headingDegrees(eye.headingDegrees),
      eyeX(eye.x.value()),
      eyeY(eye.y.value()),
      eyeZ(eye.z.value()),
      oneLevel(classic.oneLevel),
      projection(classic.projection),
      table{classic.sineSteps} {
    if (classic.driftingHorizon) horizon += (eyeZ - startEyeZ(world)) * height;
    if (oneLevel) {
        const int levels = world.maps[static_cast<std::size_t>(eye.map)].levels;
        storey = std::clamp(eye.z.tile(), 0, levels - 1);
        eyeZ = std::clamp(eyeZ - storey, kLowestEyeOfOneLevel, kHighestEyeOfOneLevel);
    }
}

// #region ways
ColumnRay View::rayAt(double x) const {
    const double sideways = x - width / 2.0;
    ColumnRay ray;
    if (projection == ClassicProjection::plane) {
        const double slope = sideways / distance;
        const double forwardX = table.cosine(headingDegrees);
        const double forwardY = table.sine(headingDegrees);
        ray.x = forwardX - slope * forwardY;
        ray.y = forwardY + slope * forwardX;
        ray.length = std::sqrt(1.0 + slope * slope);
        ray.azimuthDegrees = headingDegrees + atanDegrees(slope);
        return ray;
    }
    // The middle of a coarse pixel may lie beyond the picture's edge. It looks no further aside
    // than the widest picture, so neither cosine is ever near 0.
    constexpr double kMostAside = kMaxFovDegrees / 2.0;
    const double angle = std::clamp(sideways * fovDegrees / width, -kMostAside, kMostAside);
    ray.azimuthDegrees = headingDegrees + angle;
    ray.x = table.cosine(ray.azimuthDegrees);
    ray.y = table.sine(ray.azimuthDegrees);
    if (projection == ClassicProjection::equalAnglesCorrected)
        ray.depthPerAlong = table.cosine(std::fabs(angle));
    ray.ahead = cosDegrees(angle);
    return ray;
}
// #endregion

double View::rowOf(double z, double depth) const {
    const double rise = up * (z - eyeZ);
    if (rise == 0.0) return horizon;
    if (depth > 0.0) return horizon - rise * distance / depth;
    return rise > 0.0 ? -std::numeric_limits<double>::infinity()
                      : std::numeric_limits<double>::infinity();
}

View View::beyond(const Portal& portal) const {
    View view = *this;
    double x = eyeX - portal.fromX - 0.5;
    double y = eyeY - portal.fromY - 0.5;
    turnArrow(portal.turn, x, y);
    view.eyeX = portal.toX + 0.5 + x;
    view.eyeY = portal.toY + 0.5 + y;
    view.headingDegrees += 90.0 * portal.turn;
    if (oneLevel) {
        view.storey += portal.levels;
    } else {
        view.eyeZ += portal.levels;
    }
    return view;
}

View View::mirroredAt(double z) const {
    View view = *this;
    view.eyeZ = 2.0 * z - eyeZ;
    view.up = -up;
    return view;
}

ColumnRay beyond(const ColumnRay& ray, const Portal& portal) {
    ColumnRay turned = ray;
    turnArrow(portal.turn, turned.x, turned.y);
    turned.azimuthDegrees += 90.0 * portal.turn;
    return turned;
}

}  // namespace slicecast::classic

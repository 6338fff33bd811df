#include "render/classic/column_ray.h"

#include "base/angle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicecast::classic {
namespace {

// Where there was one level the eye never left it.
constexpr double kLowestEyeOfOneLevel = 1.0 / 65536.0;
constexpr double kHighestEyeOfOneLevel = 65535.0 / 65536.0;

}  // namespace

double SineTable::sine(double degrees) const {
    if (steps == 0) return sinDegrees(degrees);
    return sinDegrees(std::floor(wrapDegrees(degrees) * steps / 360.0) * 360.0 / steps);
}

double SineTable::cosine(double degrees) const {
    if (steps == 0) return cosDegrees(degrees);
    return cosDegrees(std::floor(wrapDegrees(degrees) * steps / 360.0) * 360.0 / steps);
}

View::View(const Eye& eye, int levels, const RenderOptions& options, const ClassicOptions& classic,
           int pictureWidth, int pictureHeight)
    : width(pictureWidth),
      distance((pictureWidth / 2.0) / tanDegrees(options.fovDegrees / 2.0)),
      horizon(pictureHeight / 2.0 + eye.look * pictureHeight),
      fovDegrees(options.fovDegrees),
      headingDegrees(eye.headingDegrees),
      eyeX(eye.x.value()),
      eyeY(eye.y.value()),
      eyeZ(eye.z.value()),
      projection(classic.projection),
      table{classic.sineSteps} {
    if (classic.oneLevel) {
        storey = std::clamp(eye.z.tile(), 0, levels - 1);
        eyeZ = std::clamp(eyeZ - storey, kLowestEyeOfOneLevel, kHighestEyeOfOneLevel);
    }
}

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
    const double angle = sideways * fovDegrees / width;
    ray.azimuthDegrees = headingDegrees + angle;
    ray.x = table.cosine(ray.azimuthDegrees);
    ray.y = table.sine(ray.azimuthDegrees);
    if (projection == ClassicProjection::equalAnglesCorrected)
        ray.depthPerAlong = table.cosine(std::fabs(angle));
    return ray;
}

double View::rowOf(double height, double depth) const {
    const double rise = height - eyeZ;
    if (rise == 0.0) return horizon;
    if (depth > 0.0) return horizon - rise * distance / depth;
    return rise > 0.0 ? -std::numeric_limits<double>::infinity()
                      : std::numeric_limits<double>::infinity();
}

}  // namespace slicecast::classic

#include "render/projection.h"

#include "base/angle.h"

namespace slicecast {

Projection::Projection(const Eye& eye, const RenderOptions& options, int pictureWidth, int pictureHeight) : width(pictureWidth), height(pictureHeight) {
    distance = (width / 2.0) / tanDegrees(options.fovDegrees / 2.0);
    horizon = height / 2.0 + eye.look * height;
    const SineCosine heading = sineCosineDegrees(eye.headingDegrees);
    forward = {heading.cosine, heading.sine};
    right = {-heading.sine, heading.cosine};
    horizonBelow = horizon + 0.5;
    heightBelow = height + 0.5;
    firstFallingRow = firstRowBelowRow(horizon, false);
}

}  // namespace slicecast

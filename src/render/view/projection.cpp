#include "render/view/projection.h"

#include "base/angle.h"

namespace slicecast {

Projection::Projection(const Eye& eye, const RenderOptions& options, int pictureWidth,
                       int pictureHeight)
    : width(pictureWidth), height(pictureHeight) {
    // #region horizon
    distance = (width / 2.0) / tanDegrees(options.fovDegrees / 2.0);
    const SineCosine heading = sineCosineDegrees(eye.headingDegrees);
    forward = {heading.cosine, heading.sine};
    right = {-heading.sine, heading.cosine};
    heightBelow = height + 0.5;
    setHorizon(height / 2.0 + eye.look * height);
    // #endregion
}

void Projection::setHorizon(double row) {
    horizon = row;
    horizonBelow = row + 0.5;
    firstFallingRow = firstRowBelowRow(row, false);
}

Projection Projection::mirrored() const {
    Projection upsideDown = *this;
    upsideDown.setHorizon(height - horizon);
    return upsideDown;
}

}  // namespace slicecast

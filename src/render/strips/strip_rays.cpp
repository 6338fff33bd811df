#include "render/strips/strip_rays.h"

#include "render/spans/grid_walk.h"

#include <algorithm>
#include <cmath>

namespace slicecast {

bool StripRays::aim(const Vista& vista, int first, int count) {
    const Viewpoint& eye = vista.viewpoint;
    const Map& map = *vista.map;
    const GroundDirection middle = vista.ray(first + count / 2);
    alongX = std::fabs(middle.x) >= std::fabs(middle.y);
    stepU = (alongX ? middle.x : middle.y) > 0.0 ? 1 : -1;
    alongPerU = kNever;
    alongPerUMost = 0.0;
    LaneValues steps;
    for (int i = 0; i < kLanes; ++i) {
        const GroundDirection ray = vista.ray(first + std::min(i, count - 1));
        const double u = (alongX ? ray.x : ray.y) * stepU;
        const double v = alongX ? ray.y : ray.x;
        if (u <= 0.0 || std::fabs(v) > 2.0 * u) return false;
        speedU[indexOf(i)] = u;
        speedV[indexOf(i)] = v == 0.0 ? 1.0 : std::fabs(v);  // as in GridWalk
        rayV[indexOf(i)] = v;
        slope[indexOf(i)] = v / u;
        stepV[indexOf(i)] = v > 0.0 ? 1 : v < 0.0 ? -1 : 0;
        steps.at[i] = inLane(stepV[indexOf(i)]);
        alongPerU = std::min(alongPerU, 1.0 / u);
        alongPerUMost = std::max(alongPerUMost, 1.0 / u);
    }
    stepsV = steps.lanes();
    sizeU = alongX ? map.width : map.depth;
    sizeV = alongX ? map.depth : map.width;
    eyeU = alongX ? eye.tileX() : eye.tileY();
    eyeV = alongX ? eye.tileY() : eye.tileX();
    fractionU = alongX ? eye.fractionX() : eye.fractionY();
    fractionV = alongX ? eye.fractionY() : eye.fractionX();
    return true;
}

}  // namespace slicecast

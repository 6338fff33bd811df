// The coordinates of a side view: perpendicular depths, and heights above the floor of the eye's
// map. Behind portals that lead up or down, both continue from the eye without a jump.
#pragma once

#include "overlay/lines.h"
#include "render/trace.h"

#include <algorithm>
#include <cmath>

namespace slicecast {

struct SidePlot {
    PixelRect area;
    int scale = 1;        // of text and thick lines
    int line = 1;         // width of fine lines, pixels
    double depth = 1.0;   // at the right edge, units
    double lowest = 0.0;  // height at the lower edge, units
    double highest = 1.0;
    double eyeZ = 0.0;

    double x(double units) const { return area.x + std::min(units / depth, 1.0) * area.width; }
    double y(double units) const {
        return area.y + area.height - (units - lowest) / (highest - lowest) * area.height;
    }

    // The point of a ray with this upward slope at a depth, clamped to the plot.
    Point onRay(double slope, double at) const {
        double t = std::clamp(at, 0.0, depth);
        if (slope < 0.0) t = std::min(t, (eyeZ - lowest) / -slope);
        if (slope > 0.0) t = std::min(t, std::max(0.0, highest - eyeZ) / slope);
        return {x(t), y(eyeZ + slope * t)};
    }
};

// The upward slope of the ray through a row's upper edge.
inline double slopeOfRow(const SliceTrace& trace, double row) {
    return (trace.horizonRow - row) / trace.projectionDistance;
}

// The height that a row shows at a depth.
inline double heightInRow(const SliceTrace& trace, double eyeZ, double row, double depth) {
    return std::isfinite(row) && std::isfinite(depth) ? eyeZ + slopeOfRow(trace, row) * depth
                                                      : eyeZ;
}

}  // namespace slicecast

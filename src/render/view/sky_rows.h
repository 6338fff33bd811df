// Draws the sky: one colour, a gradient over the slope, or a panorama; or a sky with layers
// (sky_layers.h). Never lit, never in fog, without levels of detail.
//
//     gradient   low + (high - low) * min(1, s / slope)
//     panorama   column floor(fraction(azimuth / 360) * W), azimuth = heading + atan(k);
//                row floor((1 - min(1, s / slope)) * H)
#pragma once

#include "render/view/projection.h"
#include "render/view/sky_layers.h"
#include "slicecast/colour.h"
#include "world/sky.h"

#include <cstdint>
#include <vector>

namespace slicecast {

class SkyRows {
public:
    void beginFrame(const Sky& sky, const Projection& projection, double headingDegrees,
                    std::int64_t steps);

    // Fills the rows [first, last) of the slice that starts at `slice`; they must not be below the
    // horizon.
    void fill(Pixel* slice, int column, int first, int last);

private:
    void findAzimuths(const Projection& projection);
    int columnOf(int column, int count) const;
    void fetch(int skyColumn, int first, int last);
    void fetchRows(int first, int last);

    const Sky* sky_ = nullptr;
    double headingDegrees_ = 0.0;
    bool hasLayers_ = false;
    SkyLayers layers_;
    std::vector<Pixel> colours_;  // by row: the gradient, or one column of panorama or squares
    int fetchedColumn_ = -1;      // which one, and its rows that are there
    int fetchedFirst_ = 0;
    int fetchedLast_ = 0;
    std::vector<int> panoramaOffsets_;  // panorama: start of each row's texels
    std::vector<double> azimuths_;      // atan(k) by column, degrees
    int azimuthWidth_ = 0;              // the picture's shape for which they were computed
    double azimuthDistance_ = 0.0;
};

}  // namespace slicecast

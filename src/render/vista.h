// A vista: a map as some rays of a frame see it. The eye's own map is one; what portals lead to is
// laid on behind them, turned and shifted, and seen as if the eye stood there; what shows in a
// mirror is seen from as far below it as the eye is above, upside down (see Projection::mirrored):
//
//         eye  o                          Beyond a mirror at height h a ray of slope s runs like one of slope -s that comes from height 2 h - z, and is the true one
//               \     . reflected         where it is above h. So whatever is drawn of blocks can be drawn of reflections too.
//      h  -------\---/------- mirror
//                 \ /
//                  X
//                 /
//     2 h - z    o
//
// All numbers here are in the coordinates of the map: eye, rays and heights are turned and shifted
// into them, which rounds nothing.
#pragma once

#include "render/detail.h"
#include "render/eye.h"
#include "render/frame_objects.h"
#include "render/options.h"
#include "render/plane_looks.h"
#include "render/projection.h"
#include "render/shading.h"
#include "render/sky_rows.h"
#include "render/viewpoint.h"
#include "world/world.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace slicecast {

// Where the eye seems to be for those who have come through a portal.
Viewpoint throughPortal(const Viewpoint& from, const Portal& portal);

// How rays run over the rows of a picture, upright or upside down.
struct FrameRays {
    const Projection& projection;
    const double* inverseOffsets;  // 1 / |horizon - (row + 0.5)| by row
};

// What all vistas of a frame have in common.
struct FrameView {
    const World* world = nullptr;
    const Eye* eye = nullptr;
    const RenderOptions* options = nullptr;
    Detail detail;
    EyeWater water;  // that the eye is in
};

class Vista {
public:
    // All but `from` must outlive the frame. `sameMap` is another vista of the map, or null.
    void begin(const FrameView& frame, const Viewpoint& from, FrameRays rays, const Vista* sameMap);

    GroundDirection ray(int column) const {
        return turned(projection->ray(column), viewpoint.turn);
    }

    Viewpoint viewpoint;
    const Map* map = nullptr;
    const Projection* projection = nullptr;
    const double* inverseOffsets = nullptr;
    Lighting lighting;
    int firstFloorRow = 0;  // rows above it, down to the horizon, look beyond the map's `far`
    double highest = 0.0;   // no block, no ceiling and no object lies higher, units
    ObjectCells ownCells;   // filled in the first vista of a map
    const ObjectCells* cells = nullptr;  // of the map
    FrameObjects objects;
    PlaneLooks planeLooks;
    SkyRows skyRows;
};

// The vistas of a frame, found when first asked for. Their memory is kept from frame to frame.
class Vistas {
public:
    // Forgets all but the memory. What is given here must outlive the frame.
    void beginFrame(const World& world, const Eye& eye, const RenderOptions& options, int width,
                    int height);

    Vista& ofEye() { return find(eyeView_); }
    Vista& through(const Vista& from, const Portal& portal) {
        return find(throughPortal(from.viewpoint, portal));
    }
    // In a mirror at a height of the vista's map, 1/65536 units.
    Vista& mirrored(const Vista& from, std::int32_t height);

    const Projection& projection() const { return *projection_; }
    // The most fog of each row, for an eye in water; else null.
    const std::uint8_t* waterFogs() const {
        return frame_.water.water != nullptr ? waterFogs_.data() : nullptr;
    }

private:
    Vista& find(const Viewpoint& from);
    void findWater();

    FrameView frame_;
    Viewpoint eyeView_;
    std::unique_ptr<Projection> projection_;          // upright
    std::unique_ptr<Projection> mirroredProjection_;  // upside down
    std::vector<double> inverseOffsets_;
    std::vector<double> mirroredInverseOffsets_;
    std::vector<std::uint8_t> waterFogs_;  // by row: the fog where its rays leave the eye's water
    std::vector<std::unique_ptr<Vista>> vistas_;
    std::size_t used_ = 0;
};

}  // namespace slicecast

// A vista: a map as some rays of a frame see it. The eye's own map is one. The map behind a portal
// is seen as if the eye were in it, turned and shifted by the portal. A map in a mirror is seen
// upside down, from as far below the mirror as the eye is above it (see Projection::mirrored):
//
//         eye  o
//               \     . reflected
//      h  -------\---/------- mirror
//                 \ /
//                  X
//                 /
//     2 h - z    o
//
// A ray of slope -s that meets a mirror at height h rises with slope s afterwards, as if it came
// from height 2 h - z. So reflections are drawn by the same code as everything else.
//
// All numbers here are in the coordinates of the map: eye, rays and heights are turned and shifted
// into them without rounding.
#pragma once

#include "base/keyed_pool.h"
#include "render/eye.h"
#include "render/options.h"
#include "render/view/detail.h"
#include "render/view/frame_objects.h"
#include "render/view/plane_looks.h"
#include "render/view/projection.h"
#include "render/view/shading.h"
#include "render/view/sky_rows.h"
#include "render/view/viewpoint.h"
#include "world/world.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace slicecast {

class LitMap;
class LitMaps;

// Where the eye appears to be for rays that have passed a portal.
Viewpoint throughPortal(const Viewpoint& from, const Portal& portal);

// The rows of a picture, upright or upside down.
struct FrameRays {
    const Projection& projection;
    const double* inverseOffsets;  // 1 / |horizon - (row + 0.5)| by row
};

// Values shared by all vistas of a frame.
struct FrameView {
    const World* world = nullptr;
    const Eye* eye = nullptr;
    const RenderOptions* options = nullptr;
    LitMaps* lit = nullptr;
    Detail detail;
    EyeWater water;  // around the eye
};

class Vista {
public:
    // All but `from` must outlive the frame. `sameMap` is another vista of the map, or null.
    void begin(const FrameView& frame, const Viewpoint& from, FrameRays rays, const Vista* sameMap,
               FrameObjectRoom& room);

    GroundDirection ray(int column) const {
        return turned(projection->ray(column), viewpoint.turn);
    }

    Viewpoint viewpoint;
    const Map* map = nullptr;
    LitMap* lit = nullptr;  // its baked light; null if it has none
    const Projection* projection = nullptr;
    const double* inverseOffsets = nullptr;
    Lighting lighting;
    int firstFloorRow = 0;  // rows above it, down to the horizon, look beyond the map's `far`
    double highest = 0.0;   // no block, ceiling or object is higher, units
    ObjectCells ownCells;   // filled only in the first vista of a map
    const ObjectCells* cells = nullptr;  // of the map: its own or another vista's
    FrameObjects objects;
    PlaneLooks planeLooks;
    SkyRows skyRows;
};

// The vistas of a frame, made when first needed. Memory is kept from frame to frame.
class Vistas {
public:
    // Forgets all vistas; keeps their memory. The arguments must outlive the frame.
    void beginFrame(const World& world, const Eye& eye, const RenderOptions& options, LitMaps& lit,
                    int width, int height);

    Vista& ofEye() { return find(eyeView_); }
    Vista& through(const Vista& from, const Portal& portal) {
        return find(throughPortal(from.viewpoint, portal));
    }
    // In a mirror at a height of the vista's map, 1/65536 units.
    Vista& mirrored(const Vista& from, std::int32_t height);

    const Projection& projection() const { return *projection_; }
    // The fog limit of each row for an eye in water; null for an eye in air.
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
    KeyedPool<Viewpoint, Vista> vistas_;
    std::vector<const Vista*> firstOfMaps_;  // by map: its first vista in this frame, or null
    FrameObjectRoom objectRoom_;
};

}  // namespace slicecast

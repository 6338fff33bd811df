// What all slices of a picture share: worked out once a frame.
#pragma once

#include "render/detail.h"
#include "render/eye.h"
#include "render/frame_objects.h"
#include "render/options.h"
#include "render/plane_shades.h"
#include "render/projection.h"
#include "render/shading.h"
#include "render/sky_rows.h"
#include "world/world.h"

#include <vector>

namespace slicecast {

// A texture as it stands at the time of a frame.
struct FrameTexture {
    const TextureLevel* levels = nullptr;
    int size = 0;  // texels a side
    int last = 0;  // index of the last level
    bool seeThrough = false;
};

struct Frame {
    const World* world = nullptr;
    const Map* map = nullptr;
    Eye eye;
    Projection projection;
    Lighting lighting;
    Detail detail;
    int firstFloorRow = 0;               // rows above it, down to the horizon, look beyond the map's `far`
    double highest = 0.0;                // no block and no ceiling lies higher, units
    std::vector<double>& inverseOffsets;  // 1 / |horizon - (row + 0.5)| by row
    std::vector<FrameTexture>& textures;  // by TextureId
    FrameObjects& objects;
    PlaneShades& planeShades;
    SkyRows& skyRows;

    Frame(const World& w, const Eye& e, const RenderOptions& options, int width, int height, std::vector<double>& slopes, std::vector<FrameTexture>& current, FrameObjects& seenObjects,
          PlaneShades& shades, SkyRows& sky);
};

}  // namespace slicecast

// What all slices of a picture share: worked out once a frame.
#pragma once

#include "render/detail.h"
#include "render/eye.h"
#include "render/options.h"
#include "render/vista.h"
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
    Detail detail;
    double mirrors = 1.0;                 // see RenderOptions
    std::vector<FrameTexture>& textures;  // by TextureId
    Vistas& vistas;

    // The vectors and vistas are the caller's, which keeps them from frame to frame. The eye and
    // the options must outlive the frame.
    Frame(const World& w, const Eye& e, const RenderOptions& options, int width, int height,
          std::vector<FrameTexture>& current, Vistas& seen);
};

}  // namespace slicecast

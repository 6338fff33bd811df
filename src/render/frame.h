// Values shared by all slices of a picture, computed once per frame.
#pragma once

#include "render/detail.h"
#include "render/eye.h"
#include "render/lit_maps.h"
#include "render/options.h"
#include "render/ripples.h"
#include "render/vista.h"
#include "world/world.h"

#include <vector>

namespace slicecast {

// A texture at the time of a frame.
struct FrameTexture {
    const TextureLevel* levels = nullptr;
    int size = 0;  // texels a side
    int last = 0;  // index of the last level
    bool seeThrough = false;
    bool invisible = false;  // no texel shows anything
};

// Memory that frames reuse: keep one for pictures that are drawn repeatedly.
struct FrameMemory {
    std::vector<FrameTexture> textures;
    LitMaps lit;
    Vistas vistas;
    RippleMemory ripples;
};

struct Frame {
    const World* world = nullptr;
    Detail detail;
    double mirrors = 1.0;                 // see RenderOptions
    int rippleRows = 0;                   // how far ripples move reflections at most; 0 for none
    std::vector<FrameTexture>& textures;  // by TextureId
    LitMaps& lit;
    Vistas& vistas;
    RippleMemory& ripples;

    // World, eye, options and memory must outlive the frame.
    Frame(const World& w, const Eye& e, const RenderOptions& options, int width, int height,
          FrameMemory& memory);
};

}  // namespace slicecast

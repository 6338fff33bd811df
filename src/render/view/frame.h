// Values shared by all slices of a picture, computed once per frame.
#pragma once

#include "render/eye.h"
#include "render/light/lit_maps.h"
#include "render/options.h"
#include "render/view/detail.h"
#include "render/view/vista.h"
#include "world/world.h"

#include <array>
#include <cstddef>
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

// Scratch memory for the ripples of a column: see ripples.h.
struct RippleMemory {
    std::vector<int> planes;  // by row: 0 for no mirror, equal numbers for one plane
    std::vector<int> rows;    // by row of a mirror: the row whose reflection it shows

    // Of the last few planes with ripples: see squaresOf in ripples.cpp.
    struct Squares {
        double perSquare = 0.0;
        double horizon = 0.0;
        std::vector<double> byRow;
    };
    std::array<Squares, 4> squares;
    std::size_t oldest = 0;
};

// How far ripples move reflections at most.
inline int mostRippleRows(int height) {
    return height / 24;
}

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

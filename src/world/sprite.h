// Sprites: the pictures of objects, of any size up to kMaxSpriteSide a side, with levels of detail.
// Like those of textures, each level is made from the one before, 2 x 2 texels at a time, but only
// while both sides are even. A sheet has frames side by side.
#pragma once

#include "base/image.h"
#include "world/texel_runs.h"

#include <string>
#include <vector>

namespace slicecast {

struct SpriteLevel {
    int width = 0;  // texels
    int height = 0;
    std::vector<Pixel> texels;  // column after column: texel (u, v) is texels[u * height + v]
    TexelRuns runs = {};
};

struct Sprite {
    std::string name;
    std::vector<std::vector<SpriteLevel>> frames;
    double rate = 0.0;  // frames per second, repeating; 0 for a single frame

    // The frame shown at a time: floor(seconds * rate) modulo the number of frames.
    const std::vector<SpriteLevel>& levelsAt(double seconds) const;
};

Sprite makeSprite(std::string name, const Image& image, int frames = 1, double rate = 0.0);

}  // namespace slicecast

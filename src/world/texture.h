// Block textures: square, N x N texels with N a power of two from 8 to 1024, with levels of detail.
//
// A texture coordinate (u, v) is a fraction of a tile: u = 0 at the left, v = 0 at the top of the
// image. Level 0 is the image; each further level has half as many texels a side, down to 1. Level
// m + 1 is made from level m, 2 x 2 texels at a time:
//
//     a      = (a0 + a1 + a2 + a3 + 2) / 4
//     colour = (sum of c * a + half the sum of a) / sum of a, 0 where that sum is 0
//                                                       (integers, halves rounded down)
#pragma once

#include "base/image.h"
#include "base/shared_vector.h"
#include "slicecast/sound.h"
#include "world/texel_runs.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slicecast {

struct TextureLevel {
    int size = 0;               // texels a side
    int bits = 0;               // size = 1 << bits
    std::vector<Pixel> texels;  // columns one after another, because walls are drawn downwards:
                                // texel (u, v) is texels[(u << bits) + v]
    TexelRuns runs = {};        // empty if all texels are opaque
};

struct Texture {
    std::string name;
    // [0] is the image, or a sheet's first frame; the last one is a single texel. Textures of the
    // same picture share them.
    SharedVector<TextureLevel> levels;
    std::vector<SharedVector<TextureLevel>> laterFrames;
    double rate = 0.0;        // frames per second, repeating; 0 for a single or held frame
    bool seeThrough = false;  // a texel has alpha below 255
    Material material = Material::stone;

    int size() const { return levels[0].size; }
    int frames() const { return 1 + static_cast<int>(laterFrames.size()); }
    // A sheet without a rate: shows its first frame, and on a gate the frame of the gate's
    // progress.
    bool isHeld() const { return frames() > 1 && rate == 0.0; }

    // The frame shown after so many steps.
    int frameAt(std::int64_t steps) const;
    const SharedVector<TextureLevel>& levelsOf(int frame) const {
        return frame == 0 ? levels : laterFrames[static_cast<std::size_t>(frame - 1)];
    }
};

// Of the first frame; none where all of it is a hole.
std::optional<Colour> averageColour(const Texture& texture);

// The columns of a sheet's frame, `width` pixels wide; of its rows those from `top` on.
std::vector<Pixel> columnsOf(const Image& sheet, int frame, int width, int top, int height);

// The next level of detail of columns of `height` texels; both sides must be even.
std::vector<Pixel> halved(const std::vector<Pixel>& columns, int height);

// The frame shown after so many steps at a rate per second: floor(p / 120) modulo `frames`, p being
// steps * rate, which is rounded as any double is; 0 for negative steps.
int frameAt(std::int64_t steps, double rate, int frames);

// A frame of a sheet of square frames side by side, in all sizes. `seeThrough`: of the whole sheet.
std::vector<TextureLevel> textureFrame(const Image& sheet, int frame, bool seeThrough);

// Makes the levels of a square image whose side is a power of two, or of a sheet of `frames` such
// images side by side. Of stone.
Texture makeTexture(std::string name, const Image& image, int frames = 1, double rate = 0.0);

}  // namespace slicecast

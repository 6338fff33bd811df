// Sprites: the pictures of objects, of any size up to kMaxSpriteSide a side, with levels of detail.
// Like those of textures, each level is made from the one before, 2 x 2 texels at a time, but only
// while both sides are even. A sheet has frames side by side, and may have four rows: the front,
// the right side, the back and the left side.
#pragma once

#include "base/image.h"
#include "base/shared_vector.h"
#include "world/object.h"
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
    // Row after row. Sprites of the same picture share them.
    std::vector<SharedVector<SpriteLevel>> frames;
    double rate = 0.0;  // frames per second, repeating; 0 for a single frame
    int views = 1;      // rows: 1 or kSpriteViews

    // The frame of a row that is shown after so many steps, as of a texture.
    const SharedVector<SpriteLevel>& levelsAt(std::int64_t steps,
                                              ObjectSide view = ObjectSide::front) const;
};

// A frame of a sheet of frames side by side, in all sizes; frames are counted row after row.
std::vector<SpriteLevel> spriteFrame(const Image& sheet, int frame, int frames, int views);

Sprite makeSprite(std::string name, const Image& image, int frames = 1, double rate = 0.0,
                  int views = 1);

}  // namespace slicecast

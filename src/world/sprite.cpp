#include "world/sprite.h"

#include "world/texture.h"

#include <utility>

namespace slicecast {
const std::vector<SpriteLevel>& Sprite::levelsAt(double seconds) const {
    return frames[static_cast<std::size_t>(
        frameAt(seconds, rate, static_cast<int>(frames.size())))];
}

Sprite makeSprite(std::string name, const Image& image, int frames, double rate) {
    Sprite sprite;
    sprite.name = std::move(name);
    sprite.rate = frames > 1 ? rate : 0.0;
    for (int frame = 0; frame < frames; ++frame) {
        int width = image.width / frames;
        int height = image.height;
        std::vector<SpriteLevel> levels = {{width, height, columnsOf(image, frame, width)}};
        for (; width % 2 == 0 && height % 2 == 0; width /= 2, height /= 2) {
            levels.push_back({width / 2, height / 2, halved(levels.back().texels, height)});
        }
        for (SpriteLevel& level : levels) level.runs = TexelRuns(level.texels, level.height);
        sprite.frames.push_back(std::move(levels));
    }
    return sprite;
}

}  // namespace slicecast

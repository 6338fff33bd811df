#include "world/sprite.h"

#include "world/texture.h"

#include <utility>

namespace slicecast {
namespace {

SpriteLevel columnsOf(const Image& image) {
    SpriteLevel level;
    level.width = image.width;
    level.height = image.height;
    level.texels.reserve(image.pixels.size());
    for (int u = 0; u < image.width; ++u) {
        for (int v = 0; v < image.height; ++v) level.texels.push_back(image.at(u, v));
    }
    return level;
}

}  // namespace

const std::vector<SpriteLevel>& Sprite::levelsAt(double seconds) const {
    return frames[static_cast<std::size_t>(frameAt(seconds, rate, static_cast<int>(frames.size())))];
}

Sprite makeSprite(std::string name, Image image, int frames, double rate) {
    Sprite sprite;
    sprite.name = std::move(name);
    sprite.rate = frames > 1 ? rate : 0.0;
    for (int frame = 0; frame < frames; ++frame) {
        Image level = frameOf(image, frame, image.width / frames);
        std::vector<SpriteLevel> levels = {columnsOf(level)};
        while (level.width % 2 == 0 && level.height % 2 == 0) {
            level = halved(level);
            levels.push_back(columnsOf(level));
        }
        sprite.frames.push_back(std::move(levels));
    }
    sprite.image = std::move(image);
    return sprite;
}

}  // namespace slicecast

#include "world/sprite.h"

#include "world/texture.h"

#include <utility>

namespace slicecast {
const std::vector<SpriteLevel>& Sprite::levelsAt(std::int64_t steps, ObjectSide view) const {
    const int count = static_cast<int>(frames.size()) / views;
    const int row = views == 1 ? 0 : static_cast<int>(view);
    return frames[static_cast<std::size_t>(row * count + frameAt(steps, rate, count))];
}

Sprite makeSprite(std::string name, const Image& image, int frames, double rate, int views) {
    Sprite sprite;
    sprite.name = std::move(name);
    sprite.rate = frames > 1 ? rate : 0.0;
    sprite.views = views;
    const int rowHeight = image.height / views;
    for (int i = 0; i < frames * views; ++i) {
        int width = image.width / frames;
        int height = rowHeight;
        std::vector<SpriteLevel> levels = {
            {width, height, columnsOf(image, i % frames, width, i / frames * height, height)}};
        for (; width % 2 == 0 && height % 2 == 0; width /= 2, height /= 2) {
            levels.push_back({width / 2, height / 2, halved(levels.back().texels, height)});
        }
        for (SpriteLevel& level : levels) level.runs = TexelRuns(level.texels, level.height);
        sprite.frames.push_back(std::move(levels));
    }
    return sprite;
}

}  // namespace slicecast

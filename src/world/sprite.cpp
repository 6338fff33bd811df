#include "world/sprite.h"

#include "world/texture.h"

#include <utility>

namespace slicecast {
const SharedVector<SpriteLevel>& Sprite::levelsAt(std::int64_t steps, ObjectSide view) const {
    const int count = static_cast<int>(frames.size()) / views;
    const int row = views == 1 ? 0 : static_cast<int>(view);
    return frames[static_cast<std::size_t>(row * count + frameAt(steps, rate, count))];
}

std::vector<SpriteLevel> spriteFrame(const Image& sheet, int frame, int frames, int views) {
    int width = sheet.width / frames;
    int height = sheet.height / views;
    std::vector<SpriteLevel> levels = {
        {width, height, columnsOf(sheet, frame % frames, width, frame / frames * height, height)}};
    for (; width % 2 == 0 && height % 2 == 0; width /= 2, height /= 2)
        levels.push_back({width / 2, height / 2, halved(levels.back().texels, height)});
    for (SpriteLevel& level : levels) level.runs = TexelRuns(level.texels, level.height);
    return levels;
}

Sprite makeSprite(std::string name, const Image& image, int frames, double rate, int views) {
    Sprite sprite;
    sprite.name = std::move(name);
    sprite.rate = frames > 1 ? rate : 0.0;
    sprite.views = views;
    for (int frame = 0; frame < frames * views; ++frame)
        sprite.frames.push_back(spriteFrame(image, frame, frames, views));
    return sprite;
}

}  // namespace slicecast

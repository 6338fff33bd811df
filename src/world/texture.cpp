#include "world/texture.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace slicecast {
namespace {

TextureLevel columnsOf(const Image& image) {
    TextureLevel level;
    level.size = image.width;
    level.bits = std::countr_zero(static_cast<unsigned>(image.width));
    level.texels.resize(image.pixels.size());
    for (int u = 0; u < image.width; ++u) {
        for (int v = 0; v < image.height; ++v) level.texels[static_cast<std::size_t>((u << level.bits) + v)] = image.at(u, v);
    }
    return level;
}

Image halved(const Image& image) {
    Image half(image.width / 2, image.height / 2);
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            const Colour four[4] = {toColour(image.at(2 * x, 2 * y)), toColour(image.at(2 * x + 1, 2 * y)), toColour(image.at(2 * x, 2 * y + 1)),
                                    toColour(image.at(2 * x + 1, 2 * y + 1))};
            int alpha = 0;
            int red = 0;
            int green = 0;
            int blue = 0;
            for (const Colour& c : four) {
                alpha += c.a;
                red += c.r * c.a;
                green += c.g * c.a;
                blue += c.b * c.a;
            }
            const auto weighted = [alpha](int sum) { return static_cast<std::uint8_t>(alpha == 0 ? 0 : (sum + alpha / 2) / alpha); };
            half.at(x, y) = toPixel({weighted(red), weighted(green), weighted(blue), static_cast<std::uint8_t>((alpha + 2) / 4)});
        }
    }
    return half;
}

}  // namespace

Texture makeTexture(std::string name, Image image) {
    Texture texture;
    texture.name = std::move(name);
    texture.seeThrough = std::any_of(image.pixels.begin(), image.pixels.end(), [](Pixel pixel) { return toColour(pixel).a < 255; });
    Image level = image;
    texture.image = std::move(image);
    texture.levels.push_back(columnsOf(level));
    while (level.width > 1) {
        level = halved(level);
        texture.levels.push_back(columnsOf(level));
    }
    return texture;
}

}  // namespace slicecast

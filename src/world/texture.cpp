#include "world/texture.h"

#include <algorithm>
#include <bit>
#include <cmath>
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

std::vector<TextureLevel> levelsOf(Image image) {
    std::vector<TextureLevel> levels = {columnsOf(image)};
    while (image.width > 1) {
        image = halved(image);
        levels.push_back(columnsOf(image));
    }
    return levels;
}

}  // namespace

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

Image frameOf(const Image& sheet, int frame, int width) {
    Image image(width, sheet.height);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < width; ++x) image.at(x, y) = sheet.at(frame * width + x, y);
    }
    return image;
}

int frameAt(double seconds, double rate, int frames) {
    if (frames <= 1 || !(seconds > 0.0)) return 0;
    return std::min(frames - 1, static_cast<int>(std::fmod(std::floor(seconds * rate), static_cast<double>(frames))));
}

Texture makeTexture(std::string name, Image image, int frames, double rate) {
    Texture texture;
    texture.name = std::move(name);
    texture.rate = frames > 1 ? rate : 0.0;
    texture.seeThrough = std::any_of(image.pixels.begin(), image.pixels.end(), [](Pixel pixel) { return toColour(pixel).a < 255; });
    texture.levels = levelsOf(frames > 1 ? frameOf(image, 0, image.height) : image);
    for (int frame = 1; frame < frames; ++frame) texture.laterFrames.push_back(levelsOf(frameOf(image, frame, image.height)));
    texture.image = std::move(image);
    return texture;
}

int Texture::frameAt(double seconds) const { return slicecast::frameAt(seconds, rate, frames()); }

}  // namespace slicecast

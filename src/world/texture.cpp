#include "world/texture.h"

#include "world/time_step.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace slicecast {
namespace {

// `count` pixels that the caller overwrites. Copying some is far faster than constructing zeros.
std::vector<Pixel> firstOf(const std::vector<Pixel>& pixels, std::size_t count) {
    return {pixels.data(), pixels.data() + count};
}

// The mean of four texels, weighted by alpha.
Pixel meanByAlpha(const Pixel (&four)[4]) {
    unsigned alpha = 0;
    unsigned red = 0;
    unsigned green = 0;
    unsigned blue = 0;
    for (const Pixel pixel : four) {
        const Colour c = toColour(pixel);
        alpha += c.a;
        red += unsigned{c.r} * c.a;
        green += unsigned{c.g} * c.a;
        blue += unsigned{c.b} * c.a;
    }
    if (alpha == 0) return 0;
    const auto weighted = [alpha](unsigned sum) {
        return static_cast<std::uint8_t>((sum + alpha / 2) / alpha);
    };
    return toPixel({weighted(red), weighted(green), weighted(blue),
                    static_cast<std::uint8_t>((alpha + 2) / 4)});
}

// The same for four opaque texels, but faster: then (sum * 255 + 510) / 1020 is (sum + 2) / 4.
// Works on two channels at a time, with 16 bits for each sum.
// #region mean-of-four
Pixel mean(const Pixel (&four)[4]) {
    constexpr Pixel kChannels = 0x00ff00ff;
    constexpr Pixel kHalf = 0x00020002;
    Pixel even = kHalf;
    Pixel odd = kHalf;
    for (const Pixel pixel : four) {
        even += pixel & kChannels;
        odd += (pixel >> 8) & kChannels;
    }
    return ((even >> 2) & kChannels) | ((odd >> 2) & kChannels) << 8;
}
// #endregion

}  // namespace

std::vector<Pixel> columnsOf(const Image& sheet, int frame, int width, int top, int height) {
    std::vector<Pixel> columns =
        firstOf(sheet.pixels, static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const Pixel* row =
            &sheet
                 .pixels[static_cast<std::size_t>(top + y) * static_cast<std::size_t>(sheet.width) +
                         static_cast<std::size_t>(frame * width)];
        Pixel* out = columns.data() + y;
        for (int x = 0; x < width; ++x, out += height) *out = row[x];
    }
    return columns;
}

std::optional<Colour> averageColour(const Texture& texture) {
    const Colour colour = toColour(texture.levels.back().texels[0]);
    return colour.a == 0 ? std::nullopt : std::optional(colour);
}

std::vector<Pixel> halved(const std::vector<Pixel>& columns, int height) {
    std::vector<Pixel> half = firstOf(columns, columns.size() / 4);
    const Pixel* left = columns.data();
    Pixel* out = half.data();
    for (const Pixel* end = left + columns.size(); left != end; left += height) {
        const Pixel* right = left + height;
        for (int y = 0; y < height; y += 2, left += 2, right += 2) {
            const Pixel four[4] = {left[0], left[1], right[0], right[1]};
            const bool isOpaque = (four[0] & four[1] & four[2] & four[3]) >> 24 == 255;
            *out++ = isOpaque ? mean(four) : meanByAlpha(four);
        }
    }
    return half;
}

std::vector<TextureLevel> textureFrame(const Image& sheet, int frame, bool seeThrough) {
    std::vector<TextureLevel> levels;
    bool isPlain = false;  // all texels are alike, and opaque: then so are those of all sizes
    for (int size = sheet.height; size >= 1; size /= 2) {
        const auto area = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
        std::vector<Pixel> texels = levels.empty() ? columnsOf(sheet, frame, size, 0, size)
                                    : isPlain      ? std::vector<Pixel>(area, levels[0].texels[0])
                                                   : halved(levels.back().texels, 2 * size);
        if (levels.empty())
            isPlain = !seeThrough && std::all_of(texels.begin(), texels.end(),
                                                 [&](Pixel texel) { return texel == texels[0]; });
        TexelRuns runs = seeThrough ? TexelRuns(texels, size) : TexelRuns();
        levels.push_back({size, std::countr_zero(static_cast<unsigned>(size)), std::move(texels),
                          std::move(runs)});
    }
    return levels;
}

// The quotient's floor is exact: a double that is less than a multiple of 120 is less by more than
// the division rounds away.
int frameAt(std::int64_t steps, double rate, int frames) {
    if (frames <= 1 || steps <= 0) return 0;
    const double shown = std::floor(static_cast<double>(steps) * rate / kStepsPerSecond);
    return static_cast<int>(std::fmod(shown, static_cast<double>(frames)));
}

Texture makeTexture(std::string name, const Image& image, int frames, double rate) {
    Texture texture;
    texture.name = std::move(name);
    texture.rate = frames > 1 ? rate : 0.0;
    texture.seeThrough = !image.isOpaque();
    texture.levels = textureFrame(image, 0, texture.seeThrough);
    for (int frame = 1; frame < frames; ++frame)
        texture.laterFrames.push_back(textureFrame(image, frame, texture.seeThrough));
    return texture;
}

int Texture::frameAt(std::int64_t steps) const {
    return slicecast::frameAt(steps, rate, frames());
}

}  // namespace slicecast

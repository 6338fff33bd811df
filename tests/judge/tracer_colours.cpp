// What a sight looks like: texels, levels of detail, light and fog.
#include "tracer.h"

#include "base/angle.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace slicecast::judge {
namespace {

// The next level of detail: 2 x 2 texels become one, colours weighted by alpha.
Image nextLevel(const Image& image) {
    Image next(image.width / 2, image.height / 2);
    for (int y = 0; y < next.height; ++y) {
        for (int x = 0; x < next.width; ++x) {
            int sumOfAlpha = 0;
            int sum[3] = {0, 0, 0};
            for (int i = 0; i < 4; ++i) {
                const Colour c = toColour(image.at(2 * x + i % 2, 2 * y + i / 2));
                sumOfAlpha += c.a;
                sum[0] += c.r * c.a;
                sum[1] += c.g * c.a;
                sum[2] += c.b * c.a;
            }
            Colour mean{0, 0, 0, static_cast<std::uint8_t>((sumOfAlpha + 2) / 4)};
            if (sumOfAlpha > 0) {
                mean.r = static_cast<std::uint8_t>((sum[0] + sumOfAlpha / 2) / sumOfAlpha);
                mean.g = static_cast<std::uint8_t>((sum[1] + sumOfAlpha / 2) / sumOfAlpha);
                mean.b = static_cast<std::uint8_t>((sum[2] + sumOfAlpha / 2) / sumOfAlpha);
            }
            next.at(x, y) = toPixel(mean);
        }
    }
    return next;
}

// floor(number / by), without a division that rounds.
std::int64_t wholeQuotient(double number, int by) {
    const auto whole = static_cast<std::int64_t>(std::floor(number));
    return whole / by;
}

}  // namespace

Tracer::Tracer(const World& world, const View& view) : world_(world), view_(view) {
    distance_ = (view.width / 2.0) / tanDegrees(view.fovDegrees / 2.0);
    forwardX_ = cosDegrees(view.headingDegrees);
    forwardY_ = sinDegrees(view.headingDegrees);
    // The water that the eye is in, and up to where it stands.
    const Map& map = world.maps[static_cast<std::size_t>(view.map)];
    const auto blockAt = [&](int level) -> const CellBlueprint& {
        return world.blueprints[map.cell(view.x.tile(), view.y.tile(), level)];
    };
    int level = view.z.tile();
    const double above = view.z.value() - level;
    if (const CellBlueprint& block = blockAt(level);
        block.isWater && above >= block.bottom.value() && above < block.top.value()) {
        water_ = &block;
        while (blockAt(level).top.value() == 1.0 && blockAt(level + 1).isWater &&
               blockAt(level + 1).bottom.value() == 0.0)
            ++level;
        surface_ = level + blockAt(level).top.value();
    }
    // A sheet's frames follow one another for ever.
    const auto frameOf = [&](std::size_t frames, double rate) {
        const double product = static_cast<double>(world.steps) * rate;
        return static_cast<std::size_t>(wholeQuotient(product, 120) %
                                        static_cast<std::int64_t>(frames));
    };
    const auto levelsOf = [](const std::vector<Pixel>& columns, int width, int height) {
        Image shown(width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x)
                shown.at(x, y) = columns[static_cast<std::size_t>(x * height + y)];
        }
        std::vector<Image> levels = {shown};
        while (levels.back().width % 2 == 0 && levels.back().height % 2 == 0)
            levels.push_back(nextLevel(levels.back()));
        return levels;
    };
    for (const Texture& texture : world.textures) {
        const std::size_t frame = frameOf(1 + texture.laterFrames.size(), texture.rate);
        const TextureLevel& shown =
            frame == 0 ? texture.levels[0] : texture.laterFrames[frame - 1][0];
        levels_.push_back(levelsOf(shown.texels, shown.size, shown.size));
    }
    for (const Sprite& sprite : world.sprites) {
        const auto rows = static_cast<std::size_t>(sprite.views);
        const std::size_t frames = sprite.frames.size() / rows;
        spriteLevels_.emplace_back();
        for (std::size_t row = 0; row < rows; ++row) {
            const SpriteLevel& shown =
                sprite.frames[row * frames + frameOf(frames, sprite.rate)][0];
            spriteLevels_.back().push_back(levelsOf(shown.texels, shown.width, shown.height));
        }
    }
}

const std::vector<Image>& Tracer::levelsOf(const Sight& sight) const {
    return sight.kind == Sight::Kind::object ? spriteLevels_[sight.texture][sight.side]
                                             : levels_[sight.texture];
}

int Tracer::level(const Sight& sight, double depthFactor) const {
    if (sight.texture == kNoTexture) return 0;
    const std::vector<Image>& levels = levelsOf(sight);
    const int last = static_cast<int>(levels.size()) - 1;
    if (!view_.textures) return last;
    if (!view_.detail) return 0;
    int level = 0;
    for (double threshold = view_.detailThreshold;
         level < last && sight.depth * depthFactor * levels[0].height > threshold * distance_;
         threshold *= 2.0)
        ++level;
    return level;
}

Colour Tracer::colour(const Sight& sight, double depthFactor) const {
    const Map& map = world_.maps[static_cast<std::size_t>(sight.map)];
    const double depth = sight.depth * depthFactor;
    const auto mixed = [](Colour a, Colour b, int weight) {
        const auto channel = [&](int from, int to) {
            return static_cast<std::uint8_t>((to * weight + from * (255 - weight) + 127) / 255);
        };
        return Colour{channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), a.a};
    };
    const auto weightOf = [](double share) {
        return static_cast<int>(std::floor(255.0 * std::clamp(share, 0.0, 1.0) + 0.5));
    };
    const auto inWater = [&] {
        return weightOf(std::min(depth, sight.leaves) / water_->waterSight);
    };
    const Colour haze = water_ != nullptr ? water_->waterColour : map.haze;
    if (sight.kind == Sight::Kind::haze || (sight.kind == Sight::Kind::floor && depth > map.far))
        return haze;
    if (sight.kind == Sight::Kind::sky)
        return water_ != nullptr ? mixed(sight.colour, haze, inWater()) : sight.colour;
    const Image& image = levelsOf(sight)[static_cast<std::size_t>(level(sight, depthFactor))];
    // A negative fraction stands for a reversed one: texel N - 1 - i.
    const auto texel = [](double fraction, int n) {
        const int i = std::min(n - 1, static_cast<int>(std::floor(std::fabs(fraction) * n)));
        return std::signbit(fraction) ? n - 1 - i : i;
    };
    Colour raw;
    if (isSmooth(sight, depthFactor)) {
        const auto placeOf = [](double fraction) {
            return static_cast<int>(std::floor(65536.0 * std::fabs(fraction)));
        };
        raw = lit(sight, blended(fourRound(sight)), {placeOf(sight.u), placeOf(sight.v)});
    } else {
        const int column = texel(sight.u, image.width);
        const int row = texel(sight.v, image.height);
        const auto middle = [&](int i, double fraction) {
            const int along = std::signbit(fraction) ? image.height - 1 - i : i;
            return (2 * along + 1) * 32768 / image.height;
        };
        raw = lit(sight, toColour(image.at(column, row)),
                  {middle(column, sight.u), middle(row, sight.v)});
    }

    const bool unlit = sight.glow || !map.light.on || !view_.light;
    const double falloff = map.light.intensity * map.light.multiplier / depth;
    const double bright =
        (unlit ? 1.0 : std::clamp(falloff, map.light.darkest, map.light.brightest)) *
        sight.faceLight;
    const int q = std::min(256, static_cast<int>(std::floor(256.0 * bright + 0.5)));
    const int fog = water_ != nullptr ? inWater()
                    : map.fog.on && view_.fog
                        ? weightOf((depth - map.fog.start) / (map.fog.end - map.fog.start))
                        : 0;
    const auto lit = [&](int c) { return static_cast<std::uint8_t>((c * q + 128) >> 8); };
    const std::uint8_t alpha = sight.mirror > 0 ? 255 : raw.a;
    return mixed({lit(raw.r), lit(raw.g), lit(raw.b), alpha}, haze, fog);
}

bool Tracer::isLit(const Sight& sight) const {
    return view_.baked && !sight.glow && sight.texture != kNoTexture &&
           world_.maps[static_cast<std::size_t>(sight.map)].baked.on;
}

bool Tracer::sawLight(bool LightTracer::*what) const {
    return std::any_of(lights_.begin(), lights_.end(),
                       [&](const auto& light) { return light && (*light).*what; });
}

LightTracer& Tracer::lightOf(int map) const {
    const auto i = static_cast<std::size_t>(map);
    lights_.resize(world_.maps.size());
    if (!lights_[i]) lights_[i] = std::make_unique<LightTracer>(world_, world_.maps[i]);
    return *lights_[i];
}

bool Tracer::isSmooth(const Sight& sight, double depthFactor) const {
    if (!view_.smooth || sight.kind == Sight::Kind::object || sight.texture == kNoTexture)
        return false;
    const int size = levelsOf(sight)[0].height;
    return level(sight, depthFactor) == 0 && sight.depth * depthFactor * size <= distance_;
}

Tracer::Four Tracer::fourRound(const Sight& sight) const {
    const Image& image = levelsOf(sight)[0];
    const int n = image.height;
    struct Axis {
        int texel[2];
        int share[2];
        bool wraps;
    };
    const auto axis = [&](double fraction) {
        // From the middle of the first texel, and a whole texture further on so that it is positive
        const int at = static_cast<int>(std::floor(128.0 * n * std::fabs(fraction)));
        const int s = std::min(at, 128 * n - 1) - 64 + 128 * n;
        Axis found;
        for (int i = 0; i < 2; ++i) {
            const int along = (s / 128 + i) % n;
            found.texel[i] = std::signbit(fraction) ? n - 1 - along : along;
            found.share[i] = i == 0 ? 128 - s % 128 : s % 128;
        }
        found.wraps = s / 128 % n == n - 1;
        // The nearer one first
        if (found.share[1] >= found.share[0]) {
            std::swap(found.texel[0], found.texel[1]);
            std::swap(found.share[0], found.share[1]);
        }
        return found;
    };
    const Axis u = axis(sight.u);
    const Axis v = axis(sight.v);
    Four four;
    four.wraps = u.wraps || v.wraps;
    for (int i = 0; i < 4; ++i) {
        four.texels[i] = toColour(image.at(u.texel[i % 2], v.texel[i / 2]));
        four.shares[i] = u.share[i % 2] * v.share[i / 2];
    }
    return four;
}

Colour Tracer::blended(const Four& four) {
    const Colour nearest = four.texels[0];
    int sums[3] = {};
    for (int i = 0; i < 4; ++i) {
        const Colour c = four.texels[i].a == 0 ? nearest : four.texels[i];
        sums[0] += c.r * four.shares[i];
        sums[1] += c.g * four.shares[i];
        sums[2] += c.b * four.shares[i];
    }
    const auto channel = [](int sum) { return static_cast<std::uint8_t>((sum + 8192) >> 14); };
    return {channel(sums[0]), channel(sums[1]), channel(sums[2]), nearest.a};
}

bool Tracer::isBlendedAcrossBorder(const Sight& sight) const {
    return isSmooth(sight) && fourRound(sight).wraps;
}

bool Tracer::isBlendedBesideHole(const Sight& sight) const {
    if (!isSmooth(sight)) return false;
    const Four four = fourRound(sight);
    return four.texels[0].a != 0 &&
           std::any_of(four.texels, four.texels + 4, [](const Colour& c) { return c.a == 0; });
}

// A texel, or a blend of some, times the light at a spot.
Colour Tracer::lit(const Sight& sight, Colour texel, Spot spot) const {
    if (!isLit(sight)) return texel;
    LightTracer& light = lightOf(sight.map);
    Rgb l;
    if (sight.kind == Sight::Kind::object) {
        const Map& map = world_.maps[static_cast<std::size_t>(sight.map)];
        l = light.lightOf(map.objects[static_cast<std::size_t>(sight.object)]);
    } else if (sight.outsideGrid) {
        l = light.lightOutside();
    } else {
        const int a = (std::min(spot.u, 65535) + sight.slideU.raw) & 65535;
        int b = (std::min(spot.v, 65535) + sight.slideV.raw) & 65535;
        if (sight.kind == Sight::Kind::side)
            b = std::min(65535, 65536 - ((std::min(spot.v, 65535) - sight.rise.raw) & 65535));
        l = light.lightAt(sight.litFace, a, b);
    }
    const auto channel = [](int c, int by) {
        return static_cast<std::uint8_t>((c * by + 128) >> 8);
    };
    return {channel(texel.r, l[0]), channel(texel.g, l[1]), channel(texel.b, l[2]), texel.a};
}

const char* nameOf(Note note) {
    static const char* const kNames[] = {"face portal",
                                         "face portal turned by 90",
                                         "face portal turned by 180",
                                         "face portal turned by 270",
                                         "tile portal",
                                         "tile portal turned by 90",
                                         "tile portal turned by 180",
                                         "tile portal turned by 270",
                                         "north portal",
                                         "east portal",
                                         "south portal",
                                         "west portal",
                                         "top portal",
                                         "bottom portal",
                                         "levels shifted",
                                         "three portals",
                                         "portal within a map",
                                         "portal at once",
                                         "portal in glass",
                                         "face at the limit",
                                         "tile at the limit",
                                         "below the floor",
                                         "out inside a block",
                                         "face at the exit",
                                         "face behind the exit",
                                         "tile at the exit",
                                         "left through a portal",
                                         "joined by a portal",
                                         "joined mover",
                                         "joined kin",
                                         "whole mover",
                                         "whole slider",
                                         "inside a mover",
                                         "risen texture",
                                         "empty mover",
                                         "floor mirror",
                                         "roof mirror",
                                         "joined mirror",
                                         "mirror behind a portal",
                                         "portal behind a mirror",
                                         "mirror outside",
                                         "eye in water",
                                         "out of the water",
                                         "sky through water",
                                         "mirror through water",
                                         "no face",
                                         "plan entered",
                                         "plan left",
                                         "plan missed",
                                         "cut entered",
                                         "cut left",
                                         "side of a block with slopes",
                                         "sloped roof",
                                         "sloped underside",
                                         "slope from inside",
                                         "sloped roof above the horizon",
                                         "sloped underside below the horizon",
                                         "moved slope",
                                         "shifted slope",
                                         "cut slope",
                                         "slid side",
                                         "slid plane",
                                         "star",
                                         "sun",
                                         "moon",
                                         "cloud",
                                         "rippled mirror",
                                         "rippled to the end of a mirror"};
    static_assert(std::size(kNames) == static_cast<std::size_t>(Note::count));
    return kNames[static_cast<std::size_t>(note)];
}

}  // namespace slicecast::judge

#include "tracer_sky.h"

#include "base/angle.h"
#include "base/random.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace slicecast::judge {
namespace {

std::uint64_t random(std::uint64_t seed) {
    return Random(seed).next();
}

Colour over(Colour colour, int weight, Colour there) {
    const auto channel = [&](int c, int t) {
        return static_cast<std::uint8_t>((c * weight + t * (255 - weight) + 127) / 255);
    };
    return {channel(colour.r, there.r), channel(colour.g, there.g), channel(colour.b, there.b),
            255};
}

int share(double of, int whole) {
    return static_cast<int>(std::floor(of * whole + 0.5));
}

double fraction(double number) {
    return number - std::floor(number);
}

int modulo(int number, int by) {
    return ((number % by) + by) % by;
}

// The sky's own colour, of a panorama in one of its columns.
Colour plainColour(const Sky& sky, int column, double slope) {
    const double height = std::min(1.0, slope / sky.slope);
    const auto mix = [&](int a, int b) {
        return static_cast<std::uint8_t>(std::floor(a + (b - a) * height + 0.5));
    };
    switch (sky.kind) {
        case Sky::Kind::colour:
            return sky.low;
        case Sky::Kind::gradient:
            return {mix(sky.low.r, sky.high.r), mix(sky.low.g, sky.high.g),
                    mix(sky.low.b, sky.high.b), 255};
        case Sky::Kind::panorama:
            break;
    }
    const int h = sky.panorama.height;
    return toColour(
        sky.panorama.at(column, std::min(h - 1, static_cast<int>(std::floor((1.0 - height) * h)))));
}

int noise(std::uint32_t seed, int x, int y) {
    const auto corner = [&](int i, int j) {
        return static_cast<int>(random(seed + (static_cast<std::uint64_t>(modulo(i, 65536)) << 32) +
                                       (static_cast<std::uint64_t>(modulo(j, 65536)) << 48)) >>
                                56);
    };
    const auto p = [](int f) { return (f * f * (768 - 2 * f)) >> 16; };
    const auto a = [&](int j) {
        return 256 * corner(x >> 8, j) +
               (corner((x >> 8) + 1, j) - corner(x >> 8, j)) * p(modulo(x, 256));
    };
    const int j = y >> 8;
    return (256 * a(j) + (a(j + 1) - a(j)) * p(modulo(y, 256))) >> 16;
}

int starWeight(const SkyStars& stars, int c, int v) {
    const std::uint64_t r = random(stars.seed + (static_cast<std::uint64_t>(c / 8) << 32) +
                                   (static_cast<std::uint64_t>(v / 8) << 44));
    if (static_cast<int>(r % 1024) >= share(stars.density, 1024)) return 0;
    const int away = std::abs(c % 8 - (1 + static_cast<int>((r >> 10) % 6))) +
                     std::abs(v % 8 - (1 + static_cast<int>((r >> 16) % 6)));
    const int m = static_cast<int>((r >> 24) % 256);
    if (away > (m >= 224 ? 1 : 0)) return 0;
    int b = 40 + 215 * (m * m / 255 * m / 255) / 255;
    if (away == 1) b /= 3;
    return b * std::min(v, 48) / 48 * share(stars.brightness, 255) / 255;
}

// The disc's colour and weight in a square.
int discWeight(const SkyDisc& disc, int c, int v, bool isMoon, Colour& colour) {
    const auto halves = [](double degrees) {
        return static_cast<int>(std::floor(degrees * (4096.0 / 360.0) + 0.5));
    };
    colour = disc.colour;
    const std::int64_t radius = halves(disc.size / 2.0);
    const std::int64_t glow = halves(disc.glow);
    if (radius == 0) return 0;
    const std::int64_t x =
        modulo(2 * c + 1 - halves(wrapDegrees(disc.azimuth)) + 2048, 4096) - 2048;
    const std::int64_t y =
        2 * v + 1 - static_cast<int>(std::floor(652.0 * tanDegrees(disc.altitude) + 0.5));
    const std::int64_t distance = x * x + y * y;
    std::int64_t weight = 0;
    if (distance < glow * glow) {
        const std::int64_t n = 256 - ((distance * ((std::int64_t{1} << 28) / (glow * glow))) >> 20);
        const std::int64_t q = (n * n) >> 8;
        weight = (160 * ((q * q) >> 8)) >> 8;
    }
    const std::int64_t rim = (radius + 1) * (radius + 1);
    if (distance < rim) {
        weight =
            std::max(weight, std::min<std::int64_t>(255, 255 * (rim - distance) / (4 * radius)));
        if (isMoon) {
            const int n =
                noise(0, static_cast<int>(640 * x / radius), static_cast<int>(640 * y / radius));
            colour = over({0, 0, 0, 255}, std::clamp(2 * (112 - n), 0, 64), colour);
        }
    }
    return static_cast<int>(weight) * std::min(v, 16) / 16;
}

// Clouds are looked up where the scene's loading has put them; that is checked here.
class CloudsAt {
public:
    // A whole turn takes 360 * 120 = 43200 of `product`.
    CloudsAt(const SkyClouds& clouds, int c, std::int64_t steps) : clouds_(clouds) {
        const double product = static_cast<double>(steps) * clouds.speed;
        const double inTurn = product - 43200.0 * std::floor(product / 43200.0);
        const int moved = static_cast<int>(std::floor(262144.0 * inTurn / 43200.0));
        at_ = modulo(128 * c - moved, 262144);
    }

    int density(int v) const { return (row(v / 2) + row((v + 1) / 2)) >> 1; }

private:
    int row(int j) const {
        const int i = at_ >> 8;
        const auto of = [&](int column) {
            return clouds_.shape
                ->density[static_cast<std::size_t>(column * 256 + std::min(j, 255))];
        };
        return (of(i) * (256 - at_ % 256) + of((i + 1) % 1024) * (at_ % 256)) >> 8;
    }

    const SkyClouds& clouds_;
    int at_;
};

int cloudWeight(const SkyClouds& clouds, int c, int v, std::int64_t steps, Colour& colour) {
    const CloudsAt at(clouds, c, steps);
    const int d = at.density(v);
    int weight = std::clamp(8 * (d - 200 + share(clouds.cover, 160)), 0, 255) *
                 share(clouds.opacity, 255) / 255;
    if (v < 24) weight = weight * v / 24;
    const int tone = std::clamp(160 + 8 * (d - at.density(v + 6)), 0, 255);
    colour = over(clouds.colour, 17 * (tone >> 4), clouds.shade);
    return weight;
}

}  // namespace

int cloudDensity(std::uint32_t seed, double size, int i, int j) {
    const double e = (2 * j + 1) / 326.0 + 0.15;
    const double degrees = (i + 0.5) * 360.0 / 1024;
    const int x = static_cast<int>(std::floor(cosDegrees(degrees) * (512.0 / size / e)));
    const int y = static_cast<int>(std::floor(sinDegrees(degrees) * (512.0 / size / e)));
    return (8 * noise(seed, x, y) + 4 * noise(seed + 1, 2 * x, 2 * y) +
            2 * noise(seed + 2, 4 * x, 4 * y) + noise(seed + 3, 8 * x, 8 * y)) /
           15;
}

Colour skyColour(const Sky& sky, double headingDegrees, double slope, std::int64_t steps,
                 SkyNotes& notes) {
    const double u = fraction(headingDegrees / 360.0);
    const auto columnOf = [&](int count) {
        return std::min(count - 1, static_cast<int>(std::floor(u * count)));
    };
    if (sky.stars.density == 0.0 && sky.sun.size == 0.0 && sky.moon.size == 0.0 &&
        !sky.clouds.shape)
        return plainColour(sky, columnOf(std::max(1, sky.panorama.width)), slope);
    const int c = columnOf(2048);
    const int v = static_cast<int>(std::min(4095.0, std::floor(326.0 * slope)));
    Colour shown = plainColour(sky, (2 * c + 1) * sky.panorama.width / 4096, (v + 0.5) / 326.0);
    const auto lay = [&](Colour colour, int weight, bool& note) {
        note = note || weight > 0;
        shown = over(colour, weight, shown);
    };
    Colour colour;
    lay(sky.stars.colour, starWeight(sky.stars, c, v), notes.star);
    int weight = discWeight(sky.sun, c, v, false, colour);
    lay(colour, weight, notes.sun);
    weight = discWeight(sky.moon, c, v, true, colour);
    lay(colour, weight, notes.moon);
    if (sky.clouds.shape) {
        weight = cloudWeight(sky.clouds, c, v, steps, colour);
        lay(colour, weight, notes.cloud);
    }
    return shown;
}

}  // namespace slicecast::judge

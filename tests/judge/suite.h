// Judges many random pictures and sums up the verdicts.
#pragma once

#include "draw.h"
#include "random_scene.h"
#include "times_of_day.h"
#include "verdict.h"

#include <array>
#include <cstdint>
#include <string>

namespace slicecast::judge {

struct Size {
    int width;
    int height;
};

// Small pictures of many shapes, pixels.
inline constexpr std::array<Size, 8> kSmallSizes = {
    {{160, 100}, {1, 1}, {7, 3}, {64, 64}, {97, 53}, {128, 80}, {33, 120}, {160, 99}}};
// Full-size pictures, some of odd width and height.
inline constexpr std::array<Size, 4> kLargeSizes = {
    {{1280, 720}, {641, 399}, {1280, 720}, {1279, 721}}};

// Odd widths: these pictures have a middle column.
inline constexpr std::array<Size, 3> kOddSizes = {{{33, 120}, {97, 53}, {7, 90}}};

// Small ones: each pixel meets hundreds of things.
inline constexpr std::array<Size, 3> kCrowdSizes = {{{33, 60}, {48, 33}, {12, 120}}};

using MakeScene = Scene (*)(std::uint64_t seed, int width, int height);

// Judges the picture of one seed. A refused picture counts as an unexcused pixel.
template <typename Sizes>
Verdict judgeOne(Renderer& renderer, MakeScene make, std::uint64_t seed, const Sizes& sizes) {
    const Size size = sizes[seed % sizes.size()];
    Scene scene = make(seed, size.width, size.height);
    const std::string name = "seed " + std::to_string(seed);
    const Image image = drawTimes(renderer, scene);
    if (!image.empty()) {
        const World& defined = scene.defined ? *scene.defined : scene.world;
        return judge(defined, scene.view, image.pixels.data(), image.width, name);
    }
    Verdict refused;
    refused.unexcused = 1;
    refused.complaints = {name + ": the renderer refused to draw"};
    return refused;
}

// Judges the pictures of the seeds [first, first + count).
template <typename Sizes>
Verdict judgeAll(MakeScene make, std::uint64_t first, int count, const Sizes& sizes) {
    Renderer renderer;
    Verdict sum;
    for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed)
        sum.add(judgeOne(renderer, make, seed, sizes));
    return sum;
}

}  // namespace slicecast::judge

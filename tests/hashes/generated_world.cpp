#include "generated_world.h"

#include "generated_features.h"

#include "base/random.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace slicecast {
namespace {

constexpr int kTextures = 10;

Colour anyColour(Random& random) {
    const int bits = random.between(0, 0xffffff);
    return {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
            static_cast<std::uint8_t>(bits >> 16), 255};
}

TextureId anyTexture(Random& random) {
    return static_cast<TextureId>(random.below(kTextures));
}

// A height or a position within a tile: any of the grid, or one that people would write.
Coordinate anyFraction(Random& random) {
    return {random.oneIn(2) ? random.between(0, 65536) : random.between(0, 8) * 8192};
}

Texture anyPattern(Random& random, int index) {
    const int size = 8 << random.below(5);
    Image image(size, size);
    for (Pixel& pixel : image.pixels) pixel = toPixel(anyColour(random));
    return makeTexture("pattern " + std::to_string(index), std::move(image));
}

CellBlueprint anyBlueprint(Random& random, int index) {
    CellBlueprint blueprint;
    blueprint.name = "block " + std::to_string(index);
    while (!random.oneIn(4)) {
        blueprint.bottom = random.oneIn(2) ? Coordinate{0} : anyFraction(random);
        blueprint.top = random.oneIn(3) ? tileEdge(1) : anyFraction(random);
        if (blueprint.bottom < blueprint.top) break;
        blueprint.bottom = {};
        blueprint.top = tileEdge(1);
    }
    for (FaceBlueprint& face : blueprint.faces) {
        face.texture = anyTexture(random);
        if (random.oneIn(2)) face.light = random.unit();
    }
    return blueprint;
}

Sky anySky(Random& random, Sky::Kind kind) {
    Sky sky;
    sky.kind = kind;
    sky.low = anyColour(random);
    sky.high = anyColour(random);
    sky.slope = random.between(0.1, 3.0);
    if (kind == Sky::Kind::panorama) {
        const int width = random.between(1, 700);
        const int height = random.between(1, 150);
        sky.panorama = Image(width, height);
        for (Pixel& pixel : sky.panorama.pixels) pixel = toPixel(anyColour(random));
    }
    return sky;
}

void addCeiling(Random& random, Map& map) {
    map.ceiling.height = {random.between(1, (map.levels + 1) * 65536)};
    if (random.oneIn(2)) map.ceiling.height = {std::max(1, map.ceiling.height.raw >> 15) * 32768};
    map.ceiling.light = random.unit();
    map.ceiling.tiles.resize(map.floor.tiles.size());
    const int open = random.between(1, 6);
    const TextureId texture = anyTexture(random);
    for (TextureId& tile : map.ceiling.tiles)
        tile = random.oneIn(open + 1) ? kNoTexture : random.oneIn(4) ? anyTexture(random) : texture;
}

Map anyMap(Random& random, int blueprints, Sky::Kind sky) {
    const int longest = random.oneIn(4) ? 120 : 20;
    const int width = random.between(1, longest);
    const int depth = random.between(1, longest);
    const int levels = random.oneIn(6) ? kMaxLevels : random.between(1, 6);
    Map map = makeMap("generated", width, depth, levels, anyTexture(random));
    const double filled = random.oneIn(5) ? random.between(0.4, 0.9) : random.between(0.0, 0.3);
    for (int y = 0; y < depth; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int level = 0; level < levels; ++level) {
                if (random.unit() < filled)
                    map.setCell(x, y, level,
                                static_cast<BlueprintId>(random.between(1, blueprints)));
            }
        }
    }
    map.floor.light = random.oneIn(2) ? 1.0 : random.unit();
    for (TextureId& tile : map.floor.tiles) {
        if (random.oneIn(5)) tile = anyTexture(random);
    }
    if (random.oneIn(2)) addCeiling(random, map);
    map.sky = anySky(random, sky);
    map.light.on = !random.oneIn(5);
    map.light.intensity = random.between(0.2, 4.0);
    map.light.multiplier = random.between(0.5, 8.0);
    map.light.darkest = random.between(0.0, 0.5);
    map.light.brightest = random.between(0.5, 1.0);
    map.fog.on = random.oneIn(2);
    map.fog.start = random.between(0.0, 10.0);
    map.fog.end = map.fog.start + random.between(0.1, 40.0);
    map.haze = anyColour(random);
    if (random.oneIn(3)) map.far = random.between(1.0, 60.0);
    if (random.oneIn(6)) map.far = 100'000.0;
    return map;
}

RenderOptions anyOptions(Random& random) {
    RenderOptions options;
    options.fovDegrees = random.oneIn(4) ? random.between(kMinFovDegrees, kMaxFovDegrees)
                                         : random.between(30.0, 110.0);
    options.detail = !random.oneIn(5);
    if (random.oneIn(4)) options.detailThreshold = random.between(0.125, 8.0);
    options.textures = !random.oneIn(10);
    options.light = !random.oneIn(8);
    options.fog = !random.oneIn(6);
    if (random.oneIn(3)) options.mirrors = random.between(0.0, 4.0);
    return options;
}

}  // namespace

World generatedWorld(std::uint64_t seed) {
    Random random(seed);
    World world;
    world.title = "Generated " + std::to_string(seed);
    for (int i = 0; i < kTextures; ++i) world.textures.push_back(anyPattern(random, i));
    const int blueprints = random.between(1, 12);
    for (int i = 1; i <= blueprints; ++i) world.blueprints.push_back(anyBlueprint(random, i));
    const bool withFeatures = seed % 2 == 1;
    const int maps = withFeatures ? random.between(2, 3) : 1;
    for (int i = 0; i < maps; ++i) {
        world.maps.push_back(
            anyMap(random, blueprints,
                   static_cast<Sky::Kind>((seed + static_cast<std::uint64_t>(i)) % 3)));
        world.maps.back().name += " " + std::to_string(i);
    }
    if (withFeatures) addFeatures(random, world, seed >= kFirstWithRamps);
    if (seed % 4 >= 2) addShapes(random, world);
    if (seed % 6 >= 3) addLight(random, world);
    if (seed % 5 >= 3) {
        Random own(seed);  // the rest of the world stays what it is
        addSkyAndRipples(own, world);
    }
    world.start.x = {random.between(0, world.maps[0].width * 65536 - 1)};
    world.start.y = {random.between(0, world.maps[0].depth * 65536 - 1)};
    world.start.headingDegrees = random.between(0.0, 360.0);
    return world;
}

GeneratedView generatedView(const World& world, std::uint64_t seed) {
    constexpr std::array<std::array<int, 2>, 6> kSizes = {
        {{320, 200}, {319, 201}, {1, 1}, {7, 3}, {33, 240}, {400, 17}}};
    Random random(seed);
    GeneratedView view;
    view.options = anyOptions(random);
    const auto& size =
        random.oneIn(3)
            ? kSizes[static_cast<std::size_t>(random.below(static_cast<int>(kSizes.size())))]
            : kSizes[0];
    view.width = size[0];
    view.height = size[1];

    view.eye.map = random.below(static_cast<int>(world.maps.size()));
    const Map& map = world.maps[static_cast<std::size_t>(view.eye.map)];
    const int margin = random.oneIn(6) ? 9 : 0;
    Eye& eye = view.eye;
    eye.x = {random.between(-margin * 65536, (map.width + margin) * 65536)};
    eye.y = {random.between(-margin * 65536, (map.depth + margin) * 65536)};
    const int heights = random.oneIn(4) ? map.levels + 6 : map.levels;
    eye.z = {random.between(1, heights * 65536)};
    if (random.oneIn(3)) eye.z = {32768};
    if (random.oneIn(6)) eye.x = tileEdge(eye.x.tile());
    if (random.oneIn(6)) eye.y = tileEdge(eye.y.tile());
    if (random.oneIn(6)) eye.z = {std::max(1, eye.z.raw >> 13) * 8192};
    eye.headingDegrees =
        random.oneIn(5) ? 45.0 * random.between(-8, 16) : random.between(-400.0, 800.0);
    eye.look = random.oneIn(4) ? random.between(-kMaxLook, kMaxLook) : random.between(-0.5, 0.5);
    return view;
}

}  // namespace slicecast

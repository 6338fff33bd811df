// Small worlds to draw by the old ways, and what is asked of such pictures.
#pragma once

#include "base/random.h"
#include "classic/draw_classic.h"
#include "render/scenes.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace slicecast::known {

inline constexpr Colour kBlack = {0, 0, 0, 255};
inline constexpr Colour kRed = {255, 0, 0, 255};
inline constexpr Colour kGreen = {0, 255, 0, 255};

struct Drawn {
    Image image;
    FrameReport report;
};

inline Drawn drawOld(const World& world, const Eye& eye, int width, int height,
                     const ClassicOptions& classic, const RenderOptions& options = {}) {
    Drawn drawn{Image(width, height), {}};
    LitMaps lit;
    const std::optional<FrameReport> report = drawClassic(
        world, eye, options, classic, lit, {drawn.image.pixels.data(), width, height, width});
    if (report) {
        drawn.report = *report;
    } else {
        drawn.image = {};
    }
    return drawn;
}

// The first row of a colour in a column, or the picture's height.
inline int firstRow(const Image& image, int column, Colour colour) {
    for (int y = 0; y < image.height; ++y) {
        if (image.at(column, y) == toPixel(colour)) return y;
    }
    return image.height;
}

inline int count(const Image& image, Colour colour) {
    return static_cast<int>(std::count(image.pixels.begin(), image.pixels.end(), toPixel(colour)));
}

inline bool columnsAreEqual(const Image& image, int a, int b) {
    for (int y = 0; y < image.height; ++y) {
        if (image.at(a, y) != image.at(b, y)) return false;
    }
    return true;
}

// Squares in as many colours, so that a wrong texel shows.
inline Texture squares(const std::string& name, std::uint8_t blue) {
    Image image(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x)
            image.at(x, y) = toPixel({static_cast<std::uint8_t>(120 + 17 * x),
                                      static_cast<std::uint8_t>(120 + 17 * y), blue, 255});
    }
    return makeTexture(name, std::move(image));
}

// Squares again, some of them holes and some of them half there.
inline Texture lattice(const std::string& name) {
    Image image(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            const std::uint8_t alpha = (x + y) % 3 == 0 ? 255 : (x + y) % 3 == 1 ? 90 : 0;
            image.at(x, y) = toPixel({static_cast<std::uint8_t>(120 + 17 * x), 60,
                                      static_cast<std::uint8_t>(120 + 17 * y), alpha});
        }
    }
    return makeTexture(name, std::move(image));
}

// Two frames of squares, three a second.
inline Texture flicker(const std::string& name) {
    Image image(16, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x)
            image.at(x, y) = toPixel({static_cast<std::uint8_t>(120 + 8 * x),
                                      static_cast<std::uint8_t>(120 + 17 * y), 200, 255});
    }
    return makeTexture(name, std::move(image), 2, 3.0);
}

// The upper half of one colour, the lower of another.
inline Texture halves(const std::string& name, Colour upper, Colour lower) {
    Image image(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) image.at(x, y) = toPixel(y < 4 ? upper : lower);
    }
    return makeTexture(name, std::move(image));
}

// The left half of one colour, the right of another.
inline Texture sides(const std::string& name, Colour left, Colour right) {
    Image image(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) image.at(x, y) = toPixel(x < 4 ? left : right);
    }
    return makeTexture(name, std::move(image));
}

// Black floor, magenta sky, a white wall of full blocks across the map at x = 10.
inline World wallWorld(Texture wall) {
    World world = emptyWorld(20, 41, 1, plain("floor", kBlack));
    const BlueprintId block = addBlock(world, addTexture(world, std::move(wall)));
    for (int y = 0; y < 41; ++y) world.maps[0].setCell(10, y, 0, block);
    return world;
}

// Blocks of all kinds on several levels, some glowing or flickering, in every other world some
// see-through; ceilings over some tiles, light, fog, a gradient for a sky.
inline World mixedWorld(std::uint64_t seed) {
    Random random(seed);
    World world = emptyWorld(10, 9, 4, squares("floor", 10));
    std::vector<BlueprintId> blocks;
    for (int i = 0; i < 6; ++i) {
        const bool seeThrough = seed % 2 == 1 && i % 2 == 1;
        const TextureId texture =
            addTexture(world, seeThrough ? lattice("lattice")
                              : i == 4   ? flicker("flicker")
                                         : squares("wall", static_cast<std::uint8_t>(60 + 30 * i)));
        const int bottom = i < 2 ? 0 : random.between(0, 40000);
        const int top = i < 2 ? 65536 : random.between(bottom + 1, 65536);
        blocks.push_back(addBlock(world, texture, {bottom}, {top}));
        for (FaceBlueprint& face : world.blueprints.back().faces) {
            face.light = random.between(0.5, 1.0);
            face.glow = random.oneIn(8);
            if (seeThrough && random.oneIn(4)) face.texture = 0;
        }
        world.blueprints.back().join = !random.oneIn(3);
    }
    markSeeThrough(world);
    Map& map = world.maps[0];
    map.ceiling.height = {random.between(65536, 5 * 65536)};
    map.ceiling.tiles.assign(90, kNoTexture);
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 10; ++x) {
            if (random.oneIn(6))
                map.ceiling.tiles[map.tileIndex(x, y)] =
                    static_cast<TextureId>(random.between(1, 2));
            for (int level = 0; level < 4; ++level) {
                if (random.oneIn(4)) map.setCell(x, y, level, blocks[random.below(6)]);
            }
        }
    }
    world.steps = 24 * static_cast<std::int64_t>(seed);
    map.light.on = random.oneIn(2);
    map.fog = {.on = random.oneIn(2), .start = 1.0, .end = 20.0};
    map.sky = {
        .kind = Sky::Kind::gradient, .low = kRed, .high = kGreen, .slope = 0.5, .panorama = {}};
    map.far = random.oneIn(2) ? 30.0 : kDefaultFar;
    return world;
}

// A mixed world with objects and mirrors, and, where nothing is see-through, with portals: faces of
// all kinds and tiles, turned and raised, into a second map and within the first.
inline World featureWorld(std::uint64_t seed) {
    World world = mixedWorld(seed);
    Random random(seed + 1000);
    const SpriteId sprite = addSprite(world, 12, 20);
    for (int i = 0; i < 12; ++i) {
        addObject(world, sprite, random.between(0.0, 10.0), random.between(0.0, 9.0),
                  random.oneIn(2) ? 0.0 : random.between(0.0, 3.0), random.between(0.2, 2.0),
                  random.between(0.2, 2.0));
        world.maps[0].objects.back().light = random.unit();
    }
    if (random.oneIn(2)) world.maps[0].floor.mirror = 150;
    for (CellBlueprint& blueprint : world.blueprints) {
        if (random.oneIn(3))
            blueprint.faces[static_cast<std::size_t>(Face::top)].mirror =
                static_cast<std::uint8_t>(random.between(1, 255));
    }
    world.maps.push_back(world.maps[0]);
    world.maps[1].haze = kRed;
    world.maps[1].floor.mirror = 0;
    std::reverse(world.maps[1].objects.begin(), world.maps[1].objects.end());
    if (seed % 2 == 1) return world;

    world.portalLimit = random.between(0, 4);
    for (int i = 0; i < 12; ++i) {
        Portal portal = {.fromMap = random.below(2),
                         .fromX = random.below(10),
                         .fromY = random.below(9),
                         .toMap = random.below(2),
                         .toX = random.below(10),
                         .toY = random.below(9),
                         .turn = random.below(4),
                         .levels = random.oneIn(3) ? random.between(-1, 1) : 0};
        // The exit is free.
        for (int level = 0; level < 4; ++level)
            world.maps[static_cast<std::size_t>(portal.toMap)].setCell(portal.toX, portal.toY,
                                                                       level, kEmptyCell);
        Map& map = world.maps[static_cast<std::size_t>(portal.fromMap)];
        const auto id = static_cast<PortalId>(world.portals.size());
        if (map.tilePortals.empty()) map.tilePortals.assign(map.occupied.size(), kNoPortal);
        const int level = random.below(4);
        const BlueprintId block = map.cell(portal.fromX, portal.fromY, level);
        if (block == kEmptyCell) {
            map.tilePortals[map.tileIndex(portal.fromX, portal.fromY)] = id;
        } else {
            CellBlueprint instance = world.blueprints[block];
            for (FaceBlueprint& face : instance.faces) {
                if (random.oneIn(2)) face.portal = id;
            }
            world.blueprints.push_back(instance);
            map.setCell(portal.fromX, portal.fromY, level,
                        static_cast<BlueprintId>(world.blueprints.size() - 1));
        }
        world.portals.push_back(portal);
    }
    markPortals(world);
    return world;
}

}  // namespace slicecast::known

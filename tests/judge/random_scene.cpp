#include "random_scene.h"

#include "base/angle.h"
#include "base/random.h"
#include "random_portals.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace slicecast::judge {

Colour anyColour(Random& random) {
    return {static_cast<std::uint8_t>(random.below(256)),
            static_cast<std::uint8_t>(random.below(256)),
            static_cast<std::uint8_t>(random.below(256)), 255};
}

namespace {

// A texture of which each texel's colour tells its place: red the texture and the frame, green u,
// blue v. With up to 8 texels a side, neighbours can be told apart in the dimmest light. Finer
// textures are used only in worlds whose light never falls below a half. See-through textures have
// holes, opaque texels and all between, and a second frame lets more through.
Texture codedTexture(int index, int size, bool seeThrough, int frames, double rate) {
    Image image(size * frames, size);
    const int step = 240 / size;
    for (int y = 0; y < size; ++y) {
        for (int column = 0; column < size * frames; ++column) {
            const int x = column % size;
            image.at(column, y) =
                toPixel({static_cast<std::uint8_t>(10 + index * 12 + 6 * (column / size)),
                         static_cast<std::uint8_t>(8 + x * step),
                         static_cast<std::uint8_t>(8 + y * step), 255});
            if (seeThrough && (x + y + index) % 3 != 0) {
                Colour colour = toColour(image.at(column, y));
                const int dense = (x * 31 + y * 57) % 200 / (1 + 3 * (column / size));
                colour.a =
                    static_cast<std::uint8_t>((x * 5 + y * 3 + index) % 4 == 0 ? 0 : 40 + dense);
                image.at(column, y) = toPixel(colour);
            }
        }
    }
    return makeTexture("coded " + std::to_string(index), std::move(image), frames, rate);
}

constexpr int kTextures = 20;

Coordinate fractionOfTile(Random& random, bool coarse) {
    return {coarse ? random.between(0, 8) * 8192 : random.between(0, 65536)};
}

TextureId anyTexture(Random& random) {
    return static_cast<TextureId>(random.below(kTextures));
}

CellBlueprint randomBlueprint(Random& random, bool coarse) {
    CellBlueprint blueprint;
    if (!random.oneIn(3)) {
        do {
            blueprint.bottom = random.oneIn(2) ? Coordinate{0} : fractionOfTile(random, coarse);
            blueprint.top = random.oneIn(3) ? tileEdge(1) : fractionOfTile(random, coarse);
        } while (blueprint.bottom >= blueprint.top);
    }
    for (FaceBlueprint& face : blueprint.faces) {
        face.texture = anyTexture(random);
        if (random.oneIn(3)) face.light = random.between(0.5, 1.0);
        face.glow = random.oneIn(8);
    }
    blueprint.join = !random.oneIn(4);
    return blueprint;
}

Sky randomSky(Random& random) {
    Sky sky;
    sky.kind = static_cast<Sky::Kind>(random.below(3));
    sky.low = anyColour(random);
    sky.high = anyColour(random);
    sky.slope = random.between(0.2, 2.0);
    if (sky.kind == Sky::Kind::panorama) {
        const int height = random.between(1, 60);
        sky.panorama = Image(random.between(1, 200), height);
        for (Pixel& pixel : sky.panorama.pixels) pixel = toPixel(anyColour(random));
    }
    return sky;
}

Map randomMap(Random& random, const World& world, bool fineTextures, bool coarse) {
    const int longest = random.oneIn(4) ? 40 : 12;
    // One number after another: the order of a call's arguments is the compiler's choice.
    const TextureId floorTexture = anyTexture(random);
    const int levels = random.oneIn(8) ? random.between(7, kMaxLevels) : random.between(1, 5);
    const int depth = random.between(1, longest);
    Map map = makeMap("random", random.between(1, longest), depth, levels, floorTexture);
    // From a few blocks to nearly solid; some maps repeat one level in all others, so that faces
    // meet flush.
    const double filled = random.oneIn(5) ? random.between(0.5, 0.95) : random.between(0.0, 0.35);
    const int blueprints = static_cast<int>(world.blueprints.size());
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            for (int level = 0; level < map.levels; ++level) {
                if (random.unit() < filled)
                    map.setCell(x, y, level,
                                static_cast<BlueprintId>(random.between(1, blueprints - 1)));
            }
        }
    }
    map.floor.light = random.oneIn(2) ? 1.0 : random.between(0.5, 1.0);
    if (random.oneIn(2)) {
        for (TextureId& tile : map.floor.tiles) {
            if (random.oneIn(3)) tile = anyTexture(random);
        }
    }
    if (random.oneIn(2)) {
        map.ceiling.height = {random.between(1, map.levels * 65536 + 65536)};
        if (coarse || random.oneIn(3))
            map.ceiling.height = {std::max(1, map.ceiling.height.raw >> 14) * 16384};
        map.ceiling.light = random.between(0.5, 1.0);
        const TextureId texture = anyTexture(random);
        const int open = random.between(0, 3);
        map.ceiling.tiles.resize(map.floor.tiles.size());
        for (TextureId& tile : map.ceiling.tiles)
            tile = open > 0 && random.oneIn(2 * open) ? kNoTexture
                   : random.oneIn(4)                  ? anyTexture(random)
                                                      : texture;
    }
    map.floor.glow = random.oneIn(8);
    map.ceiling.glow = random.oneIn(8);
    map.sky = randomSky(random);
    map.light.on = !random.oneIn(4);
    map.light.intensity = random.between(0.5, 3.0);
    map.light.multiplier = random.between(1.0, 6.0);
    map.light.darkest = fineTextures ? random.between(0.5, 0.9) : random.between(0.1, 0.6);
    map.light.brightest = random.between(0.9, 1.0);
    if (fineTextures) {
        // Full brightness from half the clamp on: face factors are at least a half, and the product
        // is to stay there.
        map.light.darkest = 1.0;
        map.light.brightest = 1.0;
    }
    if (random.oneIn(3)) {
        map.fog.on = true;
        map.fog.start = random.between(0.0, 10.0);
        map.fog.end = map.fog.start + random.between(20.0, 60.0);
    }
    map.haze = anyColour(random);
    if (random.oneIn(3)) map.far = random.between(2.0, 60.0);
    return map;
}

// A sprite of any size, coded like the textures, with holes and blended texels. Every third one has
// four views.
Sprite codedSprite(Random& random, int index) {
    // Most have levels of detail, which takes even sides.
    const int width = random.oneIn(4) ? random.between(1, 8) : 8;
    const int height = random.oneIn(4) ? random.between(1, 8) : 8;
    const int frames = random.oneIn(3) ? 2 : 1;
    const int views = index % 3 == 2 ? kSpriteViews : 1;
    Image image(width * frames, height * views);
    for (int row = 0; row < image.height; ++row) {
        const int y = row % height;
        const int view = row / height;
        for (int column = 0; column < image.width; ++column) {
            const int x = column % width;
            const int alpha = (x + 2 * y + index) % 4 == 0 ? 0
                              : (x + y) % 3 == 0           ? 60 + x * 15 + y * 9
                                                           : 255;
            image.at(column, row) = toPixel(
                {static_cast<std::uint8_t>(70 + 24 * index + 12 * (column / width) + 3 * view),
                 static_cast<std::uint8_t>(20 + x * 30), static_cast<std::uint8_t>(20 + y * 30),
                 static_cast<std::uint8_t>(alpha)});
        }
    }
    return makeSprite("coded " + std::to_string(index), std::move(image), frames,
                      random.between(0.5, 20.0), views);
}

constexpr int kSprites = 6;

// Objects stand about at any height, in one another and in blocks.
void addObjects(Random& random, Map& map, bool coarse) {
    const int count = random.oneIn(4) ? random.between(20, 60) : random.between(1, 12);
    for (int i = 0; i < count; ++i) {
        Object object;
        object.sprite = static_cast<SpriteId>(random.below(kSprites));
        object.x = {random.between(0, map.width * 65536 - 1)};
        object.y = {random.between(0, map.depth * 65536 - 1)};
        object.z = random.oneIn(2) ? Coordinate{random.between(0, map.levels) * 65536}
                                   : Coordinate{random.between(0, map.levels * 65536)};
        if (coarse) {
            object.x = {object.x.raw >> 13 << 13};
            object.y = {object.y.raw >> 13 << 13};
        }
        object.width = {random.between(2000, 3 * 65536)};
        object.height = {random.between(2000, 3 * 65536)};
        object.light = random.between(0.5, 1.0);
        object.glow = random.oneIn(6);
        // Its own numbers, so that what follows stays as it was
        Random own(static_cast<std::uint64_t>(object.x.raw));
        const double heading = coarse ? 45.0 * own.below(8) : own.between(0.0, 360.0);
        object.facingX = toCoordinate(cosDegrees(heading));
        object.facingY = toCoordinate(sinDegrees(heading));
        map.objects.push_back(object);
    }
}

World randomWorld(Random& random, bool coarse) {
    World world;
    const bool fine = random.oneIn(3);
    // In every other world some textures are see-through.
    const int opaque = random.oneIn(2) ? kTextures : random.between(kTextures - 6, kTextures - 1);
    for (int i = 0; i < kTextures; ++i) {
        const double rate = random.between(0.5, 20.0);
        const int frames = random.oneIn(4) ? 2 : 1;
        world.textures.push_back(
            codedTexture(i, fine ? 8 << random.between(1, 2) : 8, i >= opaque, frames, rate));
    }
    world.steps = static_cast<std::int64_t>(random.between(0.0, 12'000.0));
    const int blueprints = random.between(1, 12);
    for (int i = 0; i < blueprints; ++i)
        world.blueprints.push_back(randomBlueprint(random, coarse));
    markSeeThrough(world);
    // In every third world there are portals, most of them between several maps; in every third
    // mirrors, in every fourth moving blocks (more often beside mirrors: what joins does not
    // reflect), in every third objects.
    const bool portals = random.oneIn(3);
    const int maps = portals ? random.between(1, 3) : 1;
    for (int i = 0; i < maps; ++i) world.maps.push_back(randomMap(random, world, fine, coarse));
    const bool mirrors = random.oneIn(3);
    if (random.oneIn(mirrors ? 2 : 4)) addMovers(random, world);
    if (mirrors) addMirrors(random, world);
    if (portals) addPortals(random, world);
    if (random.oneIn(3)) {
        for (int i = 0; i < kSprites; ++i) world.sprites.push_back(codedSprite(random, i));
        for (Map& map : world.maps) addObjects(random, map, coarse);
    }
    return world;
}

// Some blocks fill only a part of their tile; numbers of their own, so that the rest of the scene
// stays what it is.
void narrow(Random& random, World& world, bool coarse) {
    const auto edges = [&](Coordinate& low, Coordinate& high) {
        if (random.oneIn(3)) return;
        do {
            low = random.oneIn(4) ? Coordinate{0} : fractionOfTile(random, coarse);
            high = random.oneIn(4) ? tileEdge(1) : fractionOfTile(random, coarse);
        } while (high - low < kThinnest);
    };
    for (std::size_t i = 1; i < world.blueprints.size(); ++i) {
        CellBlueprint& block = world.blueprints[i];
        if (block.hasPortals) continue;
        if (block.origin != kEmptyCell) {
            block.plan = world.blueprints[block.origin].plan;
        } else if (random.oneIn(3)) {
            edges(block.plan.west, block.plan.east);
            edges(block.plan.north, block.plan.south);
        } else if (random.oneIn(3)) {
            block.plan.half = static_cast<Half>(random.between(1, 4));
        }
    }
    markPlans(world);
}

// The blueprints that cannot have slopes: of blocks that move or have portals, or that others were
// made from; water; mirrors; in tiles that a portal in a roof or an underside leads to, and across
// ceilings.
std::vector<bool> levelBlueprints(const World& world) {
    std::vector<bool> isLevel(world.blueprints.size());
    isLevel[kEmptyCell] = true;
    for (std::size_t i = 1; i < world.blueprints.size(); ++i) {
        const CellBlueprint& block = world.blueprints[i];
        if (block.origin != kEmptyCell) isLevel[i] = isLevel[block.origin] = true;
        if (block.isWater || block.mover >= 0 || block.hasPortals ||
            block.plan.half != Half::none || block.face(Face::top).mirror > 0)
            isLevel[i] = true;
        for (const Face face : {Face::top, Face::bottom}) {
            const PortalId id = block.face(face).portal;
            if (id == kNoPortal) continue;
            const Portal& portal = world.portals[id];
            const Map& map = world.maps[static_cast<std::size_t>(portal.toMap)];
            for (int level = 0; level < map.levels; ++level)
                isLevel[map.cell(portal.toX, portal.toY, level)] = true;
        }
    }
    for (const Map& map : world.maps) {
        if (map.ceiling.tiles.empty()) continue;
        const int level = map.ceiling.height.tile();
        const Coordinate height = map.ceiling.height - tileEdge(level);
        for (int tile = 0; level < map.levels && tile < map.width * map.depth; ++tile) {
            const BlueprintId id = map.cell(tile % map.width, tile / map.width, level);
            const CellBlueprint& block = world.blueprints[id];
            if (block.bottom < height && height < block.top) isLevel[id] = true;
        }
    }
    return isLevel;
}

// Some blocks rise; numbers of their own, so that the rest of the scene stays what it is.
void incline(Random& random, World& world, bool coarse) {
    const std::vector<bool> isLevel = levelBlueprints(world);
    for (std::size_t i = 1; i < world.blueprints.size(); ++i) {
        CellBlueprint& block = world.blueprints[i];
        if (isLevel[i] || random.oneIn(4)) continue;
        const int side = random.below(4);
        const auto height = [&] {
            const int part = coarse ? random.between(0, 4) * 16384 : random.between(0, 65536);
            return Coordinate{block.bottom.raw +
                              static_cast<std::int32_t>(
                                  std::int64_t{(block.top - block.bottom).raw} * part / 65536)};
        };
        Slant bottom;
        Slant top;
        do {
            bottom = {block.bottom, random.oneIn(2) ? block.bottom : height()};
            top = {block.top, random.oneIn(4) ? block.top : height()};
            if (random.oneIn(2)) std::swap(bottom.from, bottom.to);
            if (random.oneIn(2)) std::swap(top.from, top.to);
        } while (bottom.from > top.from || bottom.to > top.to ||
                 (bottom.from == top.from && bottom.to == top.to));
        block.slopes = slopesTo(static_cast<Face>(side), bottom, top);
    }
}

// Slopes that climb from level to level, side by side, and halves in a row along their cuts, where
// the map holds nothing special.
void goOn(Random& random, World& world) {
    std::vector<bool> isLevel = levelBlueprints(world);
    isLevel[kEmptyCell] = false;
    for (std::size_t i = 1; i < world.blueprints.size(); ++i) {
        CellBlueprint& block = world.blueprints[i];
        const bool isHalf =
            block.plan.half != Half::none && block.isStill() && block.bottom < block.top;
        if (!isHalf && (isLevel[i] || !block.slopes.any())) continue;
        const int side = random.below(4);
        if (!isHalf) {
            const bool isRoof = !random.oneIn(3);
            const Slant slant = {{0}, tileEdge(1)};
            const CellBlueprint before = block;
            block.bottom = {0};
            block.top = tileEdge(1);
            block.slopes = slopesTo(static_cast<Face>(side), isRoof ? Slant{} : slant,
                                    isRoof ? slant : Slant{tileEdge(1), tileEdge(1)});
            if (levelBlueprints(world)[i]) {  // a ceiling is in the way
                block = before;
                continue;
            }
        }
        // A step ahead and a step beside
        const int alongY = isHalf ? (isCutFalling(block.plan.half) ? 1 : -1) : 0;
        constexpr int kAhead[4][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
        for (int tries = 0; tries < 12; ++tries) {
            const int mapIndex = random.below(static_cast<int>(world.maps.size()));
            Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
            const int x = random.below(map.width);
            const int y = random.below(map.depth);
            const int level = random.below(map.levels);
            for (int ahead = 0; ahead < 3; ++ahead) {
                for (int beside = 0; beside < 2; ++beside) {
                    const int atX =
                        x + (isHalf ? ahead : kAhead[side][0] * ahead + kAhead[side][1] * beside);
                    const int atY =
                        y + (isHalf ? alongY * ahead
                                    : kAhead[side][1] * ahead + kAhead[side][0] * beside);
                    const int atLevel = level + (isHalf ? beside : ahead);
                    if (!map.contains(atX, atY) || atLevel >= map.levels) continue;
                    if (!map.ceiling.tiles.empty() && map.ceiling.height.tile() == atLevel)
                        continue;
                    if (!isHalf && isExitFromLevelFace(world, mapIndex, atX, atY)) continue;
                    if (isLevel[map.cell(atX, atY, atLevel)]) continue;
                    map.setCell(atX, atY, atLevel, static_cast<BlueprintId>(i));
                }
            }
        }
    }
    markPlans(world);
}

// Some blocks have variants, which may be see-through where the others are not; numbers of their
// own, so that the rest of the scene stays what it is.
void vary(Random& random, World& world) {
    const std::size_t blueprints = world.blueprints.size();
    for (std::size_t i = 1; i < blueprints; ++i) {
        const auto id = static_cast<BlueprintId>(i);
        if (world.blueprints[i].hasPortals || world.blueprints[i].mover >= 0 || random.oneIn(2))
            continue;
        CellBlueprint variant = instanceOf(world, id);
        for (FaceBlueprint& face : variant.faces) {
            if (face.texture != kNoTexture && !random.oneIn(3)) face.texture = anyTexture(random);
        }
        const auto other = static_cast<BlueprintId>(world.blueprints.size());
        world.blueprints.push_back(std::move(variant));
        for (Map& map : world.maps) {
            for (BlueprintId& cell : map.cells) {
                if (cell == id && random.oneIn(2)) cell = other;
            }
        }
    }
    markSeeThrough(world);
}

// Round about an eye below the ceiling, blocks whose undersides lie in the ceiling's plane and look
// as it does, where the map holds nothing special; numbers of their own, so that the rest of the
// scene stays what it is.
void hangInCeiling(Random& random, World& world, const View& view) {
    std::vector<bool> isLevel = levelBlueprints(world);
    isLevel[kEmptyCell] = false;
    Map& map = world.maps[static_cast<std::size_t>(view.map)];
    const int level = map.ceiling.height.tile();
    if (map.ceiling.tiles.empty() || level >= map.levels || view.z >= map.ceiling.height) return;
    const auto near = [&](Coordinate eye, int tiles) {
        return std::clamp(eye.tile() + random.between(-3, 3), 0, tiles - 1);
    };
    const int tileX = near(view.x, map.width);
    const TextureId texture = map.ceiling.tiles[map.tileIndex(tileX, near(view.y, map.depth))];
    if (texture == kNoTexture) return;
    CellBlueprint block;
    block.bottom = map.ceiling.height - tileEdge(level);
    for (FaceBlueprint& face : block.faces) face.texture = texture;
    FaceBlueprint& underside = block.faces[static_cast<std::size_t>(Face::bottom)];
    underside.light = map.ceiling.light;
    underside.glow = map.ceiling.glow;
    const auto id = static_cast<BlueprintId>(world.blueprints.size());
    world.blueprints.push_back(block);
    isLevel.push_back(false);
    for (int tries = 0; tries < 12; ++tries) {
        const int x = near(view.x, map.width);
        const int y = near(view.y, map.depth);
        if (!isLevel[map.cell(x, y, level)]) map.setCell(x, y, level, id);
    }
    markSeeThrough(world);
}

// More lamps than light one place, within a few tiles.
void crowdLamps(Random& random, Map& map) {
    if (!map.baked.on) return;
    const auto place = [&](int units) { return Coordinate{random.between(0, units * 4) << 14}; };
    for (int i = random.between(70, 150); i > 0; --i) {
        Lamp lamp = {place(std::min(map.width, 6)),
                     place(std::min(map.depth, 6)),
                     place(std::min(map.levels, 4)),
                     {}};
        lamp.kind.colour = anyColour(random);
        lamp.kind.strength = random.between(0.02, 0.2);
        lamp.kind.radius = {random.between(65536, 6 * 65536)};
        map.baked.lamps.push_back(lamp);
    }
}

// Some worlds have baked light; numbers of their own, so that the rest of the scene stays what it
// is.
void light(Random& random, World& world) {
    for (int i = 0; i < 3; ++i)
        world.lampKinds.push_back({.colour = anyColour(random),
                                   .strength = random.between(0.2, 4.0),
                                   .radius = {random.between(20'000, 6 * 65536)}});
    if (random.oneIn(2)) goOn(random, world);
    for (Map& map : world.maps) {
        BakedLight& baked = map.baked;
        baked.on = !random.oneIn(4);
        if (!random.oneIn(3)) baked.sun = anyColour(random);
        baked.azimuth =
            random.oneIn(4) ? 45.0 * random.between(-8, 8) : random.between(-400.0, 400.0);
        baked.altitude = random.oneIn(4)   ? 45.0 * random.between(1, 2)
                         : random.oneIn(4) ? random.between(1.0, 15.0)
                                           : random.between(15.0, 90.0);
        baked.ambient = anyColour(random);
        baked.lampStrength = random.oneIn(3) ? random.between(0.0, 2.0) : 1.0;
        for (int i = random.oneIn(3) ? 0 : random.between(1, 8); i > 0; --i) {
            Lamp lamp;
            lamp.x = {random.between(0, map.width * 65536)};
            lamp.y = {random.between(0, map.depth * 65536)};
            lamp.z = {random.between(0, map.levels * 65536)};
            if (random.oneIn(2)) {
                lamp.x = {lamp.x.raw >> 14 << 14};
                lamp.y = {lamp.y.raw >> 14 << 14};
                lamp.z = {lamp.z.raw >> 14 << 14};
            }
            lamp.kind = world.lampKinds[static_cast<std::size_t>(random.below(3))];
            baked.lamps.push_back(lamp);
        }
    }
    for (Map& map : world.maps) {
        for (Object& object : map.objects) {
            if (random.oneIn(10)) object.lamp = static_cast<LampId>(random.below(3));
        }
    }
    for (CellBlueprint& block : world.blueprints) {
        for (FaceBlueprint& face : block.faces) {
            if (block.mover < 0 && random.oneIn(40))
                face.lamp = static_cast<LampId>(random.below(3));
        }
    }
    if (random.oneIn(24)) crowdLamps(random, world.maps[0]);
}

// Some of the still blocks become water, which may lack faces; numbers of their own, so that the
// rest of the scene stays what it is.
void flood(Random& random, World& world) {
    for (std::size_t i = 1; i < world.blueprints.size(); ++i) {
        CellBlueprint& block = world.blueprints[i];
        if (block.hasPortals || block.mover >= 0 || random.oneIn(3)) continue;
        block.isWater = block.seeThrough = true;
        block.plan = {};
        block.waterColour = anyColour(random);
        block.waterSight = random.between(0.5, 30.0);
        for (FaceBlueprint& face : block.faces) {
            if (face.mirror == 0 && random.oneIn(3)) face.texture = kNoTexture;
        }
    }
    markPlans(world);
}

SkyDisc randomDisc(Random& random) {
    SkyDisc disc;
    disc.size = random.oneIn(4) ? random.between(0.1, 2.0) : random.between(2.0, kMaxDiscSize);
    disc.azimuth = random.oneIn(4) ? 90.0 * random.below(4) : random.between(0.0, 360.0);
    disc.altitude = random.between(0.0, 45.0);
    disc.glow = random.oneIn(3) ? 0.0 : random.between(0.0, kMaxGlow);
    disc.colour = anyColour(random);
    return disc;
}

// Some skies have layers, some mirrors ripples; numbers of their own, so that the rest of the scene
// stays what it is.
void stir(std::uint64_t seed, World& world) {
    static const std::shared_ptr<const CloudCover> kShapes[] = {makeCloudCover(1, 1.0),
                                                                makeCloudCover(2, 0.3)};
    Random random(seed ^ 0x73746972u);
    for (Map& map : world.maps) {
        if (random.oneIn(2)) continue;
        Sky& sky = map.sky;
        if (random.oneIn(2)) {
            sky.stars = {.density = random.between(0.0, 1.0),
                         .seed = static_cast<std::uint32_t>(random.between(0, 1 << 30)),
                         .brightness = random.between(0.5, 1.0),
                         .colour = anyColour(random)};
        }
        if (random.oneIn(3)) sky.sun = randomDisc(random);
        if (random.oneIn(3)) sky.moon = randomDisc(random);
        if (random.oneIn(2)) {
            sky.clouds = {.shape = kShapes[random.below(2)],
                          .cover = random.between(0.2, 1.0),
                          .speed = random.between(-kMaxCloudSpeed, kMaxCloudSpeed),
                          .opacity = random.between(0.3, 1.0),
                          .colour = anyColour(random),
                          .shade = anyColour(random)};
        }
    }
    // Rates at which frames come exactly with a step
    Random rates(seed ^ 0x72617465u);
    if (rates.oneIn(2)) {
        for (Texture& texture : world.textures)
            texture.rate = texture.frames() > 1 ? 120.0 / rates.between(1, 12) : 0.0;
    }
    if (random.oneIn(2)) return;
    const auto ripples = [&](std::uint8_t mirror) {
        return static_cast<std::uint8_t>(mirror > 0 && !random.oneIn(4) ? random.between(1, 255)
                                                                        : 0);
    };
    for (Map& map : world.maps) map.floor.ripples = ripples(map.floor.mirror);
    for (CellBlueprint& block : world.blueprints) {
        FaceBlueprint& top = block.faces[static_cast<std::size_t>(Face::top)];
        top.ripples = ripples(top.mirror);
    }
}

// The eye somewhere in water, if there is some. Most of the time the whole levels above are water
// too.
void dive(Random& random, World& world, View& view) {
    Map& map = world.maps[static_cast<std::size_t>(view.map)];
    for (int tries = 0; tries < 200; ++tries) {
        const int x = random.below(map.width);
        const int y = random.below(map.depth);
        const int level = random.below(map.levels);
        const BlueprintId id = map.cell(x, y, level);
        const CellBlueprint& block = world.blueprints[id];
        if (!block.isWater) continue;
        if (level + 1 < map.levels && map.cell(x, y, level + 1) == kEmptyCell && !random.oneIn(3))
            map.setCell(x, y, level + 1, id);
        view.x = {random.between(x * 65536, x * 65536 + 65535)};
        view.y = {random.between(y * 65536, y * 65536 + 65535)};
        const int base = level * 65536;
        view.z = {std::max(1, random.between(base + block.bottom.raw, base + block.top.raw - 1))};
        if (random.oneIn(6)) view.z = {std::max(1, base + block.bottom.raw)};
        return;
    }
}

// The eye somewhere in what moves, if there is some.
void enterMover(Random& random, const World& world, View& view) {
    const Map& map = world.maps[static_cast<std::size_t>(view.map)];
    for (int tries = 0; tries < 200; ++tries) {
        const int x = random.below(map.width);
        const int y = random.below(map.depth);
        const int level = random.below(map.levels);
        const CellBlueprint& block = world.blueprints[map.cell(x, y, level)];
        if (block.mover < 0) continue;
        view.x = {random.between(x * 65536, x * 65536 + 65535)};
        view.y = {random.between(y * 65536, y * 65536 + 65535)};
        const int base = level * 65536;
        view.z = {std::max(1, random.between(base + block.bottom.raw, base + block.top.raw - 1))};
        return;
    }
}

bool insideBlock(const World& world, const View& view) {
    const Map& map = world.maps[static_cast<std::size_t>(view.map)];
    const int level = view.z.tile();
    const BlueprintId id = map.cell(view.x.tile(), view.y.tile(), level);
    if (id == kEmptyCell) return false;
    const Coordinate height = view.z - tileEdge(level);
    return height >= world.blueprints[id].bottom && height < world.blueprints[id].top;
}

// From along a border to along a cut, by an eighth turn: the middle ray passes from corner to
// corner. Edges of plans and cuts across the way would be borders between texels there, so there
// are only halves that are cut along it.
void turnAlongCut(Random& random, Scene& scene, bool isFalling) {
    std::vector<CellBlueprint>& blocks = scene.world.blueprints;
    for (std::size_t i = 1; i < blocks.size(); ++i) {
        blocks[i].plan = blocks[blocks[i].origin].plan;
        // Then slopes that have gone along lie over the whole tile again
        blocks[i].slopes.bottom.shift = blocks[i].slopes.top.shift = {};
        Half half = static_cast<Half>(random.between(0, 4));
        if (isCutFalling(half) != isFalling) half = Half::none;
        if (blocks[i].origin == kEmptyCell) blocks[i].plan.half = half;
        if (blocks[i].isWater || blocks[i].hasPortals || blocks[i].slopes.any())
            blocks[i].plan = {};
    }
    markPlans(scene.world);
    View& view = scene.view;
    // Off by so little that rounding decides at the corners, at some and not at others
    view.headingDegrees = std::floor(view.headingDegrees + 0.5) + 45.0;
    const double step = std::nextafter(view.headingDegrees, 400.0) - view.headingDegrees;
    view.headingDegrees += random.between(-2, 2) * step;
    const int x = view.x.raw & 0xffff;
    view.y = {tileEdge(view.y.tile()).raw + (isFalling ? x : (65536 - x) & 0xffff)};
}

// Each kind of moving block, in one of so many worlds.
void addWhatMoves(std::uint64_t seed, Random& random, World& world, int odds, bool coarse) {
    addKin(random, world);
    changeMovers(random, world);
    Random uneven(seed ^ 0x756e6576u);
    if (uneven.oneIn(odds)) addUneven(uneven, world, coarse || uneven.oneIn(2));
    Random sliders(seed ^ 0x736c6964u);
    if (sliders.oneIn(odds)) addSliders(sliders, world, coarse || sliders.oneIn(2));
}

// What comes after all blocks that a scene may have anyway.
void finish(std::uint64_t seed, Scene& scene, Random& lamps, bool isLit) {
    Random wedges(seed ^ 0x63757473u);
    if (isLit && wedges.oneIn(3)) addRamps(wedges, scene.world, false, true);
    Random variants(seed ^ 0x76617269u);
    if (variants.oneIn(6)) vary(variants, scene.world);
    if (isLit) light(lamps, scene.world);
    Random hung(seed ^ 0x68616e67u);
    if (isLit && scene.world.portals.empty()) hangInCeiling(hung, scene.world, scene.view);
    widenSliders(scene.world);
    stir(seed, scene.world);
    Random smooth(seed ^ 0x736d6f6fu);
    scene.view.smooth = smooth.oneIn(3);
}

}  // namespace

Scene randomScene(std::uint64_t seed, int width, int height) {
    Random random(seed);
    Scene scene{randomWorld(random, random.oneIn(3)), {}};
    View& view = scene.view;
    view.map = random.below(static_cast<int>(scene.world.maps.size()));
    const Map& map = scene.world.maps[static_cast<std::size_t>(view.map)];
    view.width = width;
    view.height = height;
    view.fovDegrees = random.between(30.0, 110.0);
    view.headingDegrees =
        random.oneIn(6) ? 45.0 * random.between(-8, 16) : random.between(-400.0, 800.0);
    view.look = random.oneIn(3) ? random.between(-2.0, 2.0) : random.between(-0.4, 0.4);
    view.detail = !random.oneIn(4);
    view.light = !random.oneIn(8);
    view.fog = !random.oneIn(8);
    if (random.oneIn(3)) view.mirrors = random.between(0.0, 3.0);
    const bool wantInside = random.oneIn(12);
    const bool wantOutside = random.oneIn(12);
    for (int tries = 0; tries < 50; ++tries) {
        const int margin = wantOutside ? 6 : 0;
        view.x = {random.between(-margin * 65536, (map.width + margin) * 65536 - 1)};
        view.y = {random.between(-margin * 65536, (map.depth + margin) * 65536 - 1)};
        if (random.oneIn(8)) view.x = tileEdge(view.x.tile());
        if (random.oneIn(8)) view.y = tileEdge(view.y.tile());
        // Beside a wall: a step of the grid, or a few, from the border.
        if (random.oneIn(8)) view.x = {tileEdge(view.x.tile()).raw + random.between(-3, 3)};
        if (random.oneIn(8)) view.y = {tileEdge(view.y.tile()).raw + random.between(-3, 3)};
        const int heights = random.oneIn(4) ? map.levels + 4 : map.levels;
        view.z = {random.between(1, heights * 65536)};
        if (random.oneIn(6)) view.z = {std::max(1, view.z.raw >> 13) * 8192};
        if (random.oneIn(12)) view.z = {random.between(1, 40)};
        if (insideBlock(scene.world, view) == wantInside) break;
    }
    Random plans(seed ^ 0x706c616eu);
    if (plans.oneIn(3)) narrow(plans, scene.world, plans.oneIn(2));
    Random water(seed ^ 0x77617465u);
    if (water.oneIn(4)) {
        flood(water, scene.world);
        if (!water.oneIn(4)) dive(water, scene.world, view);
    }
    Random more(seed ^ 0x6d6f7265u);
    addWhatMoves(seed, more, scene.world, 4, false);
    Random slopes(seed ^ 0x736c6f70u);
    Random lamps(seed ^ 0x6c616d70u);
    const bool isLit = lamps.oneIn(4);
    if (slopes.oneIn(3) || (isLit && lamps.oneIn(2))) incline(slopes, scene.world, slopes.oneIn(2));
    Random ramps(seed ^ 0x72616d70u);
    if (ramps.oneIn(3)) addRamps(ramps, scene.world, ramps.oneIn(2));
    if (more.oneIn(6)) enterMover(more, scene.world, view);
    finish(seed, scene, lamps, isLit);
    Random detail(seed ^ 0x64657461u);
    if (detail.oneIn(6)) view.detailThreshold = detail.between(0.2, 5.0);
    view.textures = !detail.oneIn(30);
    return scene;
}

Scene tieScene(std::uint64_t seed, int width, int height) {
    Random random(seed);
    Scene scene{randomWorld(random, true), {}};
    View& view = scene.view;
    view.map = random.below(static_cast<int>(scene.world.maps.size()));
    const Map& map = scene.world.maps[static_cast<std::size_t>(view.map)];
    view.width = width;
    view.height = height;
    view.fovDegrees = 90.0;
    view.headingDegrees = 45.0 * random.between(0, 7);
    view.look = 0.125 * random.between(-4, 4);
    view.detail = !random.oneIn(3);
    const auto onGrid = [&](int tiles) {
        return Coordinate{random.oneIn(2) ? random.between(0, tiles) * 65536
                                          : random.between(0, tiles * 8) * 8192};
    };
    view.x = onGrid(map.width);
    view.y = onGrid(map.depth);
    view.z = {random.between(1, map.levels * 8 + 4) * 8192};
    Random plans(seed ^ 0x706c616eu);
    if (!plans.oneIn(3)) narrow(plans, scene.world, true);
    Random more(seed ^ 0x6d6f7265u);
    addWhatMoves(seed, more, scene.world, 3, true);
    Random slopes(seed ^ 0x736c6f70u);
    if (!slopes.oneIn(3)) incline(slopes, scene.world, true);
    Random ramps(seed ^ 0x72616d70u);
    if (ramps.oneIn(2)) addRamps(ramps, scene.world, true);
    Random lamps(seed ^ 0x6c616d70u);
    const bool isLit = lamps.oneIn(4);
    finish(seed, scene, lamps, isLit);
    return scene;
}

// Some of the textures have 256 or 512 texels a side, each of any colour; the view is narrow, so
// that many of these are seen.
Scene largeTextureScene(std::uint64_t seed, int width, int height) {
    constexpr std::size_t kEach = 4;
    Scene scene = randomScene(seed, width, height);
    Random random(seed ^ 0x6c617267u);
    for (std::size_t i = 0; i < scene.world.textures.size(); i += kEach) {
        const bool seeThrough = scene.world.textures[i].seeThrough;
        const int size = random.oneIn(2) ? 256 : 512;
        Image image(size, size);
        for (Pixel& pixel : image.pixels) {
            Colour colour = anyColour(random);
            if (seeThrough) colour.a = static_cast<std::uint8_t>(85 * random.below(4));
            pixel = toPixel(colour);
        }
        scene.world.textures[i] = makeTexture("large " + std::to_string(i), image);
    }
    scene.view.fovDegrees = random.between(10.0, 40.0);
    return scene;
}

Scene alongBorderScene(std::uint64_t seed, int width, int height) {
    Scene scene = randomScene(seed, width, height);
    Random random(seed ^ 0x616c6f6eu);
    View& view = scene.view;
    constexpr double kRounding = 1.0 / 17592186044416.0;  // 2^-44, of numbers below 360 degrees
    const int quarter = random.below(4);
    view.headingDegrees = 90.0 * quarter + random.between(-2, 2) * kRounding;
    Coordinate& across = quarter % 2 == 0 ? view.y : view.x;
    across = tileEdge(across.tile());
    if (random.oneIn(4)) turnAlongCut(random, scene, quarter % 2 == 0);
    return scene;
}

}  // namespace slicecast::judge

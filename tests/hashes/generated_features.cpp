#include "generated_features.h"

#include "base/angle.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

namespace slicecast {
namespace {

struct Cell {
    int x;
    int y;
    int level;
};

Cell anyCell(Random& random, const Map& map) {
    const int x = random.below(map.width);
    const int y = random.below(map.depth);
    return {x, y, random.below(map.levels)};
}

Image anyImage(Random& random, int width, int height) {
    Image image(width, height);
    for (Pixel& pixel : image.pixels) {
        const int bits = random.between(0, 0xffffff);
        const int alpha = random.oneIn(3) ? 0 : random.oneIn(3) ? random.between(1, 254) : 255;
        pixel = toPixel({static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                         static_cast<std::uint8_t>(bits >> 16), static_cast<std::uint8_t>(alpha)});
    }
    return image;
}

// Single pictures, sheets that run, and sheets that are held; some blueprints show them.
void addSeeThrough(Random& random, World& world) {
    const int first = static_cast<int>(world.textures.size());
    for (int i = 0; i < 6; ++i) {
        const int frames = i < 2 ? 1 : random.between(2, 4);
        const int size = 8 << random.below(3);
        const double rate = i < 4 ? random.between(0.5, 20.0) : 0.0;
        world.textures.push_back(makeTexture("glass " + std::to_string(i),
                                             anyImage(random, size * frames, size), frames, rate));
    }
    const int shapes = static_cast<int>(world.blueprints.size());
    for (int id = 1; id < shapes; ++id) {
        CellBlueprint& blueprint = world.blueprints[static_cast<std::size_t>(id)];
        blueprint.join = !random.oneIn(3);
        if (random.oneIn(2)) continue;
        for (FaceBlueprint& face : blueprint.faces) {
            if (!random.oneIn(3))
                face.texture = static_cast<TextureId>(random.between(first, first + 5));
            face.glow = random.oneIn(8);
        }
    }
}

void addMirrors(Random& random, World& world) {
    const auto strength = [&] { return static_cast<std::uint8_t>(random.between(1, 255)); };
    for (Map& map : world.maps) {
        if (random.oneIn(2)) map.floor.mirror = strength();
    }
    for (CellBlueprint& blueprint : world.blueprints) {
        if (random.oneIn(3))
            blueprint.faces[static_cast<std::size_t>(Face::top)].mirror = strength();
    }
}

PortalId anyPortal(Random& random, World& world, int map, Cell at) {
    Portal portal = {.fromMap = map,
                     .fromX = at.x,
                     .fromY = at.y,
                     .toMap = random.below(static_cast<int>(world.maps.size()))};
    const Map& exit = world.maps[static_cast<std::size_t>(portal.toMap)];
    portal.toX = random.below(exit.width);
    portal.toY = random.below(exit.depth);
    portal.turn = random.below(4);
    portal.levels = random.oneIn(3) ? random.between(-2, 2) : 0;
    world.portals.push_back(portal);
    return static_cast<PortalId>(world.portals.size() - 1);
}

void addPortals(Random& random, World& world) {
    world.portalLimit = random.between(0, 10);
    for (int m = 0; m < static_cast<int>(world.maps.size()); ++m) {
        Map& map = world.maps[static_cast<std::size_t>(m)];
        map.tilePortals.assign(map.occupied.size(), kNoPortal);
        const int portals = random.between(1, 12);
        for (int i = 0; i < portals; ++i) {
            const Cell at = anyCell(random, map);
            const BlueprintId block = map.cell(at.x, at.y, at.level);
            if (block == kEmptyCell) {
                map.tilePortals[map.tileIndex(at.x, at.y)] = anyPortal(random, world, m, at);
                continue;
            }
            CellBlueprint instance = world.blueprints[block];
            for (FaceBlueprint& face : instance.faces) {
                if (random.oneIn(2)) face.portal = anyPortal(random, world, m, at);
            }
            world.blueprints.push_back(std::move(instance));
            map.setCell(at.x, at.y, at.level,
                        static_cast<BlueprintId>(world.blueprints.size() - 1));
        }
    }
}

void addObjects(Random& random, World& world) {
    for (int i = 0; i < 3; ++i) {
        const int frames = random.between(1, 3);
        const int height = random.between(5, 40);
        const int views = i == 2 ? kSpriteViews : 1;
        world.sprites.push_back(makeSprite("figure " + std::to_string(i),
                                           anyImage(random, 16 * frames, height * views), frames,
                                           4.0, views));
    }
    for (int m = 0; m < static_cast<int>(world.maps.size()); ++m) {
        Map& map = world.maps[static_cast<std::size_t>(m)];
        const int objects = random.between(0, 60);
        for (int i = 0; i < objects; ++i) {
            Object object;
            object.sprite = static_cast<SpriteId>(random.below(3));
            object.x = {random.between(0, map.width * 65536 - 1)};
            object.y = {random.between(0, map.depth * 65536 - 1)};
            object.z =
                random.oneIn(2) ? Coordinate{0} : Coordinate{random.between(0, map.levels * 65536)};
            object.width = {random.between(4096, 2 * 65536)};
            object.height = {random.between(4096, 2 * 65536)};
            object.light = random.unit();
            object.glow = random.oneIn(5);
            // Its own numbers, so that what follows stays as it was
            Random own(static_cast<std::uint64_t>(object.x.raw));
            const double heading = own.between(0.0, 360.0);
            object.facingX = toCoordinate(cosDegrees(heading));
            object.facingY = toCoordinate(sinDegrees(heading));
            map.objects.push_back(object);
            if (!random.oneIn(3)) continue;
            ObjectMotion motion;
            motion.kind = static_cast<ObjectMotion::Kind>(random.below(3));
            motion.map = m;
            motion.object = i;
            motion.speed = random.between(0.1, 3.0);
            motion.headingDegrees = random.between(0.0, 360.0);
            motion.reach = {random.between(16384, 4 * 65536)};
            motion.random = Random(static_cast<std::uint64_t>(random.between(0, 1 << 30)));
            world.movingObjects.motions.push_back(motion);
        }
    }
}

// Blocks that go east and west, or south and north, between two tiles of their own.
void addSliders(Random& random, World& world) {
    for (const Axis axis : {Axis::x, Axis::y}) {
        CellBlueprint sliding = world.blueprints[1];
        for (FaceBlueprint& face : sliding.faces) face.portal = kNoPortal;
        sliding.name = axis == Axis::x ? "slides along x" : "slides along y";
        sliding.plan = {};
        sliding.slopes = {};
        sliding.motion = static_cast<int>(world.motions.size());
        world.motions.push_back({.name = sliding.name,
                                 .axis = axis,
                                 .to = {random.between(1, 65536)},
                                 .periodSteps = random.between(200, 800),
                                 .phaseSteps = random.below(200)});
        const auto id = static_cast<BlueprintId>(world.blueprints.size());
        world.blueprints.push_back(std::move(sliding));
        for (Map& map : world.maps) {
            const Cell at = anyCell(random, map);
            const Cell next = {at.x + (axis == Axis::x ? 1 : 0), at.y + (axis == Axis::y ? 1 : 0),
                               at.level};
            // Nothing else may move in their columns, or to them from the tiles before
            const auto isTaken = [&](const Cell& cell) {
                for (int level = 0; level < map.levels; ++level) {
                    for (const auto& [x, y] :
                         {std::pair{cell.x, cell.y}, {cell.x - 1, cell.y}, {cell.x, cell.y - 1}}) {
                        if (!world.blueprints[map.cell(x, y, level)].isStill()) return true;
                    }
                }
                return false;
            };
            if (!map.contains(next.x, next.y) || isTaken(at) || isTaken(next)) continue;
            map.setCell(next.x, next.y, next.level, kEmptyCell);
            map.setCell(at.x, at.y, at.level, id);
        }
    }
}

// In columns of their own, so that nothing is in their way.
void addMovers(Random& random, World& world) {
    for (int i = 0; i < 3; ++i) {
        Motion motion;
        motion.name = "motion " + std::to_string(i);
        motion.edges = i == 0 ? MovingEdges::both : MovingEdges::high;
        motion.from = {i == 0 ? 0 : -random.between(1, 30000)};
        motion.to = {i == 0 ? random.between(1, 65536) : 0};
        motion.periodSteps = random.between(200, 800);
        motion.phaseSteps = random.below(motion.periodSteps);
        motion.shape = static_cast<MotionShape>(random.below(3));
        world.motions.push_back(std::move(motion));
    }
    world.gateKinds.push_back({.steps = random.between(10, 200),
                               .opensOnApproach = true,
                               .approach = tileEdge(2),
                               .holdSteps = random.between(1, 200)});
    const int shapes = static_cast<int>(world.blueprints.size());
    for (int i = 0; i < 4; ++i) {
        CellBlueprint moving =
            world.blueprints[static_cast<std::size_t>(random.between(1, shapes - 1))];
        for (FaceBlueprint& face : moving.faces) face.portal = kNoPortal;
        if (i < 3) {
            moving.motion = i;
            moving.bottom = {};
            moving.top = tileEdge(i == 0 ? 0 : 1) + Coordinate{i == 0 ? 20000 : 0};
        } else {
            moving.gate = 0;
            const int held = static_cast<int>(world.textures.size()) - 1;
            moving.faces[static_cast<std::size_t>(Face::west)].texture =
                static_cast<TextureId>(held);
        }
        world.blueprints.push_back(std::move(moving));
    }
    for (Map& map : world.maps) {
        for (int i = 0; i < 8; ++i) {
            const Cell at = anyCell(random, map);
            if (map.levels < 2 || map.tilePortal(at.x, at.y) != kNoPortal) continue;
            for (int level = 0; level < map.levels; ++level)
                map.setCell(at.x, at.y, level, kEmptyCell);
            map.setCell(at.x, at.y, 0, static_cast<BlueprintId>(shapes + random.below(4)));
        }
    }
}

// Still blocks become water that lacks faces; an eye that comes to be in one sees its colour.
void addWater(Random& random, World& world) {
    for (std::size_t id = 1; id < world.blueprints.size(); ++id) {
        CellBlueprint& block = world.blueprints[id];
        if (block.hasPortals || block.mover >= 0 || block.gate >= 0 || !random.oneIn(3)) continue;
        block.isWater = true;
        block.waterSight = random.between(1.0, 20.0);
        for (FaceBlueprint& face : block.faces) {
            if (face.mirror == 0 && random.oneIn(3)) face.texture = kNoTexture;
        }
    }
}

// Blocks that fill a part of their tile, a half of it, or that have slopes.
CellBlueprint anyShape(Random& random, const World& world) {
    CellBlueprint shape;
    shape.name = "shape";
    for (FaceBlueprint& face : shape.faces) {
        face.texture =
            static_cast<TextureId>(random.below(static_cast<int>(world.textures.size())));
        face.light = random.unit();
    }
    const auto edge = [&](int low, int high) { return Coordinate{random.between(low, high)}; };
    switch (random.below(3)) {
        case 0:
            shape.plan.west = edge(0, 30000);
            shape.plan.east = edge(35000, 65536);
            shape.plan.north = edge(0, 30000);
            shape.plan.south = edge(35000, 65536);
            break;
        case 1:
            shape.plan.half = static_cast<Half>(random.between(1, 4));
            break;
        default: {
            const Slant bottom = {edge(0, 20000), edge(0, 20000)};
            const Slant top = {edge(20000, 65536), edge(20001, 65536)};
            shape.slopes = slopesTo(static_cast<Face>(random.below(4)), bottom, top);
            shape.bottom = bottom.least();
            shape.top = top.most();
        }
    }
    return shape;
}

// Blocks with slopes that go east, south or up, into a cell of their own, where there is room.
void addRamps(Random& random, World& world) {
    for (int i = 0; i < 30; ++i) {
        const Axis axis = static_cast<Axis>(i % 3);
        const auto heights = [&](int low, int high) {
            Slant slant;
            slant.from = {random.between(low, high)};
            slant.to = {random.between(low, high)};
            return slant;
        };
        const Slant bottom = heights(0, 20000);
        const Slant top = heights(20001, 65536);
        CellBlueprint ramp = world.blueprints[static_cast<std::size_t>(1 + i % 2)];
        for (FaceBlueprint& face : ramp.faces) face.portal = kNoPortal;
        ramp.faces[static_cast<std::size_t>(Face::top)].mirror = 0;
        ramp.name = "ramp " + std::to_string(i);
        ramp.plan = {};
        ramp.slopes = slopesTo(static_cast<Face>(random.below(4)), bottom, top);
        ramp.bottom = bottom.least();
        ramp.top = top.most();
        ramp.motion = static_cast<int>(world.motions.size());
        Motion motion;
        motion.name = ramp.name;
        motion.axis = axis;
        motion.to = {random.between(1, 65536)};
        motion.periodSteps = random.between(200, 800);
        motion.phaseSteps = random.below(200);
        const auto map =
            static_cast<std::size_t>(random.below(static_cast<int>(world.maps.size())));
        const Cell at = anyCell(random, world.maps[map]);
        World trial = world.copy();
        Map& there = trial.maps[map];
        const Cell next = {at.x + (axis == Axis::x ? 1 : 0), at.y + (axis == Axis::y ? 1 : 0),
                           at.level + (axis == Axis::z ? 1 : 0)};
        if (!there.contains(next.x, next.y) || next.level >= there.levels) continue;
        trial.blueprints.push_back(std::move(ramp));
        trial.motions.push_back(std::move(motion));
        if (!trial.blueprints[there.cell(at.x, at.y, at.level)].isStill() ||
            !trial.blueprints[there.cell(next.x, next.y, next.level)].isStill())
            continue;
        there.setCell(next.x, next.y, next.level, kEmptyCell);
        there.setCell(at.x, at.y, at.level, static_cast<BlueprintId>(trial.blueprints.size() - 1));
        World made = trial.copy();
        if (makeMovers(made).empty()) world = std::move(trial);
    }
}

}  // namespace

void addShapes(Random& random, World& world) {
    const int first = static_cast<int>(world.blueprints.size());
    for (int i = 0; i < 12; ++i) world.blueprints.push_back(anyShape(random, world));
    for (std::size_t m = 0; m < world.maps.size(); ++m) {
        Map& map = world.maps[m];
        const int shapes = map.width * map.depth / 2;
        for (int i = 0; i < shapes; ++i) {
            const Cell at = anyCell(random, map);
            const auto id = static_cast<BlueprintId>(first + random.below(12));
            const std::size_t tile = map.tileIndex(at.x, at.y);
            const bool changes = !map.changing.empty() && map.changing[tile] != 0;
            const bool hasExit =
                std::any_of(world.portals.begin(), world.portals.end(), [&](const Portal& portal) {
                    return portal.toMap == static_cast<int>(m) && portal.toX == at.x &&
                           portal.toY == at.y;
                });
            const bool isCut = !map.ceiling.tiles.empty() && map.ceiling.height.tile() == at.level;
            if (changes || hasExit || isCut || map.tilePortal(at.x, at.y) != kNoPortal ||
                world.blueprints[map.cell(at.x, at.y, at.level)].hasPortals)
                continue;
            map.setCell(at.x, at.y, at.level, id);
        }
    }
    markPlans(world);
    markSeeThrough(world);
}

void addLight(Random& random, World& world) {
    const auto channel = [&] { return static_cast<std::uint8_t>(random.below(256)); };
    const auto colour = [&] { return Colour{channel(), channel(), channel(), 255}; };
    const auto kind = [&] {
        // Not in one expression: of that, clang 14 gives the colour of the next lamp in WebAssembly
        LampKind made;
        made.colour = colour();
        made.strength = random.between(0.1, 4.0);
        made.radius = {random.between(20000, 6 * 65536)};
        return made;
    };
    for (int i = 0; i < 4; ++i) world.lampKinds.push_back(kind());
    for (Map& map : world.maps) {
        map.baked.on = true;
        map.baked.sun = colour();
        map.baked.azimuth = random.between(-360.0, 360.0);
        map.baked.altitude = random.between(1.0, 90.0);
        map.baked.ambient = colour();
        for (int i = 0; i < 6; ++i) {
            map.baked.lamps.push_back({{random.between(0, map.width * 65536 - 1)},
                                       {random.between(0, map.depth * 65536 - 1)},
                                       {random.between(0, map.levels * 65536)},
                                       kind()});
        }
    }
    for (CellBlueprint& block : world.blueprints) {
        if (!block.isStill() || block.isWater || block.mover >= 0 || !random.oneIn(6)) continue;
        block.faces[static_cast<std::size_t>(random.below(kFaces))].lamp =
            static_cast<LampId>(random.below(4));
    }
}

void addSkyAndRipples(Random& random, World& world) {
    const auto channel = [&] { return static_cast<std::uint8_t>(random.below(256)); };
    const auto colour = [&] { return Colour{channel(), channel(), channel(), 255}; };
    const auto disc = [&] {
        return SkyDisc{.size = random.between(0.5, kMaxDiscSize),
                       .azimuth = random.between(-360.0, 360.0),
                       .altitude = random.between(0.0, 40.0),
                       .glow = random.between(0.0, kMaxGlow),
                       .colour = colour()};
    };
    for (Map& map : world.maps) {
        map.sky.stars = {.density = random.unit(),
                         .seed = static_cast<std::uint32_t>(random.between(0, 1 << 30)),
                         .brightness = random.unit(),
                         .colour = colour()};
        map.sky.sun = disc();
        map.sky.moon = disc();
        // One after the other: compilers differ in the order of arguments
        const auto seed = static_cast<std::uint32_t>(random.between(0, 1 << 30));
        const double size = random.between(kMinCloudSize, 2.0);
        map.sky.clouds = {.shape = makeCloudCover(seed, size),
                          .cover = random.unit(),
                          .speed = random.between(-kMaxCloudSpeed, kMaxCloudSpeed),
                          .opacity = random.unit(),
                          .colour = colour(),
                          .shade = colour()};
        map.floor.ripples = channel();
    }
    for (CellBlueprint& block : world.blueprints)
        block.faces[static_cast<std::size_t>(Face::top)].ripples = channel();
}

void addFeatures(Random& random, World& world, bool withRamps) {
    addSeeThrough(random, world);
    addMirrors(random, world);
    addPortals(random, world);
    addObjects(random, world);
    addMovers(random, world);
    addSliders(random, world);
    if (withRamps) addRamps(random, world);
    if (!makeMovers(world).empty() || !makeGates(world).empty()) std::abort();
    markPortals(world);
    addWater(random, world);
    markSeeThrough(world);
    startObjects(world);
}

}  // namespace slicecast

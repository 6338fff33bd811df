// The world that a sound scene becomes.
#include "scene/description.h"
#include "scene/scene.h"
#include "scene/scene_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

namespace slicecast {
namespace {

World load(const std::string& text) {
    LoadedScene loaded = loadText(text);
    EXPECT_EQ(inWords(loaded.faults), "");
    return std::move(loaded.world).value_or(World{});
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(ParseScene, NamesTheFilesThatItNeeds) {
    const ParsedScene parsed =
        parseScene(readText(sceneTestFolder() / "everything.json"), "everything.json");
    EXPECT_EQ(inWords(parsed.faults), "");
    ASSERT_NE(parsed.description, nullptr);
    EXPECT_EQ(parsed.files,
              (std::vector<std::string>{"broken/images/brick.png", "broken/images/tile.png",
                                        "broken/images/sheet.png", "broken/images/sky.png"}));
}

TEST(ParseScene, ReadsEveryKey) {
    const LoadedScene loaded = loadFrom(sceneTestFolder() / "everything.json");
    EXPECT_EQ(inWords(loaded.faults), "");
    ASSERT_TRUE(loaded.world.has_value());
    const World& world = *loaded.world;
    EXPECT_EQ(world.title, "Everything \xe2\x80\x94 ein W\xc3\xbcrfel");

    // Two names of one file are one texture.
    ASSERT_EQ(world.textures.size(), 10u);  // with the two further frames of the door
    EXPECT_EQ(world.textures[0].size(), 8);
    EXPECT_EQ(world.textures[0].levels.size(), 4u);
    EXPECT_EQ(world.textures[1].size(), 16);
    EXPECT_EQ(world.textures[1].name, "tile");
    const TextureId brick = 0;
    const TextureId tile = 1;
    const TextureId flame = 2;
    EXPECT_EQ(world.textures[flame].size(), 8);
    EXPECT_EQ(world.textures[flame].frames(), 3);
    EXPECT_EQ(world.textures[flame].rate, 7.5);
    EXPECT_TRUE(world.textures[flame].seeThrough);
    EXPECT_FALSE(world.textures[tile].seeThrough);
    const Texture& red = world.textures[4];
    EXPECT_EQ(red.name, "red");
    EXPECT_EQ(red.size(), 64);
    EXPECT_FALSE(red.seeThrough);
    for (const TextureLevel& level : red.levels)
        for (const Pixel texel : level.texels)
            EXPECT_EQ(toColour(texel), (Colour{0xc0, 0x30, 0x20, 255}));

    // Their materials, by key, by name, or stone. Another material makes another texture.
    const std::vector<Material> materials = {
        Material::stone, Material::stone, Material::stone, Material::wood, Material::stone,
        Material::metal, Material::grass, Material::stone, Material::wood, Material::wood};
    for (std::size_t i = 0; i < materials.size(); ++i)
        EXPECT_EQ(world.textures[i].material, materials[i]) << world.textures[i].name;

    ASSERT_GE(world.blueprints.size(), 9u);
    const BlueprintId wall = 1;
    const BlueprintId slab = 2;
    const BlueprintId brazier = 3;
    EXPECT_FALSE(world.blueprints[brazier].join);
    EXPECT_TRUE(world.blueprints[brazier].seeThrough);
    EXPECT_TRUE(world.blueprints[slab].join);
    EXPECT_FALSE(world.blueprints[slab].seeThrough);
    for (const FaceBlueprint& face : world.blueprints[brazier].faces) {
        EXPECT_EQ(face.texture, flame);
        EXPECT_EQ(face.light, 0.9);
        EXPECT_TRUE(face.glow);
    }
    EXPECT_EQ(world.blueprints[wall].name, "wall");
    EXPECT_EQ(world.blueprints[wall].bottom.raw, 0);
    EXPECT_EQ(world.blueprints[wall].top.raw, 65536);
    for (const FaceBlueprint& face : world.blueprints[wall].faces) {
        EXPECT_EQ(face.texture, brick);
        EXPECT_EQ(face.light, 1.0);
        EXPECT_FALSE(face.glow);
    }
    EXPECT_EQ(world.blueprints[slab].bottom.raw, 16384);
    EXPECT_EQ(world.blueprints[slab].top.raw, 49152);
    const TextureId textures[kFaces] = {tile, tile, brick, brick, brick, tile};
    const double lights[kFaces] = {0.5, 1, 1, 1, 1, 0};
    for (int face = 0; face < kFaces; ++face) {
        const bool isRoof = face == static_cast<int>(Face::top);
        EXPECT_EQ(world.blueprints[slab].faces[face].mirror, isRoof ? 128 : 0) << kFaceNames[face];
        EXPECT_EQ(world.blueprints[brazier].faces[face].mirror, isRoof ? 255 : 0)
            << kFaceNames[face];
        EXPECT_EQ(world.blueprints[slab].faces[face].texture, textures[face]) << kFaceNames[face];
        EXPECT_EQ(world.blueprints[slab].faces[face].light, lights[face]) << kFaceNames[face];
    }

    ASSERT_EQ(world.maps.size(), 7u);
    const Map& hall = world.maps[0];
    EXPECT_EQ(hall.name, "hall");
    EXPECT_EQ(hall.width, 5);
    EXPECT_EQ(hall.depth, 4);
    EXPECT_EQ(hall.levels, 3);
    EXPECT_EQ(hall.cell(0, 0, 0), wall);  // '+'
    EXPECT_EQ(hall.cell(1, 1, 0), kEmptyCell);
    EXPECT_EQ(hall.cell(2, 1, 0), kEmptyCell);
    EXPECT_EQ(hall.cell(3, 1, 0), slab);  // '#' means something else in this map
    EXPECT_EQ(hall.cell(3, 2, 0), slab);  // of the scene's legend
    EXPECT_EQ(hall.cell(2, 3, 0), wall);  // beyond 16 bits
    EXPECT_EQ(hall.cell(0, 0, 1), kEmptyCell);
    EXPECT_EQ(hall.cell(2, 1, 2), slab);
    EXPECT_EQ(hall.occupied[hall.tileIndex(0, 0)], 1u);
    EXPECT_EQ(hall.occupied[hall.tileIndex(2, 1)], 4u);
    EXPECT_EQ(std::count_if(hall.cells.begin(), hall.cells.end(),
                            [](BlueprintId id) { return id != kEmptyCell; }),
              17);

    EXPECT_EQ(hall.floor.texture, brick);
    EXPECT_EQ(hall.floor.light, 0.5);
    EXPECT_TRUE(hall.floor.glow);
    EXPECT_EQ(hall.floor.mirror, 77);  // 76.5
    EXPECT_EQ(hall.floor.ripples, 255);
    EXPECT_EQ(world.blueprints[slab].face(Face::top).ripples, 51);
    EXPECT_TRUE(hall.ceiling.glow);
    EXPECT_EQ(hall.floor.tiles,
              (std::vector<TextureId>{0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}));
    EXPECT_EQ(hall.ceiling.height.raw, 98304);
    EXPECT_EQ(hall.ceiling.light, 0.25);
    EXPECT_EQ(hall.ceiling.tiles[0], kNoTexture);
    EXPECT_EQ(hall.ceiling.tiles[4], tile);
    EXPECT_EQ(hall.ceiling.tiles[9], brick);
    ASSERT_EQ(world.sprites.size(), 2u);
    EXPECT_EQ(world.sprites[0].frames.size(), 1u);
    EXPECT_EQ(world.sprites[1].frames.size(), 3u);
    EXPECT_EQ(world.sprites[1].rate, 4.0);
    ASSERT_GT(hall.objects.size(), 7u);
    const Object& bush = hall.objects[0];
    EXPECT_EQ(bush.sprite, 0);
    EXPECT_EQ(bush.x.raw, 98304);
    EXPECT_EQ(bush.y.raw, 163840);
    EXPECT_EQ(bush.z.raw, 0);
    EXPECT_EQ(bush.height.raw, 49152);
    EXPECT_EQ(bush.width.raw, 49152);  // the sprite is square
    EXPECT_EQ(bush.light, 1.0);
    EXPECT_FALSE(bush.glow);
    ASSERT_NE(bush.lamp, kNoLamp);
    EXPECT_EQ(world.lampKinds[bush.lamp], LampKind{});
    const Object& bird = hall.objects[1];
    EXPECT_EQ(bird.lamp, kNoLamp);
    EXPECT_EQ(bird.sprite, 1);
    EXPECT_EQ(bird.z.raw, 81920);
    EXPECT_EQ(bird.width.raw, 32768);
    EXPECT_EQ(bird.height.raw, 16384);
    EXPECT_EQ(bird.light, 0.5);
    EXPECT_TRUE(bird.glow);

    // First the three moving objects of the map and two of the dock, then the sown bushes and
    // birds.
    const std::vector<ObjectMotion>& motions = world.movingObjects.motions;
    ASSERT_EQ(motions.size(), hall.objects.size() - 4 + 2);
    EXPECT_EQ(motions[0].kind, ObjectMotion::Kind::pace);
    EXPECT_EQ(motions[0].map, 0);
    EXPECT_EQ(motions[0].object, 2);
    EXPECT_EQ(motions[0].speed, 0.5);
    EXPECT_EQ(motions[0].headingDegrees, 0.0) << "once round";
    EXPECT_EQ(motions[0].reach.raw, 65536);
    EXPECT_EQ(motions[1].kind, ObjectMotion::Kind::wander);
    EXPECT_EQ(motions[1].object, 3);
    EXPECT_EQ(motions[1].headingDegrees, 0.0);
    EXPECT_EQ(motions[1].reach.raw, 0);
    EXPECT_EQ(motions[2].kind, ObjectMotion::Kind::circle);
    EXPECT_EQ(motions[2].homeX.raw, 131072);
    EXPECT_EQ(hall.objects[4].y.raw, 65536) << "on its circle";
    for (const std::size_t i : {5u, 6u}) {
        const Object& sown = hall.objects[i];
        EXPECT_EQ(sown.sprite, 0);
        EXPECT_EQ(sown.x.tile(), static_cast<int>(i) - 4);
        EXPECT_EQ(sown.y.tile(), 1);
        EXPECT_EQ(sown.z.raw, 0);
        EXPECT_GE(sown.height.raw, 16384);
        EXPECT_LE(sown.height.raw, 32768);
        EXPECT_EQ(sown.width.raw, 32768);
        EXPECT_EQ(sown.light, 0.5);
        EXPECT_TRUE(sown.glow);
    }
    bool onFloor = false;
    bool onWall = false;
    for (std::size_t i = 7; i < hall.objects.size(); ++i) {
        const Object& sown = hall.objects[i];
        EXPECT_EQ(sown.sprite, 1);
        EXPECT_EQ(sown.height.raw, 16384);
        EXPECT_EQ(sown.width.raw, 16384) << "from its square picture";
        EXPECT_FALSE(sown.glow);
        onFloor = onFloor || (sown.z.raw >= 16384 && sown.z.raw <= 32768);
        onWall = onWall || (sown.z.raw >= 65536 + 16384 && sown.z.raw <= 65536 + 32768);
        EXPECT_EQ(motions[i - 2].object, static_cast<int>(i));
        EXPECT_EQ(motions[i - 2].headingDegrees, 90.0);
        EXPECT_EQ(motions[i - 2].reach.raw, 131072);
    }
    EXPECT_TRUE(onFloor);
    EXPECT_TRUE(onWall);
    EXPECT_EQ(hall.sky.kind, Sky::Kind::gradient);
    EXPECT_EQ(hall.sky.low, (Colour{255, 128, 0, 255}));
    EXPECT_EQ(hall.sky.high, (Colour{16, 32, 64, 255}));
    EXPECT_EQ(hall.sky.slope, 2.0);
    EXPECT_EQ(
        hall.sky.stars,
        (SkyStars{.density = 0.1, .seed = 7, .brightness = 0.5, .colour = {240, 240, 255, 255}}));
    EXPECT_EQ(hall.sky.sun, (SkyDisc{.size = 6.0,
                                     .azimuth = 180.0,
                                     .altitude = 5.0,
                                     .glow = 50.0,
                                     .colour = {255, 208, 128, 255}}));
    EXPECT_EQ(hall.sky.moon, (SkyDisc{.size = 3.0,
                                      .azimuth = -90.0,
                                      .altitude = 40.0,
                                      .glow = 0.0,
                                      .colour = {208, 216, 224, 255}}));
    ASSERT_NE(hall.sky.clouds.shape, nullptr);
    EXPECT_EQ(hall.sky.clouds.shape->density, makeCloudCover(9, 2.0)->density);
    EXPECT_EQ(hall.sky.clouds.cover, 0.6);
    EXPECT_EQ(hall.sky.clouds.speed, -2.0);
    EXPECT_EQ(hall.sky.clouds.opacity, 0.8);
    EXPECT_EQ(hall.sky.clouds.colour, (Colour{240, 160, 128, 255}));
    EXPECT_EQ(hall.sky.clouds.shade, (Colour{112, 64, 96, 255}));
    EXPECT_FALSE(hall.light.on);
    EXPECT_EQ(hall.light.intensity, 2.0);
    EXPECT_EQ(hall.light.multiplier, 3.0);
    EXPECT_EQ(hall.light.darkest, 0.2);
    EXPECT_EQ(hall.light.brightest, 0.9);
    EXPECT_TRUE(hall.baked.on);
    EXPECT_EQ(hall.baked.sun, (Colour{255, 128, 64, 255}));
    EXPECT_EQ(hall.baked.azimuth, -45.0);
    EXPECT_EQ(hall.baked.altitude, 12.5);
    EXPECT_EQ(hall.baked.ambient, (Colour{32, 48, 64, 255}));
    ASSERT_EQ(hall.baked.lamps.size(), 2u);
    EXPECT_EQ(hall.baked.lamps[0],
              (Lamp{toCoordinate(1.5),
                    toCoordinate(1.5),
                    toCoordinate(2.25),
                    {.colour = {255, 255, 192, 255}, .strength = 2.0, .radius = tileEdge(6)}}));
    EXPECT_EQ(hall.baked.lamps[1].kind, LampKind{});
    EXPECT_TRUE(hall.fog.on);
    EXPECT_EQ(hall.fog.start, 1.0);
    EXPECT_EQ(hall.fog.end, 4.5);
    EXPECT_EQ(hall.haze, (Colour{160, 176, 192, 255}));
    EXPECT_EQ(hall.far, 500.0);

    const Map& yard = world.maps[1];
    EXPECT_EQ(yard.cell(0, 0, 0), wall);
    EXPECT_EQ(yard.cell(0, 1, 0), slab);
    EXPECT_EQ(yard.sky.kind, Sky::Kind::panorama);
    EXPECT_EQ(yard.sky.panorama.width, 24);
    EXPECT_EQ(yard.sky.panorama.height, 6);
    EXPECT_TRUE(yard.ceiling.tiles.empty());
    EXPECT_EQ(world.maps[3].sky.kind, Sky::Kind::colour);
    EXPECT_EQ(world.maps[3].sky.low, (Colour{18, 52, 86, 255}));
    EXPECT_FALSE(yard.sky.hasLayers() || world.maps[3].sky.hasLayers());

    EXPECT_EQ(world.portalLimit, 5);
    const int plainMap = 3;
    const int galleryMap = 4;
    const Map& gallery = world.maps[galleryMap];
    const auto faceOf = [&](int x, int y, Face face) {
        return world.blueprints[gallery.cell(x, y, 0)].face(face).portal;
    };
    ASSERT_EQ(world.portals.size(), 5u);
    const PortalId door = faceOf(0, 1, Face::east);
    EXPECT_EQ(world.portals[door], (Portal{.fromMap = galleryMap,
                                           .fromX = 0,
                                           .fromY = 1,
                                           .toMap = plainMap,
                                           .toX = 0,
                                           .toY = 0,
                                           .turn = 3,
                                           .levels = 0}));
    EXPECT_EQ(faceOf(0, 1, Face::west), kNoPortal);
    EXPECT_EQ(faceOf(0, 0, Face::east), kNoPortal);
    EXPECT_TRUE(world.blueprints[gallery.cell(0, 1, 0)].hasPortals);
    EXPECT_FALSE(world.blueprints[gallery.cell(0, 0, 0)].hasPortals);
    // Walking south into the pillar leads out of the east wall, going west.
    EXPECT_EQ(world.portals[faceOf(2, 2, Face::north)], (Portal{.fromMap = galleryMap,
                                                                .fromX = 2,
                                                                .fromY = 2,
                                                                .toMap = galleryMap,
                                                                .toX = 3,
                                                                .toY = 1,
                                                                .turn = 1,
                                                                .levels = 0}));
    EXPECT_EQ(world.portals[faceOf(4, 1, Face::west)], (Portal{.fromMap = galleryMap,
                                                               .fromX = 4,
                                                               .fromY = 1,
                                                               .toMap = galleryMap,
                                                               .toX = 2,
                                                               .toY = 1,
                                                               .turn = 3,
                                                               .levels = 0}));
    ASSERT_NE(gallery.tilePortal(1, 2), kNoPortal);
    ASSERT_NE(gallery.tilePortal(3, 2), kNoPortal);
    const Portal lift = {.fromMap = galleryMap,
                         .fromX = 1,
                         .fromY = 2,
                         .toMap = galleryMap,
                         .toX = 3,
                         .toY = 2,
                         .turn = 2,
                         .levels = 1};
    EXPECT_EQ(world.portals[gallery.tilePortal(1, 2)], lift);
    EXPECT_EQ(world.portals[gallery.tilePortal(3, 2)], reversed(lift));

    EXPECT_EQ(world.start.map, 0);
    EXPECT_EQ(world.start.x.raw, 98304);
    EXPECT_EQ(world.start.y.raw, 147456);
    EXPECT_EQ(world.start.z.raw, 8192);
    EXPECT_EQ(world.start.headingDegrees, -90.0);
    EXPECT_EQ(world.start.look, 0.5);
}

TEST(ParseScene, ReadsPlansAndHalves) {
    const LoadedScene loaded = loadFrom(sceneTestFolder() / "everything.json");
    ASSERT_TRUE(loaded.world.has_value());
    const World& world = *loaded.world;
    EXPECT_TRUE(world.hasPlans);
    const auto named = [&](const char* name) -> const CellBlueprint& {
        return *std::find_if(world.blueprints.begin(), world.blueprints.end(),
                             [&](const CellBlueprint& block) { return block.name == name; });
    };
    EXPECT_TRUE(named("wall").plan.isWhole());
    EXPECT_EQ(named("pane").plan.north, toCoordinate(0.25));
    EXPECT_EQ(named("pane").plan.half, Half::none);
    const CellBlueprint& corner = named("corner");
    EXPECT_EQ(corner.plan.half, Half::southWest);
    EXPECT_EQ(corner.face(Face::north).light, 0.5) << "the cut's";
    EXPECT_EQ(corner.face(Face::south).light, 1.0);
    EXPECT_NE(corner.face(Face::east).texture, kNoTexture) << "there is no such side";
}

TEST(ParseScene, ReadsWater) {
    const LoadedScene loaded = loadFrom(sceneTestFolder() / "everything.json");
    ASSERT_TRUE(loaded.world.has_value());
    const World& world = *loaded.world;
    const auto named = [&](const char* name) -> const CellBlueprint& {
        return *std::find_if(world.blueprints.begin(), world.blueprints.end(),
                             [&](const CellBlueprint& block) { return block.name == name; });
    };
    EXPECT_FALSE(named("wall").isWater);
    const CellBlueprint& pond = named("pond");
    EXPECT_TRUE(pond.isWater);
    EXPECT_TRUE(pond.seeThrough);
    EXPECT_EQ(pond.waterColour, (Colour{0x1a, 0x3c, 0x40, 255}));
    EXPECT_EQ(pond.waterSight, 3.5);
    EXPECT_NE(pond.face(Face::top).texture, kNoTexture);
    EXPECT_EQ(pond.face(Face::north).texture, kNoTexture);
    EXPECT_TRUE(named("rain").isWater);
    EXPECT_EQ(named("rain").waterColour, kWaterColour);
    EXPECT_EQ(named("rain").waterSight, kWaterSight);
    EXPECT_EQ(world.maps[0].floor.water, kNoTexture);
    EXPECT_TRUE(world.maps[3].isWaterFloor(0));
    EXPECT_FALSE(world.maps[0].objects[0].floats);
    EXPECT_TRUE(world.maps[0].objects[1].floats);
}

TEST(ParseScene, ReadsMotionsAndGates) {
    const LoadedScene loaded = loadFrom(sceneTestFolder() / "everything.json");
    ASSERT_TRUE(loaded.world.has_value());
    const World& world = *loaded.world;
    ASSERT_EQ(world.motions.size(), 5u);
    const Motion& lift = world.motions[0];
    EXPECT_EQ(lift.name, "slow lift");
    EXPECT_EQ(lift.edges, MovingEdges::both);
    EXPECT_EQ(lift.from, toCoordinate(-0.25));
    EXPECT_EQ(lift.to, toCoordinate(2.5));
    EXPECT_EQ(lift.periodSteps, 12 * 120);
    EXPECT_EQ(lift.phaseSteps, 3 * 120);
    EXPECT_EQ(lift.shape, MotionShape::stopAndGo);
    EXPECT_EQ(world.motions[1].edges, MovingEdges::high);
    EXPECT_EQ(world.motions[1].from, Coordinate{});
    EXPECT_EQ(world.motions[1].phaseSteps, 0);
    EXPECT_EQ(world.motions[1].shape, MotionShape::smooth);
    EXPECT_EQ(world.motions[2].edges, MovingEdges::low);
    EXPECT_EQ(world.motions[2].from, toCoordinate(0.5));
    EXPECT_EQ(world.motions[2].shape, MotionShape::even);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(world.motions[i].axis, Axis::z);
        EXPECT_FALSE(world.motions[i].once);
    }
    EXPECT_EQ(world.motions[3].axis, Axis::y);
    EXPECT_EQ(world.motions[3].edges, MovingEdges::low);
    EXPECT_TRUE(world.motions[3].once);
    EXPECT_EQ(world.motions[4].axis, Axis::x);
    EXPECT_EQ(world.motions[4].periodSteps, 0);

    const int works = 2;
    ASSERT_EQ(world.movers.size(), 6u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(world.movers[i].map, works);
    const auto motionAt = [&](int x, int y) {
        return world.blueprints[world.maps[works].cells[world.maps[works].cellIndex(x, y, 0)]]
            .motion;
    };
    EXPECT_EQ(motionAt(0, 0), 0);
    EXPECT_EQ(motionAt(1, 0), 0);
    EXPECT_EQ(motionAt(0, 2), 1);
    EXPECT_EQ(motionAt(1, 2), 2);
    EXPECT_EQ(world.blueprints[world.maps[works].cell(0, 0, 1)].top,
              toCoordinate(0.625));  // half way up

    ASSERT_EQ(world.gateKinds.size(), 4u);
    const GateKind& gate = world.gateKinds[0];
    EXPECT_EQ(gate.steps, 180);
    EXPECT_EQ(gate.reach, toCoordinate(2.5));
    EXPECT_TRUE(gate.keyed);
    EXPECT_TRUE(gate.opensOnApproach);
    EXPECT_EQ(gate.approach, toCoordinate(1.25));
    EXPECT_EQ(gate.holdSteps, 240);
    EXPECT_TRUE(gate.startsOpen);
    const GateKind& door = world.gateKinds[1];
    EXPECT_EQ(door.steps, 96);
    EXPECT_EQ(door.reach, toCoordinate(2.0));
    EXPECT_TRUE(door.keyed);
    EXPECT_FALSE(door.opensOnApproach);
    EXPECT_EQ(door.holdSteps, 120);
    EXPECT_FALSE(door.startsOpen);
    const GateKind& slider = world.gateKinds[2];
    EXPECT_EQ(slider.steps, 240);
    EXPECT_FALSE(slider.keyed);
    EXPECT_EQ(slider.everySteps, 2400);
    EXPECT_EQ(slider.holdSteps, 360);
    EXPECT_TRUE(slider.once);
    EXPECT_EQ(slider.follows, (std::vector<int>{1, 0}));
    EXPECT_TRUE(world.gateKinds[3].keyed);
    EXPECT_EQ(world.gateKinds[3].follows, std::vector<int>{2});
    ASSERT_EQ(world.gates.size(), 6u);
    for (std::size_t i = 3; i < 6; ++i) {
        const Mover& mover = world.movers[i];
        EXPECT_EQ(mover.map, 5);
        EXPECT_EQ(mover.gate < 0, i == 3);
        if (mover.gate < 0) continue;
        EXPECT_EQ(world.gates[static_cast<std::size_t>(mover.gate)].mover, static_cast<int>(i));
    }
    const CellBlueprint& open = world.blueprints[world.maps[works].cell(1, 1, 0)];
    const CellBlueprint& shut = world.blueprints[world.maps[works].cell(2, 1, 0)];
    EXPECT_TRUE(open.passable);
    EXPECT_FALSE(shut.passable);
    // The held sheet at its first frame, and on an open gate at its last; the rest of the gate is
    // as it says.
    EXPECT_TRUE(open.seeThrough);
    EXPECT_EQ(shut.face(Face::north).texture, 3);
    EXPECT_EQ(shut.face(Face::east).texture, 3);
    EXPECT_EQ(open.face(Face::north).texture, 9);
    EXPECT_EQ(open.face(Face::east).texture, 1);
    EXPECT_EQ(world.textures[9].size(), world.textures[3].size());
}

TEST(ParseScene, UsesDefaultsForMissingKeys) {
    const World world = load(smallScene());
    const Map& map = world.maps[0];
    const Map normal;
    EXPECT_EQ(map.light.on, normal.light.on);
    EXPECT_EQ(map.light.intensity, normal.light.intensity);
    EXPECT_EQ(map.light.multiplier, normal.light.multiplier);
    EXPECT_EQ(map.fog.on, false);
    EXPECT_EQ(map.haze, normal.haze);
    EXPECT_EQ(map.far, kDefaultFar);
    EXPECT_EQ(map.sky.kind, Sky::Kind::colour);
    EXPECT_EQ(world.start.map, 0);
    EXPECT_EQ(world.start.z.raw, 0);
    EXPECT_EQ(world.start.headingDegrees, 0.0);
}

TEST(ParseScene, RoundsOnlyCoordinates) {
    const World world =
        load(replaced(smallScene(), R"("x": 1.5, "y": 1.5)",
                      R"("x": 1.4000076, "y": 1.59999, "heading": 0.1, "look": 0.3)"));
    EXPECT_EQ(world.start.x.raw, 91751);   // 65536 * 1.4000076 = 91750.898...
    EXPECT_EQ(world.start.y.raw, 104857);  // 65536 * 1.59999 = 104856.9...
    EXPECT_EQ(world.start.headingDegrees, 0.1);
    EXPECT_EQ(world.start.look, 0.3);
}

TEST(ParseScene, ReadsNumbersWithCorrectRounding) {
    // Halfway cases and long digits that quick parsers get wrong.
    for (const auto& [text, value] :
         {std::pair{"0.1000000000000000055511151231257827021181583404541015625", 0.1},
          std::pair{"0.41866852935895693", 0.41866852935895693},
          std::pair{"0.99892030650086816", 0.99892030650086816},
          std::pair{"0.30000000000000004", 0.30000000000000004},
          std::pair{"123456789012345678e-18", 0.123456789012345678}}) {
        const World world = load(
            replaced(smallScene(), R"("y": 1.5)", R"("y": 1.5, "look": )" + std::string(text)));
        EXPECT_EQ(world.start.look, value) << text;
    }
}

TEST(ParseScene, TakesEveryKindOfLineEnd) {
    const std::string plain = smallScene("[[\"###\",\n\"#Q#\",\n\"###\"]]");
    std::string windows = "\xef\xbb\xbf";
    std::string oldMac;
    for (const char c : plain) {
        if (c == '\n') windows += '\r';
        windows += c;
        oldMac += c == '\n' ? '\r' : c;
    }
    const std::vector<Fault> faults = parseScene(plain, "test.json").faults;
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].row, 1);
    EXPECT_EQ(faults[0].character, 1);
    EXPECT_EQ(faults[0].column, 3);
    EXPECT_EQ(parseScene(windows, "test.json").faults, faults);
    EXPECT_EQ(parseScene(oldMac, "test.json").faults, faults);
}

TEST(ParseScene, PlacesFaultsAfterEscapes) {
    const std::vector<Fault> faults =
        parseScene(smallScene("[[\"###\", \"\\u0023\\ud83e\\uddf1#\", \"###\"]]"), "test.json")
            .faults;
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].found, "'\xf0\x9f\xa7\xb1'");
    EXPECT_EQ(faults[0].row, 1);
    EXPECT_EQ(faults[0].character, 1);
    // The pair is one character: Q is the third.
    const std::vector<Fault> third =
        parseScene(smallScene("[[\"###\", \"\\u0023\\ud83e\\uddf1Q\", \"###\"]]"), "test.json")
            .faults;
    ASSERT_EQ(third.size(), 2u);
    EXPECT_EQ(third[1].character, 2);
    EXPECT_EQ(third[0].column + 12, third[1].column);
    const std::vector<Fault> behind =
        parseScene(smallScene("[[\"###\", \"\\u0023\\\"Q\", \"###\"]]"), "test.json").faults;
    ASSERT_EQ(behind.size(), 2u);
    EXPECT_EQ(behind[0].column + 2, behind[1].column);
    EXPECT_EQ(behind[1].character, 2);
}

// Signs of several characters count as one tile; the column counts characters.
TEST(ParseScene, TakesSignsOfSeveralCharacters) {
    const std::vector<Fault> faults =
        parseScene(smallScene("[[\"###\", \"#\u2764\ufe0f#\", \"###\"]]"), "test.json").faults;
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].found, "'\u2764\ufe0f' (U+2764 U+FE0F)");
    EXPECT_EQ(faults[0].character, 1);
    const std::vector<Fault> behind =
        parseScene(smallScene("[[\"###\", \"\u2764\ufe0f\U0001f1e9\U0001f1eaQ\", \"###\"]]"),
                   "test.json")
            .faults;
    ASSERT_EQ(behind.size(), 3u);
    EXPECT_EQ(behind[2].found, "'Q'");
    EXPECT_EQ(behind[2].character, 2);
    EXPECT_EQ(behind[2].column, behind[0].column + 4);
}

TEST(ParseScene, NeedsNoBlueprints) {
    const World world =
        load(R"({ "title": "Plain", "textures": { "grass": "broken/images/brick.png" },
        "maps": [{ "name": "plain", "levels": [["...", "...", "..."]], "floor": "grass" }],
        "start": { "x": 1, "y": 1 } })");
    EXPECT_EQ(world.maps[0].width, 3);
}

TEST(ParseScene, AGateThatHoldsForNoTimeStaysOpenForOneStep) {
    const World world =
        load(replaced(smallScene(), R"("blueprints": { "wall": { "faces": "brick" } })",
                      R"("motions": { "down": { "moves": "top", "to": -0.5 } },
                    "blueprints": { "wall": { "faces": "brick", "motion": "down",
                        "gate": { "keyed": false, "every": 1, "hold": 0 } } })"));
    ASSERT_EQ(world.gateKinds.size(), 1u);
    EXPECT_EQ(world.gateKinds[0].holdSteps, 1);
}

TEST(ParseScene, StartsCrouchedWhereThereIsNoRoomToStand) {
    const std::string low = R"("ceiling": { "height": 0.5, "texture": "brick" })";
    EXPECT_EQ(
        inWords(parseScene(smallScene(R"([["###", "#.#", "###"]])", low), "test.json").faults), "");
}

TEST(LoadScene, PassesOnTheFaultsOfTheText) {
    for (const auto& [text, count] : {std::pair{"{}", 3u}, {"{", 1u}, {"[]", 1u}}) {
        ParsedScene parsed = parseScene(text, "test.json");
        const std::vector<Fault> faults = parsed.faults;
        const LoadedScene loaded = loadScene(std::move(parsed), {});
        EXPECT_FALSE(loaded.world.has_value());
        EXPECT_EQ(loaded.faults, faults);
        EXPECT_EQ(loaded.faults.size(), count);
    }
}

// A page brings the table only for scenes that need it.
TEST(ParseScene, AsksForTheTableOfShippedPictures) {
    const auto withoutTable = [](const std::string& text) {
        SceneParser parser(text, "test.json");
        while (parser.next()) {
        }
        return parser.take();
    };
    std::string text = smallScene();
    EXPECT_FALSE(withoutTable(text).needsPictures);
    EXPECT_EQ(withoutTable(text).files.size(), 1u);
    const std::string declared = R"("textures": { "brick": "broken/images/brick.png" },)";
    text.replace(text.find(declared), declared.size(), "");
    EXPECT_TRUE(withoutTable(text).needsPictures);
    EXPECT_TRUE(withoutTable(text).faults.empty());
    EXPECT_EQ(withoutTable(text).description, nullptr);
    const ParsedScene parsed =
        parseScene(text, "test.json", {}, R"({ "textures": { "brick": "textures/brick.png" } })");
    EXPECT_EQ(parsed.files, (std::vector<std::string>{"slicecast:textures/brick.png"}));
    EXPECT_EQ(parseScene(text, "test.json").faults.size(), 2u) << "nobody has the table";
}

// No scene names a file as the shipped ones are named for hosts.
TEST(ParseScene, TakesNoNamesOfShippedFiles) {
    std::string text = smallScene();
    const std::string name = "broken/images/brick.png";
    text.replace(text.find(name), name.size(), "slicecast:../secret.png");
    EXPECT_EQ(parseScene(text, "test.json").faults.size(), 1u);
}

// Whoever mends a scene sees all of its faults at once. A picture whose own text has a fault is not
// looked at.
TEST(LoadScene, ListsFaultsOfTextAndPicturesTogether) {
    ParsedScene parsed = parseScene(R"({ "title": "Two kinds",
  "textures": {
    "missing": "away.png",
    "odd": { "file": "odd.png", "frames": 1 },
    "named": "no-picture.jpg",
    "flat": "broken.png" },
  "blueprints": { "wall": { "faces": "brick" } },
  "maps": [{ "name": "room", "levels": [["..."]], "floor": "flat",
    "portals": [{ "x": 0, "y": 0, "to": { "map": "cellar", "x": 0, "y": 0 } }] }],
  "start": { "x": 1.5, "y": 0.5 } })",
                                    "test.json");
    EXPECT_EQ(parsed.files, (std::vector<std::string>{"away.png", "broken.png"}));
    const std::size_t ofText = parsed.faults.size();
    const LoadedScene loaded = loadScene(std::move(parsed), {{"broken.png", {1, 2, 3}}});
    EXPECT_FALSE(loaded.world.has_value());
    EXPECT_EQ(ofText, 4u);
    std::vector<std::string> pointers;
    for (const Fault& fault : loaded.faults) pointers.push_back(fault.pointer);
    EXPECT_EQ(pointers,
              (std::vector<std::string>{"/textures/missing", "/textures/odd/frames",
                                        "/textures/named", "/textures/flat",
                                        "/blueprints/wall/faces", "/maps/0/portals/0/to/map"}));
}

// A world of a large map has hundreds of megabytes.
TEST(LoadScene, DoesNotCopyTheWorld) {
    ParsedScene parsed = parseScene(smallScene(), "test.json");
    const SceneFiles files = readSceneFiles(sceneTestFolder(), parsed);
    const BlueprintId* cells = parsed.description->world.maps[0].cells.data();
    LoadedScene loaded = loadScene(std::move(parsed), files);
    ASSERT_TRUE(loaded.world.has_value());
    EXPECT_EQ(loaded.world->maps[0].cells.data(), cells);
    EXPECT_EQ(parsed.description, nullptr);
}

TEST(LoadScene, TakesImagesThatWereDecodedEarly) {
    ParsedScene parsed = parseScene(smallScene(), "test.json");
    SceneFiles files = readSceneFiles(sceneTestFolder(), parsed);
    const LoadedScene expected = loadText(smallScene());
    EarlyImages early;
    for (auto& [name, bytes] : files) {
        early.decode(name, bytes);
        bytes = {1, 2, 3};  // not looked at again
    }
    const LoadedScene loaded = loadScene(std::move(parsed), files, std::move(early));
    ASSERT_TRUE(loaded.world.has_value())
        << (loaded.faults.empty() ? "" : describe(loaded.faults[0]));
    ASSERT_EQ(loaded.world->textures.size(), expected.world->textures.size());
    for (std::size_t i = 0; i < loaded.world->textures.size(); ++i) {
        EXPECT_EQ(loaded.world->textures[i].levels[0].texels,
                  expected.world->textures[i].levels[0].texels);
    }
}

TEST(LoadScene, TakesPixelsThatWereDecodedElsewhere) {
    ParsedScene parsed = parseScene(smallScene(), "test.json");
    const SceneFiles files = readSceneFiles(sceneTestFolder(), parsed);
    const LoadedScene expected = loadText(smallScene());
    EarlyImages other;
    EarlyImages early;
    for (const auto& [name, bytes] : files) {
        const std::span<const Pixel> pixels = other.decode(name, bytes);
        const std::span<Pixel> blank = early.decode(name, bytes, true);
        ASSERT_EQ(blank.size(), pixels.size());
        ASSERT_FALSE(std::equal(pixels.begin(), pixels.end(), blank.begin()));
        std::copy(pixels.begin(), pixels.end(), blank.begin());
    }
    const LoadedScene loaded = loadScene(std::move(parsed), files, std::move(early));
    ASSERT_TRUE(loaded.world.has_value());
    ASSERT_EQ(loaded.world->textures.size(), expected.world->textures.size());
    for (std::size_t i = 0; i < loaded.world->textures.size(); ++i) {
        EXPECT_EQ(loaded.world->textures[i].levels[0].texels,
                  expected.world->textures[i].levels[0].texels);
    }
    const std::vector<std::uint8_t> noPicture = {1, 2, 3};
    EXPECT_TRUE(other.decode("none.png", noPicture).empty());
    EXPECT_TRUE(other.decode("none.png", noPicture, true).empty());
}

TEST(LoadScene, TellsTheFaultsOfImagesThatWereDecodedEarly) {
    const auto parsed = [] { return parseScene(smallScene(), "test.json"); };
    const std::vector<Pixel> pixels(2048 * 2048, toPixel({1, 2, 3, 255}));
    for (const std::vector<std::uint8_t>& bytes :
         {encodePng(pixels.data(), 2048, 2048, 2048), encodePng(pixels.data(), 24, 24, 24),
          std::vector<std::uint8_t>{1}}) {
        SceneFiles files = readSceneFiles(sceneTestFolder(), parsed());
        EarlyImages early;
        for (auto& [name, content] : files) early.decode(name, content = bytes);
        const std::vector<Fault> expected = loadScene(parsed(), files).faults;
        EXPECT_FALSE(expected.empty());
        EXPECT_EQ(loadScene(parsed(), files, std::move(early)).faults, expected);
    }
}

// Each object of a scene that has every key.
TEST(ParseScene, LeavesDataAlone) {
    const std::string text = readText(sceneTestFolder() / "everything.json");
    const LoadedScene before = loadText(text);
    ASSERT_TRUE(before.world) << inWords(before.faults);
    int objects = 0;
    std::string with;
    for (std::size_t i = 0; i < text.size(); ++i) {
        with += text[i];
        // What has a comment has no other keys but its own
        if (text.compare(i, 11, "\"comment\": ") != 0 || text.compare(i, 12, "\"comment\": 7") == 0)
            continue;
        if (++objects == 1) continue;  // the scene has some
        with.insert(
            with.size() - 1,
            "\"data\": { \"x\": [1, { \"faces\": null, \"comment\": [] }], \"\": -0.5e3 }, ");
    }
    EXPECT_GT(objects, 30);
    const LoadedScene after = loadText(with);
    EXPECT_EQ(inWords(after.faults), "");
    ASSERT_TRUE(after.world);
    ASSERT_EQ(after.world->maps.size(), before.world->maps.size());
    for (std::size_t i = 0; i < before.world->maps.size(); ++i)
        EXPECT_EQ(after.world->maps[i].cells, before.world->maps[i].cells);
    EXPECT_EQ(after.warnings.size(), before.warnings.size());
}

TEST(ParseScene, CountsDataAsPartOfTheText) {
    const auto faults = [](const std::string& data) {
        return parseScene(smallScene(R"([["###", "#.#", "###"]])", "\"data\": " + data),
                          "test.json")
            .faults;
    };
    EXPECT_EQ(inWords(faults("[[[[1]]]]")), "");
    ASSERT_EQ(faults(std::string(40, '[') + std::string(40, ']')).size(), 1u);
    std::string many = "[0";
    for (int i = 0; i < 2'000'000; ++i) many += ",0";
    ASSERT_EQ(faults(many + "]").size(), 1u);
    EXPECT_EQ(faults(many + "]")[0].found, "more than 2000000 values");
}

}  // namespace
}  // namespace slicecast

// Worlds that are stepped, before the definition: where movers and gates are after so many steps
// and between them, which frames gates show, where objects are shown; and their pictures before the
// judge.
#include "draw.h"
#include "sanitized.h"
#include "verdict.h"

#include "base/random.h"
#include "world/mover.h"
#include "world/object_motion.h"
#include "world/world_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace slicecast::judge {
namespace {

constexpr int kSlot = 4;  // tiles a side; each holds one thing that moves
constexpr int kSlotsEast = 4;
constexpr int kSlotsSouth = 3;

Texture anyTexture(Random& random, int frames, double rate) {
    Image image(8 * frames, 8);
    const bool isSeeThrough = random.oneIn(2);
    for (Pixel& pixel : image.pixels) {
        const int alpha = isSeeThrough ? 60 * random.below(4) : 255;
        pixel = toPixel({static_cast<std::uint8_t>(random.below(256)),
                         static_cast<std::uint8_t>(random.below(256)),
                         static_cast<std::uint8_t>(random.below(256)),
                         static_cast<std::uint8_t>(alpha)});
    }
    return makeTexture("any", image, frames, rate);
}

Motion anyMotion(Random& random, bool ofGate) {
    Motion motion;
    motion.axis = static_cast<Axis>(random.below(3));
    motion.edges = static_cast<MovingEdges>(random.below(3));
    motion.shape = static_cast<MotionShape>(random.below(3));
    motion.from = {random.between(-60'000, 65'536)};
    motion.to = {random.between(-60'000, 65'536)};
    if (motion.edges == MovingEdges::low) {
        motion.from = {-motion.from.raw};
        motion.to = {-motion.to.raw};
    }
    motion.periodSteps = ofGate ? 0 : 2 * random.between(6, 150);
    if (ofGate) return motion;
    motion.once = random.oneIn(3);
    if (!motion.once) motion.periodSteps += random.below(2);
    motion.phaseSteps = random.oneIn(3) ? 0 : random.below(motion.periodSteps);
    return motion;
}

GateKind anyGate(Random& random, int kinds) {
    GateKind kind;
    kind.steps = random.oneIn(5) ? 1 : random.between(2, 90);
    kind.everySteps = random.oneIn(3) ? 0 : random.between(20, 200);
    kind.holdSteps = random.between(0, 60);
    kind.startsOpen = random.oneIn(4);
    kind.once = random.oneIn(4);
    if (kinds > 0 && random.oneIn(3)) kind.follows = {random.below(kinds)};
    return kind;
}

World movingWorld(Random& random) {
    World world;
    for (int i = 0; i < 6; ++i) world.textures.push_back(anyTexture(random, 1, 0.0));
    for (int i = 0; i < 2; ++i)
        world.textures.push_back(
            anyTexture(random, random.between(2, 8), 120.0 / random.between(1, 9)));
    for (int i = 0; i < 2; ++i)
        world.textures.push_back(anyTexture(random, random.between(2, 9), 0.0));
    const int textures = static_cast<int>(world.textures.size());
    Map map = makeMap("works", kSlot * kSlotsEast, kSlot * kSlotsSouth, 3, 0);
    for (int slot = 0; slot < kSlotsEast * kSlotsSouth; ++slot) {
        if (random.oneIn(6)) continue;
        CellBlueprint block;
        block.name = "thing " + std::to_string(slot);
        block.join = random.oneIn(2);
        for (FaceBlueprint& face : block.faces)
            face.texture = static_cast<TextureId>(random.below(textures));
        const bool isGate = random.oneIn(3);
        if (isGate) {
            block.gate = static_cast<int>(world.gateKinds.size());
            world.gateKinds.push_back(anyGate(random, block.gate));
        }
        if (!isGate || random.oneIn(2)) {
            block.motion = static_cast<int>(world.motions.size());
            world.motions.push_back(anyMotion(random, isGate));
        }
        world.blueprints.push_back(block);
        const auto id = static_cast<BlueprintId>(world.blueprints.size() - 1);
        const int x = slot % kSlotsEast * kSlot + 1;
        const int y = slot / kSlotsEast * kSlot + 1;
        map.setCell(x, y, 1, id);
        if (random.oneIn(2)) map.setCell(x + 1, y, 1, id);
        if (random.oneIn(3)) map.setCell(x, y + 1, 1, id);
    }
    map.sky.low = {120, 160, 200, 255};
    map.light.on = false;
    Image who(8, 8);
    for (Pixel& pixel : who.pixels) pixel = toPixel({250, 20, 20, 200});
    world.sprites.push_back(makeSprite("who", who, 1, 0.0));
    for (int i = 0; i < 5; ++i) {
        ObjectMotion motion;
        motion.kind = static_cast<ObjectMotion::Kind>(random.below(3));
        motion.object = i;
        motion.speed = random.between(0.5, 6.0);
        motion.headingDegrees = random.between(0.0, 360.0);
        motion.reach = toCoordinate(random.between(0.5, 2.0));
        motion.random = Random(random.next());
        world.movingObjects.motions.push_back(motion);
        map.objects.push_back({.x = toCoordinate(random.between(1.0, 15.0)),
                               .y = toCoordinate(random.between(1.0, 11.0)),
                               .z = toCoordinate(random.between(0.0, 1.5)),
                               .width = toCoordinate(0.4),
                               .height = toCoordinate(0.6)});
    }
    world.maps.push_back(std::move(map));
    EXPECT_TRUE(makeMovers(world).empty());
    EXPECT_TRUE(makeGates(world).empty());
    makeGateFrames(world);
    markSeeThrough(world);
    markPlans(world);
    startObjects(world);
    return world;
}

std::int64_t floorOf(std::int64_t number, std::int64_t by) {
    return number / by - (number % by != 0 && (number < 0) != (by < 0) ? 1 : 0);
}

// The offset at a share of the way, at / half.
Coordinate offsetAtShare(const Motion& motion, std::int64_t at, std::int64_t half, bool ofGate) {
    const std::int64_t way = motion.to.raw - motion.from.raw;
    if (motion.shape == MotionShape::even)
        return {motion.from.raw + static_cast<int>(floorOf(2 * way * at + half, 2 * half))};
    const double p = static_cast<double>(at) / static_cast<double>(half);
    const double q =
        motion.shape == MotionShape::smooth || ofGate ? p : std::clamp(2.0 * p - 0.5, 0.0, 1.0);
    const double share = 3.0 * q * q - 2.0 * q * q * q;
    return {motion.from.raw + static_cast<int>(std::floor(static_cast<double>(way) * share + 0.5))};
}

Coordinate offsetAfter(const Motion& motion, int steps) {
    std::int64_t at = motion.phaseSteps + steps;
    const std::int64_t period = motion.periodSteps;
    if (motion.once) {
        const std::int64_t half = period / 2;
        at = std::min(at, motion.phaseSteps <= half ? half : period + half);
    }
    at %= period;
    return offsetAtShare(motion, 2 * std::min(at, period - at), period, false);
}

// Where the picture shows the place between two.
Coordinate shownAt(Coordinate before, Coordinate now, double part) {
    const int way = now.raw - before.raw;
    return {before.raw + static_cast<int>(std::floor(way * part + 0.5))};
}

// What all cells of a mover hold, while it is at an offset.
void expectAt(const World& world, const Mover& mover, Coordinate offset, const std::string& when) {
    const Motion& motion = world.motions[static_cast<std::size_t>(mover.motion)];
    const Map& map = world.maps[0];
    for (const Shaft& shaft : mover.shafts) {
        for (int place = shaft.first; place <= shaft.last; ++place) {
            const CellBlueprint& part =
                world.blueprints[static_cast<std::size_t>(shaft.firstPart + place - shaft.first)];
            const auto edge = [&](Coordinate at, bool moves) {
                const std::int32_t there = at.raw + (moves ? offset.raw : 0) - place * 65536;
                return Coordinate{std::clamp(there, 0, 65536)};
            };
            const Coordinate low = edge(shaft.low, motion.edges != MovingEdges::high);
            const Coordinate high = edge(shaft.high, motion.edges != MovingEdges::low);
            const bool alongX = motion.axis == Axis::x;
            const bool alongY = motion.axis == Axis::y;
            const Coordinate partLow = alongX   ? part.plan.west
                                       : alongY ? part.plan.north
                                                : part.bottom;
            const Coordinate partHigh = alongX   ? part.plan.east
                                        : alongY ? part.plan.south
                                                 : part.top;
            ASSERT_LE(std::abs(partLow.raw - low.raw), 1) << when;
            ASSERT_LE(std::abs(partHigh.raw - high.raw), 1) << when;
            const Coordinate moved = alongX   ? part.textureEast
                                     : alongY ? part.textureSouth
                                              : part.textureRise;
            const int apart = (moved.raw - offset.raw) & 65535;
            ASSERT_TRUE(apart <= 1 || apart == 65535 || partHigh <= partLow) << when;
            const int ahead = place - shaft.first;
            for (const RunStart& run : shaft.runs) {
                const auto tile = static_cast<std::size_t>(static_cast<int>(run.tile) +
                                                           (alongX   ? ahead
                                                            : alongY ? ahead * map.width
                                                                     : 0));
                const int level = run.level + (alongX || alongY ? 0 : ahead);
                const bool isThere = (map.occupied[tile] >> level & 1u) != 0;
                ASSERT_EQ(isThere, partHigh > partLow) << when;
            }
        }
    }
}

void expectGates(World& world, const World& before, const std::string& when) {
    for (std::size_t i = 0; i < world.gates.size(); ++i) {
        const Gate& gate = world.gates[i];
        const GateKind& kind = world.gateKinds[static_cast<std::size_t>(gate.kind)];
        ASSERT_LE(std::abs(gate.progress - before.gates[i].progress), 1) << when;
        for (const GateFace& face : gate.faces) {
            const int frame = std::min(face.frames - 1, face.frames * gate.progress / kind.steps);
            const TextureId shown =
                world.blueprints[face.part].faces[static_cast<std::size_t>(face.face)].texture;
            ASSERT_EQ(shown, frame == 0 ? face.first : face.later + frame - 1) << when;
        }
    }
}

Coordinate offsetOf(const World& world, const Mover& mover, int steps) {
    const Motion& motion = world.motions[static_cast<std::size_t>(mover.motion)];
    if (mover.gate < 0) return offsetAfter(motion, steps);
    const Gate& gate = world.gates[static_cast<std::size_t>(mover.gate)];
    const GateKind& kind = world.gateKinds[static_cast<std::size_t>(gate.kind)];
    return offsetAtShare(motion, gate.progress, kind.steps, true);
}

TEST(MovingWorlds, AreWhereTheDefinitionSays) {
    constexpr int kWorlds = kSanitized ? 6 : 40;
    Renderer renderer;
    Verdict sum;
    int moved = 0;
    int opened = 0;
    for (int seed = 1; seed <= kWorlds; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        World world = movingWorld(random);
        for (int step = 1; step <= 500; ++step) {
            const std::string when =
                "seed " + std::to_string(seed) + ", step " + std::to_string(step);
            const bool isLookedAt = step % 7 == 0 || step < 3;
            std::vector<Coordinate> before;
            for (const Mover& mover : world.movers)
                before.push_back(offsetOf(world, mover, step - 1));
            std::vector<Object> objects = world.maps[0].objects;
            const World old = isLookedAt ? world.copy() : World();
            noteObjects(world);
            stepWorld(world, {}, {});
            stepObjects(world);
            ++world.steps;
            if (!isLookedAt) continue;
            expectGates(world, old, when);
            const double part = random.oneIn(4) ? 0.5 : random.unit();
            for (std::size_t i = 0; i < world.movers.size(); ++i) {
                const Mover& mover = world.movers[i];
                const Coordinate now = offsetOf(world, mover, step);
                moved += mover.gate < 0 && now != before[i];
                opened += mover.gate >= 0 && now != before[i];
                expectAt(world, mover, now, when);
                const ShownBetween shown(world, part);
                expectAt(world, mover, shownAt(before[i], now, part), when + ", between");
                if (::testing::Test::HasFatalFailure()) return;
            }
            const std::vector<Object> now = world.maps[0].objects;
            const ShownBetween shown(world, part);
            for (std::size_t i = 0; i < now.size(); ++i) {
                const Object& object = world.maps[0].objects[i];
                ASSERT_EQ(object.x, shownAt(objects[i].x, now[i].x, part)) << when;
                ASSERT_EQ(object.y, shownAt(objects[i].y, now[i].y, part)) << when;
                ASSERT_EQ(object.z, shownAt(objects[i].z, now[i].z, part)) << when;
                ASSERT_EQ(object.facingX, now[i].facingX) << when;
            }
            if (step % 63 != 0) continue;
            View view;
            view.x = toCoordinate(random.between(0.0, 16.0));
            view.y = toCoordinate(random.between(0.0, 12.0));
            view.z = toCoordinate(random.between(0.1, 3.5));
            view.headingDegrees = random.between(0.0, 360.0);
            view.look = random.between(-0.3, 0.3);
            view.fovDegrees = 80.0;
            view.width = 64;
            view.height = 40;
            const Image image = draw(renderer, world, view);
            sum.add(judge(world, view, image.pixels.data(), image.width, when));
        }
    }
    for (const std::string& complaint : sum.complaints) ADD_FAILURE() << complaint;
    EXPECT_EQ(sum.unexcused, 0);
    EXPECT_GT(sum.coverage["object"], 0);
    EXPECT_GT(moved, kWorlds * 50);
    EXPECT_GT(opened, kWorlds * 5);
}

}  // namespace
}  // namespace slicecast::judge

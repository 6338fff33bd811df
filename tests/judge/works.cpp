#include "works.h"

#include "world/mover.h"
#include "world/object_motion.h"
#include "world/world_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace slicecast::judge {
namespace {

constexpr int kSlot = 5;  // tiles a side; each holds one thing that moves, and beside it walls
constexpr int kSlotsEast = 4;
constexpr int kSlotsSouth = 3;
constexpr int kLevels = 4;

// ---- Worlds

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

// The fewest steps for a way there, at the speed that scenes may have.
int fewestSteps(const Motion& motion, bool ofGate) {
    const double speed = motion.shape == MotionShape::even               ? 1.0
                         : motion.shape == MotionShape::smooth || ofGate ? 1.5
                                                                         : 3.0;
    const double way = std::abs((motion.to - motion.from).value());
    return static_cast<int>(std::ceil(way * speed * 120.0 / kFastestMotion));
}

Motion anyMotion(Random& random, bool ofGate, bool isSlow) {
    Motion motion;
    motion.axis = static_cast<Axis>(random.below(3));
    motion.edges = static_cast<MovingEdges>(random.below(3));
    motion.shape = static_cast<MotionShape>(random.below(3));
    // A scene's motion leaves a block its room, so that nothing begins within a body
    const int most = isSlow && motion.edges == MovingEdges::high ? 0 : 65'536;
    motion.from = {random.between(-60'000, most)};
    motion.to = {random.between(-60'000, most)};
    if (motion.edges == MovingEdges::low) {
        motion.from = {-motion.from.raw};
        motion.to = {-motion.to.raw};
        if (isSlow) {
            motion.from = std::max(motion.from, Coordinate{0});
            motion.to = std::max(motion.to, Coordinate{0});
        }
    }
    motion.periodSteps = ofGate ? 0 : 2 * random.between(6, 150);
    if (ofGate) return motion;
    if (isSlow) motion.periodSteps = std::max(motion.periodSteps, 2 * fewestSteps(motion, false));
    motion.once = random.oneIn(3);
    if (!motion.once) motion.periodSteps += random.below(2);
    motion.phaseSteps = random.oneIn(3) ? 0 : random.below(motion.periodSteps);
    return motion;
}

GateKind anyGate(Random& random, int kinds) {
    GateKind kind;
    kind.steps = random.oneIn(5) ? 1 : random.between(2, 90);
    kind.reach = toCoordinate(random.between(0.5, 6.0));
    kind.keyed = !random.oneIn(4);
    kind.opensOnApproach = random.oneIn(4);
    kind.approach = toCoordinate(random.between(0.0, 2.0));
    kind.everySteps = random.oneIn(2) ? 0 : random.between(20, 200);
    kind.holdSteps = random.between(1, 60);
    kind.startsOpen = random.oneIn(4);
    kind.once = random.oneIn(5);
    if (kinds > 0 && random.oneIn(3)) kind.follows = {random.below(kinds)};
    return kind;
}

// Walls where no mover comes, which leave pushed bodies no room, and roofs.
void addWalls(Random& random, Map& map, BlueprintId wall) {
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const bool isBetween = x % kSlot == kSlot - 1 || y % kSlot == kSlot - 1;
            if (isBetween && random.oneIn(3)) map.setCell(x, y, 1, wall);
            if (random.oneIn(4)) map.setCell(x, y, kLevels - 1, wall);
        }
    }
}

void addLight(Random& random, Map& map) {
    map.baked.on = true;
    map.baked.sun = anyColour(random);
    map.baked.ambient = anyColour(random);
    map.baked.azimuth = random.between(0.0, 360.0);
    map.baked.altitude = random.between(10.0, 80.0);
    for (int i = random.below(5); i > 0; --i) {
        Lamp lamp;
        lamp.x = {random.between(0, map.width * 65536)};
        lamp.y = {random.between(0, map.depth * 65536)};
        lamp.z = {random.between(0, map.levels * 65536)};
        lamp.kind.colour = anyColour(random);
        lamp.kind.strength = random.between(0.5, 3.0);
        map.baked.lamps.push_back(lamp);
    }
}

void addObjects(Random& random, World& world, Map& map) {
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
        Object object;
        object.x = toCoordinate(random.between(1.0, map.width - 1.0));
        object.y = toCoordinate(random.between(1.0, map.depth - 1.0));
        object.z = toCoordinate(random.between(0.0, 1.5));
        object.width = toCoordinate(0.4);
        object.height = toCoordinate(0.6);
        map.objects.push_back(object);
    }
}

World worksWorld(Random& random, bool hasBodies) {
    World world;
    for (int i = 0; i < 6; ++i) world.textures.push_back(anyTexture(random, 1, 0.0));
    for (int i = 0; i < 4; ++i) {
        const int frames = random.between(2, 9);
        const double rate = i < 2 ? 120.0 / random.between(1, 9) : 0.0;
        world.textures.push_back(anyTexture(random, frames, rate));
    }
    const int textures = static_cast<int>(world.textures.size());
    Map map = makeMap("works", kSlot * kSlotsEast, kSlot * kSlotsSouth, kLevels, 0);
    for (int slot = 0; slot < kSlotsEast * kSlotsSouth; ++slot) {
        if (random.oneIn(8)) continue;
        CellBlueprint block;
        block.name = "thing " + std::to_string(slot);
        block.join = random.oneIn(2);
        const bool isGate = random.oneIn(2);
        // Many faces of gates are sheets whose frames show how far it is open
        for (FaceBlueprint& face : block.faces)
            face.texture =
                static_cast<TextureId>(isGate && random.oneIn(2) ? textures - 1 - random.below(2)
                                                                 : random.below(textures));
        if (isGate) {
            block.gate = static_cast<int>(world.gateKinds.size());
            world.gateKinds.push_back(anyGate(random, block.gate));
        }
        if (!isGate || random.oneIn(2)) {
            block.motion = static_cast<int>(world.motions.size());
            const Motion motion = anyMotion(random, isGate, hasBodies);
            world.motions.push_back(motion);
            if (isGate && hasBodies) {
                int& steps = world.gateKinds.back().steps;
                steps = std::max(steps, fewestSteps(motion, true));
            }
        }
        world.blueprints.push_back(block);
        const auto id = static_cast<BlueprintId>(world.blueprints.size() - 1);
        const int x = slot % kSlotsEast * kSlot + 1;
        const int y = slot / kSlotsEast * kSlot + 1;
        map.setCell(x, y, 1, id);
        if (random.oneIn(2)) map.setCell(x + 1, y, 1, id);
        if (random.oneIn(3)) map.setCell(x, y + 1, 1, id);
    }
    if (hasBodies) {
        CellBlueprint wall;
        for (FaceBlueprint& face : wall.faces)
            face.texture = static_cast<TextureId>(random.below(6));
        world.blueprints.push_back(wall);
        addWalls(random, map, static_cast<BlueprintId>(world.blueprints.size() - 1));
    }
    map.sky.low = {120, 160, 200, 255};
    map.light.on = false;
    if (random.oneIn(8)) addLight(random, map);
    addObjects(random, world, map);
    world.maps.push_back(std::move(map));
    if (!makeMovers(world).empty() || !makeGates(world).empty())
        throw std::logic_error("works that cannot be built");
    makeGateFrames(world);
    markSeeThrough(world);
    markPlans(world);
    startObjects(world);
    return world;
}

// ---- Boxes, by axis

constexpr Coordinate Box::*kLow[] = {&Box::west, &Box::north, &Box::bottom};
constexpr Coordinate Box::*kHigh[] = {&Box::east, &Box::south, &Box::top};
constexpr Coordinate Offset::*kAlong[] = {&Offset::x, &Offset::y, &Offset::z};

// Whether they have a piece of more than no extent in common, along all axes but one.
bool overlapBeside(const Box& a, const Box& b, int without) {
    for (int i = 0; i < 3; ++i) {
        if (i == without) continue;
        const Coordinate low = std::max(a.*kLow[i], b.*kLow[i]);
        const Coordinate high = std::min(a.*kHigh[i], b.*kHigh[i]);
        if (low >= high) return false;
    }
    return true;
}

bool touch(const Box& a, const Box& b) {
    return overlapBeside(a, b, -1);
}

bool touchesAny(const Box& box, const std::vector<Box>& solids) {
    return std::ranges::any_of(solids, [&](const Box& solid) { return touch(box, solid); });
}

Box movedBy(Box box, const Offset& way) {
    for (int i = 0; i < 3; ++i) {
        box.*kLow[i] = box.*kLow[i] + way.*kAlong[i];
        box.*kHigh[i] = box.*kHigh[i] + way.*kAlong[i];
    }
    return box;
}

// How much of a way along an axis a box has room for.
Coordinate roomFor(const Box& box, int axis, Coordinate way, const std::vector<Box>& solids) {
    for (const Box& solid : solids) {
        if (!overlapBeside(box, solid, axis)) continue;
        if (way.raw > 0 && solid.*kLow[axis] >= box.*kHigh[axis])
            way = std::min(way, solid.*kLow[axis] - box.*kHigh[axis]);
        if (way.raw < 0 && solid.*kHigh[axis] <= box.*kLow[axis])
            way = std::max(way, solid.*kHigh[axis] - box.*kLow[axis]);
    }
    return way;
}

std::int64_t squareOfGap(const Box& a, const Box& b) {
    std::int64_t sum = 0;
    for (int i = 0; i < 3; ++i) {
        const std::int64_t apart =
            std::max({0, (a.*kLow[i] - b.*kHigh[i]).raw, (b.*kLow[i] - a.*kHigh[i]).raw});
        sum += apart * apart;
    }
    return sum;
}

bool isNear(const Box& box, const std::vector<Box>& boxes, Coordinate distance) {
    const std::int64_t square = std::int64_t{distance.raw} * distance.raw;
    return std::ranges::any_of(boxes,
                               [&](const Box& other) { return squareOfGap(box, other) <= square; });
}

// ---- Motions

std::int64_t floorOf(std::int64_t number, std::int64_t by) {
    return number / by - (number % by != 0 && (number < 0) != (by < 0) ? 1 : 0);
}

// The offset when p is at / of, in whole numbers.
Coordinate offsetAtShare(const Motion& motion, std::int64_t at, std::int64_t of, bool ofGate) {
    const std::int64_t way = motion.to.raw - motion.from.raw;
    if (motion.shape == MotionShape::stopAndGo && !ofGate) {
        at = std::clamp<std::int64_t>(4 * at - of, 0, 2 * of);
        of = 2 * of;
    }
    const bool isEven = motion.shape == MotionShape::even;
    const std::int64_t share = isEven ? at : at * at * (3 * of - 2 * at);
    const std::int64_t whole = isEven ? of : of * of * of;
    return {motion.from.raw + static_cast<int>(floorOf(2 * way * share + whole, 2 * whole))};
}

}  // namespace

// ---- The model

WorksModel::WorksModel(const World& world) : motions_(world.motions), kinds_(world.gateKinds) {
    const Map& map = world.maps[0];
    constexpr Coordinate kFar = {std::numeric_limits<std::int32_t>::max() / 4};
    grid_ = {Coordinate{0}, tileEdge(map.width), Coordinate{0}, tileEdge(map.depth), {0}, kFar};
    for (const Mover& mover : world.movers) {
        Slider slider;
        slider.motion = mover.motion;
        slider.gate = mover.gate;
        const int axis = static_cast<int>(motionOf(slider).axis);
        for (const Shaft& shaft : mover.shafts) {
            for (const RunStart& run : shaft.runs) {
                const int x = static_cast<int>(run.tile) % map.width;
                const int y = static_cast<int>(run.tile) / map.width;
                Line line = {{tileEdge(x), tileEdge(x + 1), tileEdge(y), tileEdge(y + 1),
                              tileEdge(run.level), tileEdge(run.level + 1)},
                             shaft.low,
                             shaft.high};
                line.cells.*kLow[axis] = tileEdge(shaft.first);
                line.cells.*kHigh[axis] = tileEdge(shaft.last + 1);
                slider.lines.push_back(line);
            }
        }
        movers_.push_back(slider);
    }
    for (const Gate& gate : world.gates) {
        Door door;
        door.kind = gate.kind;
        door.slider = gate.mover;
        door.boxes = gate.boxes;
        const GateKind& kind = kinds_[static_cast<std::size_t>(gate.kind)];
        door.wantsOpen = kind.startsOpen;
        door.progress = kind.startsOpen ? kind.steps : 0;
        door.unwanted = kind.holdSteps;
        gates_.push_back(door);
    }
    for (Slider& slider : movers_) {
        slider.offset =
            slider.gate < 0
                ? offsetAfter(slider, 0)
                : offsetWhenOpen(slider, gates_[static_cast<std::size_t>(slider.gate)].progress);
        slider.before = slider.offset;
    }
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            for (int level = 0; level < map.levels; ++level) {
                const CellBlueprint& block = world.blueprints[map.cell(x, y, level)];
                if (map.cell(x, y, level) == kEmptyCell || !block.isStill()) continue;
                still_.push_back({tileEdge(x), tileEdge(x + 1), tileEdge(y), tileEdge(y + 1),
                                  tileEdge(level), tileEdge(level + 1)});
            }
        }
    }
}

const Motion& WorksModel::motionOf(const Slider& slider) const {
    return motions_[static_cast<std::size_t>(slider.motion)];
}

Coordinate WorksModel::offsetAfter(const Slider& slider, int steps) const {
    const Motion& motion = motionOf(slider);
    const std::int64_t period = motion.periodSteps;
    std::int64_t at = std::int64_t{motion.phaseSteps} + steps;
    if (motion.once) {
        const std::int64_t half = period / 2;
        at = std::min(at, motion.phaseSteps <= half ? half : period + half);
    }
    at %= period;
    return offsetAtShare(motion, 2 * std::min(at, period - at), period, false);
}

Coordinate WorksModel::offsetWhenOpen(const Slider& slider, int progress) const {
    const Door& door = gates_[static_cast<std::size_t>(slider.gate)];
    return offsetAtShare(motionOf(slider), progress,
                         kinds_[static_cast<std::size_t>(door.kind)].steps, true);
}

Box WorksModel::blockOf(std::size_t mover) const {
    const Slider& slider = movers_[mover];
    return partOf(slider.lines.front(), motionOf(slider), slider.offset);
}

// Where a line's block is, whole.
Box WorksModel::partOf(const Line& line, const Motion& motion, Coordinate offset) {
    const int axis = static_cast<int>(motion.axis);
    Box box = line.cells;
    box.*kLow[axis] = line.low + (motion.edges == MovingEdges::high ? Coordinate{0} : offset);
    box.*kHigh[axis] = line.high + (motion.edges == MovingEdges::low ? Coordinate{0} : offset);
    return box;
}

std::vector<Box> WorksModel::solids(const Slider* without) const {
    std::vector<Box> boxes = still_;
    for (const Door& door : gates_) {
        const bool isOpen = door.progress == kinds_[static_cast<std::size_t>(door.kind)].steps;
        if (door.slider < 0 && !isOpen)
            boxes.insert(boxes.end(), door.boxes.begin(), door.boxes.end());
    }
    for (const Slider& slider : movers_) {
        if (&slider == without) continue;
        for (const Line& line : slider.lines)
            boxes.push_back(partOf(line, motionOf(slider), slider.offset));
    }
    // Around the grid and below it
    for (int axis = 0; axis < 3; ++axis) {
        Box before = grid_;
        before.*kLow[axis] = tileEdge(-64);
        before.*kHigh[axis] = Coordinate{0};
        boxes.push_back(before);
        if (axis == 2) continue;
        Box behind = grid_;
        behind.*kLow[axis] = grid_.*kHigh[axis];
        behind.*kHigh[axis] = grid_.*kHigh[axis] + tileEdge(64);
        boxes.push_back(behind);
    }
    return boxes;
}

// How far a free body goes with a mover, or before it.
Offset WorksModel::wayOf(const Slider& slider, Coordinate offset, const Body& body,
                         const std::vector<Box>& others) const {
    const Motion& motion = motionOf(slider);
    const int axis = static_cast<int>(motion.axis);
    const Box& box = body.box;
    const bool isUpright = motion.axis == Axis::z;
    Coordinate push;
    for (const Line& line : slider.lines) {
        const Box now = partOf(line, motion, slider.offset);
        const Box next = partOf(line, motion, offset);
        if (isUpright) {
            if (motion.edges == MovingEdges::low || !overlapBeside(box, now, 2)) continue;
            // A top lifts what it meets, even if the block is empty; what rests on it sinks along
            const Coordinate ground = std::max(now.bottom, now.top);
            const Coordinate rise = std::max(next.bottom, next.top) - ground;
            const Coordinate above = box.bottom - ground;
            if (above.raw >= 0 && above < rise) push = std::max(push, rise - above);
            const bool rests = body.rides && above.raw == 0 && now.bottom < now.top;
            if (rests && rise.raw < 0 && push.raw <= 0) push = std::min(push, rise);
            continue;
        }
        const int across = axis == 0 ? 1 : 0;
        if (box.*kLow[across] >= now.*kHigh[across] || box.*kHigh[across] <= now.*kLow[across])
            continue;
        const bool isOver =
            box.*kHigh[axis] > now.*kLow[axis] && box.*kLow[axis] < now.*kHigh[axis];
        if (box.bottom == now.top && body.rides && isOver && motion.edges == MovingEdges::both &&
            push.raw == 0)
            push = offset - slider.offset;
        if (box.bottom >= now.top || box.top <= now.bottom) continue;
        if (next.*kLow[axis] >= next.*kHigh[axis]) continue;
        if (box.*kLow[axis] >= now.*kHigh[axis] && box.*kLow[axis] < next.*kHigh[axis])
            push = std::max(push, next.*kHigh[axis] - box.*kLow[axis]);
        if (box.*kHigh[axis] <= now.*kLow[axis] && box.*kHigh[axis] > next.*kLow[axis])
            push = std::min(push, next.*kLow[axis] - box.*kHigh[axis]);
    }
    Offset way;
    if (isUpright && push.raw < 0) {
        std::vector<Box> all = others;
        for (const Line& line : slider.lines) all.push_back(partOf(line, motion, offset));
        way.z = roomFor(box, 2, push, all);
    } else {
        way.*kAlong[axis] = isUpright ? push : roomFor(box, axis, push, others);
    }
    return way;
}

// False if it has to wait.
bool WorksModel::move(Slider& slider, Coordinate offset, std::vector<Body>& bodies) {
    if (offset == slider.offset) return true;
    const auto isMet = [&](const Body& body) {
        return std::ranges::any_of(
            slider.lines, [&](const Line& line) { return squareOfGap(body.box, line.cells) == 0; });
    };
    if (std::ranges::none_of(bodies, isMet)) {
        slider.offset = offset;
        return true;
    }
    const std::vector<Box> before = solids();
    const std::vector<Box> others = solids(&slider);
    std::vector<Box> after = others;
    for (const Line& line : slider.lines) after.push_back(partOf(line, motionOf(slider), offset));
    std::vector<Box> places;
    for (const Body& body : bodies) {
        places.push_back(body.box);
        if (touchesAny(body.box, before)) continue;
        places.back() = movedBy(body.box, wayOf(slider, offset, body, others));
        if (touchesAny(places.back(), after)) return false;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].box = places[i];
    slider.offset = offset;
    return true;
}

void WorksModel::decide(Door& door, const GateAsk& ask, const std::vector<Body>& bodies) {
    const GateKind& kind = kinds_[static_cast<std::size_t>(door.kind)];
    const bool wantedOpen = door.wantsOpen;
    const bool isAsked = ask.wish != GateAsk::Wish::nothing && kind.keyed;
    if (isAsked &&
        judge::isNear({ask.x, ask.x, ask.y, ask.y, ask.z, ask.z}, door.boxes, kind.reach)) {
        const bool isChange = ask.wish == GateAsk::Wish::change;
        door.wantsOpen = isChange ? !door.wantsOpen : ask.wish == GateAsk::Wish::open;
        ++seen_.heard;
    }
    const auto wait = [&] {
        if (door.unwanted == kind.holdSteps) return;
        if (++door.unwanted == kind.holdSteps) door.wantsOpen = false;
    };
    if (kind.opensOnApproach) {
        const bool wasNear = door.isNear;
        door.isNear = std::ranges::any_of(bodies, [&](const Body& body) {
            return judge::isNear(body.box, door.boxes, kind.approach);
        });
        if (door.isNear && !wasNear) door.wantsOpen = true;
        if (door.isNear) door.unwanted = 0;
        if (!door.isNear) wait();
    }
    if (kind.everySteps > 0) {
        ++door.sinceTimer;
        if (door.sinceTimer == kind.everySteps) {
            door.sinceTimer = 0;
            door.unwanted = 0;
            door.wantsOpen = true;
        } else if (!kind.opensOnApproach && door.progress == kind.steps) {
            wait();
        }
    }
    if (!kind.follows.empty()) {
        const bool isLed = std::ranges::any_of(gates_, [&](const Door& other) {
            const GateKind& its = kinds_[static_cast<std::size_t>(other.kind)];
            return other.kind == kind.follows.front() && other.progress == its.steps;
        });
        if (isLed != door.isLed) {
            door.wantsOpen = isLed;
            ++seen_.led;
        }
        door.isLed = isLed;
    }
    if (kind.once && wantedOpen) door.wantsOpen = true;
}

void WorksModel::stepDoor(Door& door, const GateAsk& ask, std::vector<Body>& bodies) {
    const int all = kinds_[static_cast<std::size_t>(door.kind)].steps;
    decide(door, ask, bodies);
    const int next = std::clamp(door.progress + (door.wantsOpen ? 1 : -1), 0, all);
    if (next == door.progress) return;
    if (door.slider >= 0) {
        Slider& slider = movers_[static_cast<std::size_t>(door.slider)];
        if (!move(slider, offsetWhenOpen(slider, next), bodies)) {
            ++seen_.gatesHeld;
            return;
        }
        ++seen_.opening;
    } else if (door.progress == all) {
        const std::vector<Box> before = solids();
        const bool isHeld = std::ranges::any_of(bodies, [&](const Body& body) {
            return !touchesAny(body.box, before) && touchesAny(body.box, door.boxes);
        });
        if (isHeld) {
            ++seen_.doorsHeld;
            return;
        }
    }
    door.progress = next;
}

void WorksModel::step(const GateAsk& ask, std::vector<Body>& bodies) {
    for (Slider& slider : movers_) {
        slider.before = slider.offset;
        if (slider.gate >= 0) continue;
        const Motion& motion = motionOf(slider);
        const int steps = slider.steps + 1;
        const int end = motion.periodSteps / 2;
        const int atEnd =
            (motion.phaseSteps <= end ? end : motion.periodSteps + end) - motion.phaseSteps;
        seen_.ended += motion.once && slider.steps == atEnd;
        const Coordinate offset = offsetAfter(slider, steps);
        seen_.moving += offset != slider.offset;
        if (move(slider, offset, bodies)) {
            slider.steps = steps;
        } else {
            ++seen_.waiting;
        }
    }
    for (Door& door : gates_) stepDoor(door, ask, bodies);
}

void WorksModel::showDoor(World& world, std::size_t gate) const {
    const Door& door = gates_[gate];
    const int steps = kinds_[static_cast<std::size_t>(door.kind)].steps;
    for (const GateFace& face : world.gates[gate].faces) {
        const int frame = std::min(face.frames - 1, face.frames * door.progress / steps);
        world.blueprints[face.part].faces[static_cast<std::size_t>(face.face)].texture =
            frame == 0 ? face.first : static_cast<TextureId>(face.later + frame - 1);
    }
}

void WorksModel::showSlider(World& world, std::size_t mover, Coordinate offset) const {
    const Motion& motion = motionOf(movers_[mover]);
    Map& map = world.maps[0];
    for (const Shaft& shaft : world.movers[mover].shafts) {
        for (int place = shaft.first; place <= shaft.last; ++place) {
            CellBlueprint& part =
                world.blueprints[static_cast<std::size_t>(shaft.firstPart + place - shaft.first)];
            const auto edge = [&](Coordinate at, bool moves) {
                const int there = at.raw + (moves ? offset.raw : 0) - place * 65536;
                return Coordinate{std::clamp(there, 0, 65536)};
            };
            const Coordinate low = edge(shaft.low, motion.edges != MovingEdges::high);
            const Coordinate high = edge(shaft.high, motion.edges != MovingEdges::low);
            const Coordinate slid = {offset.raw & 65535};
            if (motion.axis == Axis::x) {
                part.plan.west = low;
                part.plan.east = high;
                part.textureEast = slid;
            } else if (motion.axis == Axis::y) {
                part.plan.north = low;
                part.plan.south = high;
                part.textureSouth = slid;
            } else {
                part.bottom = low;
                part.top = high;
                part.textureRise = slid;
            }
            const int ahead = place - shaft.first;
            for (const RunStart& run : shaft.runs) {
                const int step = motion.axis == Axis::x   ? 1
                                 : motion.axis == Axis::y ? map.width
                                                          : 0;
                const std::size_t tile = run.tile + static_cast<std::size_t>(ahead * step);
                const int level = run.level + (step == 0 ? ahead : 0);
                map.occupied[tile] &= ~(1u << level);
                if (low < high) map.occupied[tile] |= 1u << level;
            }
        }
    }
}

void WorksModel::show(World& world, double part) const {
    for (std::size_t i = 0; i < movers_.size(); ++i) {
        const Slider& slider = movers_[i];
        const int way = slider.offset.raw - slider.before.raw;
        showSlider(world, i,
                   {slider.before.raw +
                    static_cast<int>(std::floor(65536.0 * way * part / 65536.0 + 0.5))});
    }
    for (std::size_t i = 0; i < gates_.size(); ++i) showDoor(world, i);
}

// ---- Works

Works::Works(std::uint64_t seed)
    : random(seed),
      hasBodies(!random.oneIn(4)),
      world(worksWorld(random, hasBodies)),
      model(world) {}

// Anywhere, or in a doorway, or right under, on or beside something that moves.
Body Works::anyBody() {
    const bool isCoarse = random.oneIn(3);
    const auto within = [&](Coordinate low, Coordinate high) {
        const Coordinate at = {random.between(low.raw, std::max(low.raw, high.raw))};
        return isCoarse ? Coordinate{at.raw >> 13 << 13} : at;
    };
    Body body;
    body.rides = !random.oneIn(3);
    const Box size = {{0}, within(toCoordinate(0.25), toCoordinate(0.5)),
                      {0}, within(toCoordinate(0.25), toCoordinate(0.5)),
                      {0}, within(toCoordinate(0.5), toCoordinate(1.0))};
    Box room = {{0},        tileEdge(kSlot * kSlotsEast), {0}, tileEdge(kSlot * kSlotsSouth), {0},
                tileEdge(2)};
    const bool isInDoorway = !world.gates.empty() && random.oneIn(3);
    const bool isBeside = !isInDoorway && !world.movers.empty() && !random.oneIn(4);
    const int axis = random.below(3);
    const bool isBefore = random.oneIn(2);
    const auto anyOf = [&](const auto& list) {
        return static_cast<std::size_t>(random.below(static_cast<int>(list.size())));
    };
    if (isInDoorway) room = model.doorwayOf(anyOf(world.gates));
    if (isBeside) room = model.blockOf(anyOf(world.movers));
    for (int i = 0; i < 3; ++i) {
        const Coordinate whole = size.*kHigh[i];
        Coordinate& low = body.box.*kLow[i];
        low = within(room.*kLow[i] - Coordinate{whole.raw / 2}, room.*kHigh[i] - whole);
        if (isBeside && i == axis) low = isBefore ? room.*kLow[i] - whole : room.*kHigh[i];
        low = std::max(low, Coordinate{0});
        body.box.*kHigh[i] = low + whole;
    }
    return body;
}

void Works::step() {
    std::erase_if(bodies, [&](const Body&) { return random.oneIn(60); });
    if (hasBodies && bodies.size() < 12 && random.oneIn(3)) bodies.push_back(anyBody());
    GateAsk ask;
    if (random.oneIn(12)) {
        ask.wish = static_cast<GateAsk::Wish>(random.between(1, 3));
        ask.x = toCoordinate(random.between(0.0, 1.0 * kSlot * kSlotsEast));
        ask.y = toCoordinate(random.between(0.0, 1.0 * kSlot * kSlotsSouth));
        ask.z = toCoordinate(random.between(0.1, 3.0));
    }
    defined = bodies;
    model.step(ask, defined);
    noteObjects(world);
    stepWorld(world, bodies, ask);
    stepObjects(world);
    ++world.steps;
}

View Works::anyView(int width, int height) {
    View view;
    view.x = toCoordinate(random.between(0.0, 1.0 * kSlot * kSlotsEast));
    view.y = toCoordinate(random.between(0.0, 1.0 * kSlot * kSlotsSouth));
    view.z = toCoordinate(random.between(0.1, 3.5));
    view.headingDegrees = random.between(0.0, 360.0);
    view.look = random.between(-0.3, 0.3);
    view.fovDegrees = 80.0;
    view.width = width;
    view.height = height;
    return view;
}

Scene worksScene(std::uint64_t seed, int width, int height) {
    Works works(seed);
    for (int steps = works.random.between(100, 400); steps > 0; --steps) works.step();
    const View view = works.anyView(width, height);
    World defined = works.world.copy();
    works.model.show(defined, 1.0);
    return {std::move(works.world), view, {}, std::move(defined)};
}

}  // namespace slicecast::judge

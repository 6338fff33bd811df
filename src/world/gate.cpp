#include "world/gate.h"

#include "world/body.h"
#include "world/world.h"

#include <algorithm>

namespace slicecast {
namespace {

void show(World& world, const Gate& gate, const GateKind& kind) {
    for (const BlueprintId part : gate.parts)
        world.blueprints[part].passable = gate.mover < 0 && gate.progress == kind.steps;
    for (const GateFace& face : gate.faces) {
        const int frame = static_cast<int>(std::min<std::int64_t>(
            face.frames - 1, std::int64_t{gate.progress} * face.frames / kind.steps));
        world.blueprints[face.part].faces[static_cast<std::size_t>(face.face)].texture =
            frame == 0 ? face.first : static_cast<TextureId>(face.later + frame - 1);
    }
}

// The gap between two intervals, 0 if they touch.
std::int64_t gap(Coordinate low, Coordinate high, Coordinate fromLow, Coordinate fromHigh) {
    const std::int64_t below = std::int64_t{fromLow.raw} - high.raw;
    const std::int64_t above = std::int64_t{low.raw} - fromHigh.raw;
    return std::max({below, above, std::int64_t{0}});
}

// Most bodies are far from most gates: the bounds tell them apart.
bool isWithin(const Gate& gate, const Box& box, Coordinate distance) {
    return areWithin(box, gate.bounds, distance) &&
           std::any_of(gate.boxes.begin(), gate.boxes.end(),
                       [&](const Box& block) { return areWithin(box, block, distance); });
}

bool hears(const Gate& gate, const GateKind& kind, const GateAsk& ask) {
    return kind.keyed && ask.map == gate.map &&
           isWithin(gate, {ask.x, ask.x, ask.y, ask.y, ask.z, ask.z}, kind.reach);
}

void obey(Gate& gate, const GateKind& kind, const GateAsk& ask) {
    if (ask.wish == GateAsk::Wish::nothing || !hears(gate, kind, ask)) return;
    gate.wantsOpen =
        ask.wish == GateAsk::Wish::open || (ask.wish == GateAsk::Wish::change && !gate.wantsOpen);
}

// Closes when this has been asked for so long.
void countDown(Gate& gate, const GateKind& kind) {
    if (gate.awaySteps < kind.holdSteps && ++gate.awaySteps == kind.holdSteps)
        gate.wantsOpen = false;
}

// Opens when someone comes near, closes when all have left; keys override in between.
void updateApproach(Gate& gate, const GateKind& kind, std::span<const Body> bodies, bool looks) {
    const bool wasNear = gate.isNear;
    if (looks)
        gate.isNear = std::any_of(bodies.begin(), bodies.end(), [&](const Body& body) {
            return body.map == gate.map && isWithin(gate, body.box, kind.approach);
        });
    if (gate.isNear) {
        gate.awaySteps = 0;
        if (!wasNear) gate.wantsOpen = true;
        return;
    }
    countDown(gate, kind);
}

// Opens so often. The time to close counts from when it is open.
void updateTimer(Gate& gate, const GateKind& kind) {
    if (++gate.waitSteps >= kind.everySteps) {
        gate.waitSteps = 0;
        gate.awaySteps = 0;
        gate.wantsOpen = true;
    } else if (!kind.opensOnApproach && gate.progress == kind.steps) {
        countDown(gate, kind);
    }
}

// Opens and closes as the gates do that it follows; keys override in between.
void follow(Gate& gate, const GateKind& kind) {
    const bool isLed = kind.openLeaders > 0;
    if (isLed != gate.isLed) gate.wantsOpen = isLed;
    gate.isLed = isLed;
}

// Sets how far a gate is open, and tells the kinds that follow it.
void setProgress(World& world, Gate& gate, const GateKind& kind, int progress) {
    const int change = int{progress == kind.steps} - int{gate.progress == kind.steps};
    gate.progress = progress;
    if (change == 0) return;
    for (const int follower : kind.followers)
        world.gateKinds[static_cast<std::size_t>(follower)].openLeaders += change;
}

// All that opens and closes it.
void decide(Gate& gate, const GateKind& kind, std::span<const Body> bodies, const GateAsk& ask,
            bool looks) {
    const bool wasWanted = gate.wantsOpen;
    obey(gate, kind, ask);
    if (kind.opensOnApproach) updateApproach(gate, kind, bodies, looks);
    if (kind.everySteps > 0) updateTimer(gate, kind);
    if (!kind.follows.empty()) follow(gate, kind);
    if (kind.isLocked) gate.wantsOpen = gate.isNear = gate.isLed = false;
    if (kind.once && wasWanted) gate.wantsOpen = true;
}

// True if closing the fully open gate would enclose a body that is free now.
bool isInUse(World& world, const Gate& gate, std::span<Body> bodies) {
    const auto eachBody = [&](auto action) {
        eachEncounter(world.encounters, gate.firstEncounter,
                      [&](int body) { action(bodies[static_cast<std::size_t>(body)]); });
    };
    eachBody([&](Body& body) { body.isMet = isFree(world, travellerOf(body)); });
    for (const BlueprintId part : gate.parts) world.blueprints[part].passable = false;
    bool isEntered = false;
    eachBody([&](const Body& body) {
        isEntered = isEntered || (body.isMet && !isFree(world, travellerOf(body)));
    });
    for (const BlueprintId part : gate.parts) world.blueprints[part].passable = true;
    return isEntered;
}

const GateKind& kindOf(const World& world, const Gate& gate) {
    return world.gateKinds[static_cast<std::size_t>(gate.kind)];
}

void stepGate(World& world, Gate& gate, std::span<Body> bodies, const GateAsk& ask, bool looks) {
    const GateKind& kind = kindOf(world, gate);
    gate.previousProgress = gate.progress;
    decide(gate, kind, bodies, ask, looks);
    if (gate.progress == (gate.wantsOpen ? kind.steps : 0)) return;
    const int next = gate.progress + (gate.wantsOpen ? 1 : -1);
    if (gate.mover >= 0) {
        Mover& mover = world.movers[static_cast<std::size_t>(gate.mover)];
        const Motion& motion = world.motions[static_cast<std::size_t>(mover.motion)];
        if (!moveTo(world, mover, offsetWhenOpen(motion, next, kind.steps), bodies)) return;
    } else if (gate.progress == kind.steps && isInUse(world, gate, bodies)) {
        return;
    }
    setProgress(world, gate, kind, next);
    show(world, gate, kind);
}

// Puts what the gate moves where it begins.
void resetMover(World& world, const Gate& gate, const GateKind& kind) {
    Mover& mover = world.movers[static_cast<std::size_t>(gate.mover)];
    const Motion& motion = world.motions[static_cast<std::size_t>(mover.motion)];
    mover.firstEncounter = -1;
    moveTo(world, mover, offsetWhenOpen(motion, gate.progress, kind.steps), {});
    mover.previousOffset = mover.offset;
}

}  // namespace

bool areWithin(const Box& a, const Box& b, Coordinate distance) {
    const std::int64_t x = gap(a.west, a.east, b.west, b.east);
    const std::int64_t y = gap(a.north, a.south, b.north, b.south);
    const std::int64_t z = gap(a.bottom, a.top, b.bottom, b.top);
    return x * x + y * y + z * z <= std::int64_t{distance.raw} * distance.raw;
}

int refusedGate(const World& world, const GateAsk& ask, int map, const Box& body) {
    const bool isAsked = ask.wish == GateAsk::Wish::change || ask.wish == GateAsk::Wish::open;
    for (std::size_t i = 0; i < world.gates.size(); ++i) {
        const Gate& gate = world.gates[i];
        const GateKind& kind = world.gateKinds[static_cast<std::size_t>(gate.kind)];
        if (!kind.isLocked) continue;
        if ((isAsked && hears(gate, kind, ask)) ||
            (kind.opensOnApproach && gate.map == map && isWithin(gate, body, kind.approach)))
            return static_cast<int>(i);
    }
    return -1;
}

GateOffer gateOffer(const World& world, const GateAsk& ask) {
    GateOffer offer = GateOffer::none;
    for (const Gate& gate : world.gates) {
        const GateKind& kind = world.gateKinds[static_cast<std::size_t>(gate.kind)];
        if (!hears(gate, kind, ask)) continue;
        if (!gate.wantsOpen) {
            if (kind.isLocked) continue;
            return GateOffer::open;
        }
        if (kind.once) continue;
        offer = GateOffer::close;
    }
    return offer;
}

void stepGates(World& world, std::span<Body> bodies, const GateAsk& ask) {
    const auto lookouts = static_cast<std::size_t>(
        std::count_if(world.gates.begin(), world.gates.end(),
                      [&](const Gate& gate) { return kindOf(world, gate).opensOnApproach; }));
    const std::size_t most = kMostApproachLooks / std::max(bodies.size(), std::size_t{1});
    std::size_t before = lookouts - std::min(lookouts, world.nextLookout);  // its turn comes
    for (Gate& gate : world.gates) {
        const bool opensOnApproach = kindOf(world, gate).opensOnApproach;
        const bool looks = opensOnApproach && before % std::max(lookouts, std::size_t{1}) < most;
        before += opensOnApproach;
        stepGate(world, gate, bodies, ask, looks);
    }
    world.nextLookout = lookouts > most ? (world.nextLookout + most) % lookouts : 0;
}

void resetGates(World& world) {
    world.nextLookout = 0;
    for (Gate& gate : world.gates) {
        const GateKind& kind = world.gateKinds[static_cast<std::size_t>(gate.kind)];
        gate.wantsOpen = kind.startsOpen;
        setProgress(world, gate, kind, kind.startsOpen ? kind.steps : 0);
        gate.previousProgress = gate.progress;
        gate.isNear = false;
        gate.awaySteps = kind.holdSteps;
        gate.waitSteps = 0;
        gate.isLed = false;
        if (gate.mover >= 0) resetMover(world, gate, kind);
        show(world, gate, kind);
    }
}

std::vector<GateMoment> momentOfGates(const World& world) {
    std::vector<GateMoment> moments;
    moments.reserve(world.gates.size());
    for (const Gate& gate : world.gates)
        moments.push_back({gate.progress, gate.previousProgress, gate.wantsOpen, gate.isNear,
                           gate.awaySteps, gate.waitSteps, gate.isLed});
    return moments;
}

void restoreGates(World& world, std::span<const GateMoment> moments) {
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const GateMoment& moment = moments[i];
        Gate& gate = world.gates[i];
        const GateKind& kind = kindOf(world, gate);
        setProgress(world, gate, kind, moment.progress);
        gate.previousProgress = moment.previousProgress;
        gate.wantsOpen = moment.wantsOpen;
        gate.isNear = moment.isNear;
        gate.awaySteps = moment.awaySteps;
        gate.waitSteps = moment.waitSteps;
        gate.isLed = moment.isLed;
        show(world, gate, kind);
    }
}

GateState stateOf(const Gate& gate, const GateKind& kind) {
    if (gate.progress == kind.steps) return GateState::open;
    if (gate.wantsOpen) return GateState::opening;
    return gate.progress == 0 ? GateState::closed : GateState::closing;
}

}  // namespace slicecast

#include "tours/guide.h"

#include "base/angle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slicecast {
namespace {

constexpr double kNear = 0.12;           // of a spot: it is reached
constexpr double kSlowWithin = 0.5;      // of a spot
constexpr int kPatience = 240;           // steps without getting nearer
constexpr double kLookStep = 0.0078125;  // screen heights looked up in a step: 0.94 a second

// From -180 to 180.
double shortWay(double degrees) {
    return wrapDegrees(degrees + 180.0) - 180.0;
}

double bearing(double x, double y) {
    if (x == 0.0) return y < 0.0 ? 270.0 : 90.0;
    const double degrees = atanDegrees(y / x);
    return wrapDegrees(x < 0.0 ? degrees + 180.0 : degrees);
}

// Quick, then slow, then none: few different turns make a recording that can be read.
double turnBy(double degrees) {
    const double size = std::abs(degrees);
    const double turn = size > 24.0 ? 1.5 : size > 6.0 ? 0.75 : size > 0.75 ? 0.25 : 0.0;
    return degrees < 0.0 ? -turn : turn;
}

}  // namespace

Guide::Guide(World world, const std::string& scene) : session_(std::move(world)), recorder_(scene) {
    session_.record(&recorder_);
}

void Guide::walk(const std::vector<Spot>& spots) {
    for (const Spot& spot : spots) goTo(spot, {.forward = 1.0});
}

void Guide::run(const std::vector<Spot>& spots) {
    for (const Spot& spot : spots) goTo(spot, {.forward = 1.0, .fast = true});
}

void Guide::creep(const std::vector<Spot>& spots) {
    for (const Spot& spot : spots) goTo(spot, {.forward = 1.0, .fly = -1.0});
}

void Guide::stepAside(double axis, int steps) {
    step({.strafe = axis}, steps);
    step({}, 20);
}

void Guide::use() {
    step({.use = true}, 12);
}

void Guide::rideUp(Spot spot, double headingDegrees) {
    turnTo(headingDegrees);
    waitForLift(spot, false);
    walk({spot});
    turnTo(headingDegrees);
    waitForLift(spot, true);
}

void Guide::waitForLift(Spot spot, bool isUp) {
    const World& world = session_.world();
    const int x = toCoordinate(spot.x).tile();
    const int y = toCoordinate(spot.y).tile();
    for (const Mover& mover : world.movers) {
        if (mover.map != session_.player().map || x < mover.west || x > mover.east ||
            y < mover.north || y > mover.south)
            continue;
        const Motion& motion = world.motions[static_cast<std::size_t>(mover.motion)];
        const Coordinate wanted =
            isUp ? std::max(motion.from, motion.to) : std::min(motion.from, motion.to);
        for (int i = 0; i < motion.periodSteps && mover.offset != wanted; ++i) step({});
        if (mover.offset != wanted) trouble_ = "the lift does not come";
        return;
    }
    trouble_ = "no lift there";
}

void Guide::jump() {
    step({.jump = true}, 12);
    step({}, 108);
}

void Guide::jumpAhead() {
    step({.forward = 1.0, .jump = true}, 12);
    step({.forward = 1.0}, 60);
    step({}, 60);
}

void Guide::turnTo(double headingDegrees) {
    for (int i = 0; i < 1000; ++i) {
        const double turn = turnBy(shortWay(headingDegrees - session_.player().headingDegrees));
        if (turn == 0.0) return;
        step({.turnDegrees = turn});
    }
}

void Guide::lookTo(double look) {
    for (int i = 0; i < 1000; ++i) {
        const double left = look - session_.player().look;
        if (std::abs(left) < kLookStep) return;
        step({.lookHeights = left < 0.0 ? -kLookStep : kLookStep});
    }
}

void Guide::lookAround() {
    step({.turn = -1.0}, 70);
    step({.turn = 0.75, .look = 0.5}, 120);
    step({.turn = 0.5, .look = -0.5}, 120);
    step({.turn = -0.5}, 80);
    step({}, 30);
    lookTo(0.0);
}

void Guide::wait(int steps) {
    step({}, steps);
}

void Guide::flyTo(Spot spot, double eyeHeight) {
    for (int i = 0; i < 2400 && trouble_.empty(); ++i) {
        const double up = eyeHeight - session_.eye().z.value();
        if (std::abs(up) < 0.05) break;
        step({.fly = up > 0.0 ? 1.0 : -1.0});
    }
    step({}, 30);
    goTo(spot, {.forward = 1.0});
}

void Guide::step(const Input& input, int count) {
    for (int i = 0; i < count && trouble_.empty(); ++i) session_.step(input);
}

double Guide::distanceTo(Spot spot) const {
    const double x = spot.x - session_.player().x.value();
    const double y = spot.y - session_.player().y.value();
    return std::sqrt(x * x + y * y);
}

double Guide::turnTowards(Spot spot) const {
    return shortWay(
        bearing(spot.x - session_.player().x.value(), spot.y - session_.player().y.value()) -
        session_.player().headingDegrees);
}

// A step to there, ahead only where that leads there.
Input Guide::towards(Spot spot, Input pace) const {
    const double turn = turnTowards(spot);
    pace.turnDegrees = turnBy(turn);
    if (std::abs(turn) > 24.0) {
        pace.forward = 0.0;
    } else if (std::abs(turn) > 6.0 || distanceTo(spot) < kSlowWithin) {
        pace.forward = 0.5;
        pace.fast = false;
    }
    return pace;
}

void Guide::goThrough(Spot spot) {
    constexpr int kLongest = 10 * kStepsPerSecond;
    const int leaps = session_.player().leaps;
    for (int i = 0; i < kLongest && trouble_.empty() && session_.player().leaps == leaps; ++i) {
        step(distanceTo(spot) > kNear ? towards(spot, {.forward = 1.0}) : Input{});
    }
    if (trouble_.empty() && session_.player().leaps == leaps) {
        trouble_ = "no way through at " + std::to_string(spot.x) + ", " + std::to_string(spot.y);
    }
    step({.forward = 1.0}, 20);
    for (int i = 0; i < 120 && !session_.player().onGround; ++i) step({});
}

void Guide::goTo(Spot spot, Input pace) {
    double nearest = distanceTo(spot) + 1.0;
    int waited = 0;
    while (trouble_.empty() && distanceTo(spot) > kNear) {
        step(towards(spot, pace));

        // Stuck?
        waited = distanceTo(spot) < nearest - 0.01 ? 0 : waited + 1;
        if (waited == 0) nearest = distanceTo(spot);
        if (waited > kPatience) {
            const Player& player = session_.player();
            trouble_ = "stuck at " + std::to_string(player.x.value()) + ", " +
                       std::to_string(player.y.value()) + ", feet at " +
                       std::to_string(player.z.value()) + ", on the way to " +
                       std::to_string(spot.x) + ", " + std::to_string(spot.y);
        }
    }
    step({.fly = pace.fly}, 20);
    for (int i = 0; i < 120 && !session_.player().onGround && !session_.player().flying; ++i)
        step({.fly = pace.fly});
}

}  // namespace slicecast

#include "session/session.h"

#include "base/angle.h"
#include "base/bits.h"
#include "overlay/minimap.h"
#include "render/classic/draw_classic.h"

#include <cmath>
#include <utility>

namespace slicecast {
namespace {

static_assert(kLookLimit <= kMaxLook, "every look of the player can be drawn");

PlayerInput playerInput(const Input& input, double speed) {
    return {.forward = input.forward,
            .strafe = input.strafe,
            .turn = input.turn,
            .look = input.look,
            .fly = input.fly,
            .turnDegrees = input.turnDegrees,
            .lookHeights = input.lookHeights,
            .jump = input.jump,
            .fast = input.fast,
            .slow = input.slow,
            .speed = speed};
}

Coordinate between(Coordinate a, Coordinate b, double fraction) {
    return toCoordinate(a.value() + (b.value() - a.value()) * fraction);
}

// The short way round.
double headingBetween(double a, double b, double fraction) {
    const double turn = wrapDegrees(b - a + 180.0) - 180.0;
    return wrapDegrees(a + turn * fraction);
}

Eye eyeOf(const Player& player) {
    return {.map = player.map, .x = player.x, .y = player.y, .z = eyeHeight(player), .headingDegrees = player.headingDegrees, .look = player.look};
}

// A hash of numbers in order: each is mixed in by the finisher of SplitMix64.
class Hash {
public:
    void add(std::int64_t number) {
        std::uint64_t z = state_ + static_cast<std::uint64_t>(number) + 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        state_ = z ^ (z >> 31);
    }
    void add(double number) { add(bitCast<std::int64_t>(number)); }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0;
};

}  // namespace

Session::Session(World world) : world_(std::move(world)) {
    for (const Map& map : world_.maps) ownLights_.push_back(map.light);
    reset();
}

void Session::step(const Input& input) {
    previous_ = player_;
    stepPlayer(world_, player_, playerInput(input, options_.speed));
    ++steps_;
}

bool Session::draw(const Picture& picture, double fraction) {
    const Eye seen = eye(fraction);
    const bool drawn = options_.method == DrawMethod::classic ? drawClassic(world_, seen, options_.render, options_.classic, picture)
                                                              : renderer_.draw(world_, seen, options_.render, picture);
    if (!drawn) return false;
    if (options_.minimap) drawMinimap(world_, seen, {.level = options_.minimapLevel, .fovDegrees = options_.render.fovDegrees}, picture);
    return true;
}

void Session::reset() {
    player_ = playerAtStart(world_);
    previous_ = player_;
}

void Session::levelLook() {
    slicecast::levelLook(world_, player_);
    previous_ = player_;
}

void Session::setHeading(double degrees) {
    slicecast::setHeading(player_, degrees);
    previous_.headingDegrees = player_.headingDegrees;
}

void Session::setFlying(bool flying) {
    slicecast::setFlying(world_, player_, flying);
}

bool Session::setEye(const Eye& eye) {
    const bool exists = eye.map >= 0 && static_cast<std::size_t>(eye.map) < world_.maps.size();
    if (!exists || !isAboveFloor(eye) || !std::isfinite(eye.headingDegrees) || !(std::abs(eye.look) <= kMaxLook)) return false;
    player_ = playerWithEye(eye.map, eye.x, eye.y, eye.z, eye.headingDegrees, eye.look);
    previous_ = player_;
    return true;
}

std::string Session::setOption(std::string_view name, std::string_view value) {
    std::string fault = slicecast::setOption(options_, name, value);
    applyLight();
    return fault;
}

std::string Session::option(std::string_view name) const {
    return optionValue(options_, name);
}

SessionState Session::state() const {
    const Map& map = world_.maps[static_cast<std::size_t>(player_.map)];
    return {.title = world_.title,
            .map = map.name,
            .x = player_.x.value(),
            .y = player_.y.value(),
            .z = eyeHeight(player_).value(),
            .feet = player_.z.value(),
            .headingDegrees = player_.headingDegrees,
            .look = player_.look,
            .speed = std::sqrt(player_.velocityX * player_.velocityX + player_.velocityY * player_.velocityY),
            .flying = player_.flying,
            .crouched = player_.crouched,
            .onGround = player_.onGround,
            .intensity = map.light.intensity,
            .multiplier = map.light.multiplier,
            .steps = steps_};
}

Eye Session::eye(double fraction) const {
    const Eye now = eyeOf(player_);
    if (!(fraction < 1.0) || previous_.map != player_.map) return now;
    const Eye before = eyeOf(previous_);
    const double part = fraction > 0.0 ? fraction : 0.0;
    return {.map = now.map,
            .x = between(before.x, now.x, part),
            .y = between(before.y, now.y, part),
            .z = between(before.z, now.z, part),
            .headingDegrees = headingBetween(before.headingDegrees, now.headingDegrees, part),
            .look = before.look + (now.look - before.look) * part};
}

SliceTrace Session::trace(int width, int height, int column) {
    return renderer_.trace(world_, eye(), options_.render, width, height, column);
}

std::uint64_t Session::fingerprint() const {
    Hash hash;
    const Player& p = player_;
    for (const std::int64_t number : {std::int64_t{p.map}, std::int64_t{p.x.raw}, std::int64_t{p.y.raw}, std::int64_t{p.z.raw}, std::int64_t{p.eyeLag.raw},
                                      std::int64_t{p.flying}, std::int64_t{p.crouched}, std::int64_t{p.onGround}, std::int64_t{p.jumpHeld},
                                      std::int64_t{p.lateJumpSteps}, std::int64_t{p.earlyJumpSteps}, steps_}) {
        hash.add(number);
    }
    for (const double number : {p.velocityX, p.velocityY, p.velocityZ, p.headingDegrees, p.look, p.turnRate, p.lookRate, p.eyeLagRate, options_.speed}) {
        hash.add(number);
    }
    return hash.value();
}

// The renderer takes the light from the map.
void Session::applyLight() {
    for (std::size_t i = 0; i < world_.maps.size(); ++i) {
        world_.maps[i].light.intensity = options_.intensity.value_or(ownLights_[i].intensity);
        world_.maps[i].light.multiplier = options_.multiplier.value_or(ownLights_[i].multiplier);
    }
}

}  // namespace slicecast

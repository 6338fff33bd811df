// Random play for a long time: nobody ends up inside a block, no number is lost, memory stays flat,
// and the same inputs lead to the same state, also from a moment that was gone back to.
//
//     slicecast-soak FRAMES SCENE...
#include "base/random.h"
#include "files/scene_file.h"
#include "session/session.h"
#include "world/collision.h"
#include "world/traveller.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#ifdef SLICECAST_SANITIZED
#include <sanitizer/allocator_interface.h>
#elif defined(__GLIBC__)
#include <malloc.h>
#endif

using namespace slicecast;

namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 24;
constexpr std::int64_t kStepsPerLeg = 40;    // with one input
constexpr std::int64_t kLegsPerChange = 60;  // of map, mode or place
// KB, from half of the frames to the end; what is known of light grows as maps are seen.
constexpr std::int64_t kMostGrowth = 5 << 10;

// KB that the program has allocated and not freed; 0 where only the system's figure is known. That
// would not do: it counts what was freed and is kept for later, and sanitizers keep up to 256 MB.
std::int64_t memoryInUse() {
#ifdef SLICECAST_SANITIZED
    return static_cast<std::int64_t>(__sanitizer_get_current_allocated_bytes() >> 10);
#elif defined(__GLIBC__)
    const struct mallinfo2 heap = mallinfo2();
    return static_cast<std::int64_t>((heap.uordblks + heap.hblkhd) >> 10);
#else
    return 0;
#endif
}

Input randomInput(Random& random) {
    Input input;
    input.forward = random.oneIn(5) ? random.between(-1.0, 1.0) : 1.0;
    input.strafe = random.oneIn(3) ? random.between(-1.0, 1.0) : 0.0;
    input.turn = random.oneIn(2) ? random.between(-1.0, 1.0) : 0.0;
    input.look = random.oneIn(6) ? random.between(-1.0, 1.0) : 0.0;
    input.fly = random.oneIn(4) ? random.between(-1.0, 1.0) : 0.0;
    input.turnDegrees = random.oneIn(8) ? random.between(-90.0, 90.0) : 0.0;
    input.jump = random.oneIn(3);
    input.fast = random.oneIn(3);
    input.slow = random.oneIn(8);
    input.use = random.oneIn(4);
    return input;
}

void changeSomething(Session& session, Random& random) {
    switch (random.below(5)) {
        case 0:
            session.reset();
            break;
        case 1:
            session.setFlying(!session.player().flying);
            break;
        case 2:
            session.goToMap(random.below(static_cast<int>(session.world().maps.size())));
            break;
        case 3:
            session.setHeading(random.between(0.0, 360.0));
            break;
        default:
            session.levelLook();
            break;
    }
}

bool isNumber(double value) {
    return std::isfinite(value);
}

// What is wrong after a step; empty if nothing is.
std::string fault(const Session& session) {
    const World& world = session.world();
    const Player& player = session.player();
    for (const double value :
         {player.velocityX, player.velocityY, player.velocityZ, player.headingDegrees, player.look})
        if (!isNumber(value)) return "the player has a number that is none";
    if (!isFree(world, travellerOf(player))) return "the player is inside a block";
    for (const ObjectMotion& motion : world.movingObjects.motions) {
        const Object& object = world.maps[static_cast<std::size_t>(motion.map)]
                                   .objects[static_cast<std::size_t>(motion.object)];
        if (!isFree(world, {.map = motion.map,
                            .box = objectBody(object),
                            .eye = {object.x, object.y, object.z + motion.eye},
                            .behind = motion.behind,
                            .floats = object.floats}))
            return "object " + std::to_string(motion.object) + " of map " +
                   std::to_string(motion.map) + " is inside a block";
    }
    return {};
}

// Two sessions of one scene get the same inputs. One of them is drawn, and now and then plays
// something else and goes back.
class Soak {
public:
    Soak(std::string name, const World& world)
        : name_(std::move(name)),
          drawn_(world.copy()),
          undrawn_(world.copy()),
          pixels_(std::size_t{kWidth} * kHeight),
          // The same play wherever the project lies
          forInputs_(hashOf(name_.substr(name_.find_last_of('/') + 1))),
          forChanges_(forInputs_.next()) {}

    // False, and a line on standard error, if something is wrong.
    bool frame() {
        if (frames_ % (kStepsPerLeg * kLegsPerChange) == 0) {
            detour();
            Random same = forChanges_;
            changeSomething(drawn_, forChanges_);
            changeSomething(undrawn_, same);
        }
        if (frames_ % kStepsPerLeg == 0) input_ = randomInput(forInputs_);
        drawn_.step(input_);
        undrawn_.step(input_);
        ++frames_;
        const Picture picture{pixels_.data(), kWidth, kHeight, kWidth};
        if (!drawn_.draw(picture, 0.5)) return complain("cannot be drawn");
        if (const std::string found = fault(drawn_); !found.empty()) return complain(found.c_str());
        if (frames_ % kStepsPerLeg == 0 && drawn_.fingerprint() != undrawn_.fingerprint())
            return complain("the same inputs have led to another state");
        return true;
    }

private:
    // One of the sessions plays something else, and goes back to the moment before.
    void detour() {
        const SessionMoment before = drawn_.moment();
        Random random = forInputs_;
        changeSomething(drawn_, random);
        const Input input = randomInput(random);
        for (std::int64_t n = 0; n < kStepsPerLeg; ++n) drawn_.step(input);
        drawn_.restore(before);
    }
    static std::uint64_t hashOf(const std::string& text) {
        std::uint64_t hash = 1;
        for (const char c : text) hash = Random(hash ^ static_cast<unsigned char>(c)).next();
        return hash;
    }
    bool complain(const char* what) const {
        std::fprintf(stderr, "%s, frame %lld: %s\n", name_.c_str(), static_cast<long long>(frames_),
                     what);
        return false;
    }

    std::string name_;
    Session drawn_;
    Session undrawn_;
    std::vector<Pixel> pixels_;
    Random forInputs_;
    Random forChanges_;
    Input input_;
    std::int64_t frames_ = 0;
};

std::int64_t toNumber(const char* text) {
    std::int64_t number = 0;
    const char* const end = text + std::strlen(text);
    const auto [stop, error] = std::from_chars(text, end, number);
    return error == std::errc{} && stop == end ? number : 0;
}

}  // namespace

int main(int count, char** words) {
    const std::int64_t frames = count > 2 ? toNumber(words[1]) : 0;
    if (frames < 1) {
        std::fprintf(stderr, "usage: slicecast-soak FRAMES SCENE...\n");
        return 2;
    }
    std::vector<std::unique_ptr<Soak>> soaks;
    for (int i = 2; i < count; ++i) {
        LoadedScene scene = readSceneFile(words[i]);
        for (const Fault& f : scene.faults) std::fprintf(stderr, "%s\n", describe(f).c_str());
        if (!scene.world) return 1;
        soaks.push_back(std::make_unique<Soak>(words[i], *scene.world));
    }
    const std::int64_t each = (frames + count - 3) / (count - 2);
    std::int64_t before = 0;
    for (std::int64_t n = 0; n < each; ++n) {
        if (n == each / 2) before = memoryInUse();
        for (const auto& soak : soaks)
            if (!soak->frame()) return 1;
    }
    const std::int64_t growth = memoryInUse() - before;
    std::printf("%lld frames of %d scenes; memory grew by %lld KB\n",
                static_cast<long long>(each * (count - 2)), count - 2,
                static_cast<long long>(growth));
    if (growth <= kMostGrowth) return 0;
    std::fprintf(stderr, "at most %lld KB are asked for\n", static_cast<long long>(kMostGrowth));
    return 1;
}

// Any text as a scene that loads: 200 steps with changing input, and pictures of both methods with
// all that is asked of them. A picture in slices has the same bytes as one in a single call, and
// steps from a moment that was gone back to lead to the same state.
#include "base/random.h"
#include "fuzz/fuzzed_scene.h"
#include "session/session.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>

using namespace slicecast;

namespace {

// Of a scene that is played: the others take too long.
constexpr std::size_t kMostCells = 20'000;
constexpr std::size_t kMostObjects = 500;
constexpr int kSteps = 200;
constexpr int kStepsOfPicture = 40;
constexpr int kWidth = 40;
constexpr int kHeight = 26;
constexpr LightWork kLightOfSlice = 20'000;
constexpr int kMostSlices = 60;

using Pixels = std::array<Pixel, kWidth * kHeight>;

Picture pictureOf(Pixels& pixels) {
    return {pixels.data(), kWidth, kHeight, kWidth};
}

bool isSmall(const World& world) {
    std::size_t cells = 0;
    std::size_t objects = 0;
    for (const Map& map : world.maps) {
        cells += map.cells.size() + map.floor.tiles.size();
        objects += map.objects.size();
    }
    return cells <= kMostCells && objects <= kMostObjects;
}

Input inputOf(Random& random) {
    Input input;
    input.forward = random.between(-1.0, 1.0);
    input.strafe = random.oneIn(3) ? random.between(-1.0, 1.0) : 0.0;
    input.turn = random.between(-1.0, 1.0);
    input.look = random.oneIn(3) ? random.between(-1.0, 1.0) : 0.0;
    input.fly = random.oneIn(4) ? random.between(-1.0, 1.0) : 0.0;
    input.turnDegrees = random.oneIn(4) ? random.between(-180.0, 180.0) : 0.0;
    input.jump = random.oneIn(3);
    input.fast = random.oneIn(3);
    input.use = random.oneIn(3);
    return input;
}

void draw(Session& session, double fraction, Random& random) {
    static Pixels whole;
    static Pixels sliced;
    session.setOption("method", "exact");
    int column = 0;
    for (int i = 0; i < kMostSlices && column < kWidth; ++i) {
        column = session.drawSome(pictureOf(sliced), fraction, column, kLightOfSlice);
        if (column < 0) std::abort();
    }
    const bool isWhole = column == kWidth;
    if (!session.draw(pictureOf(whole), fraction, isWhole ? kAllLight : kLightOfSlice))
        std::abort();
    if (isWhole && whole != sliced) std::abort();
    for (const std::string_view method : {"exact", "classic"}) {
        session.setOption("method", method);
        if (method == "classic" && !session.draw(pictureOf(whole), fraction, kLightOfSlice))
            std::abort();
        for (const int each : {0, random.below(kWidth), kWidth - 1})
            static_cast<void>(session.trace(kWidth, kHeight, each, random.below(kHeight)));
    }
}

// The same steps from the same moment lead to the same state.
void goBack(Session& session, const Input& input) {
    const SessionMoment moment = session.moment();
    const auto played = [&] {
        for (int step = 0; step < 20; ++step) session.step(input);
        return session.fingerprint();
    };
    const std::uint64_t first = played();
    session.restore(moment);
    if (played() != first) std::abort();
    session.restore(moment);
}

void play(World world, Random random) {
    Session session(std::move(world));
    Input input;
    for (int step = 0; step < kSteps; ++step) {
        if (step % 20 == 0) input = inputOf(random);
        if (step == kSteps / 2)
            session.goToMap(random.below(static_cast<int>(session.world().maps.size())));
        if (step == kSteps * 3 / 4) session.setFlying(!session.player().flying);
        session.step(input);
        if (step % kStepsOfPicture == 0) draw(session, random.unit(), random);
        if (step % kStepsOfPicture == 20) goBack(session, input);
        input.use = input.jump = false;
    }
    static_cast<void>(session.fingerprint());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    LoadedScene loaded = loadFuzzed({reinterpret_cast<const char*>(data), size});
    // What cannot be played is no input to grow others from.
    if (!loaded.world || !isSmall(*loaded.world)) return -1;
    play(std::move(*loaded.world), Random(size == 0 ? 0u : data[size / 2] + 1u));
    return 0;
}

// Any text as a scene. What loads is played for some steps and drawn.
#include "fuzz/fuzzed_scene.h"
#include "session/session.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <utility>

using namespace slicecast;

namespace {

constexpr std::size_t kMostCells = 100'000;  // of a scene that is played: the others take too long
constexpr int kSteps = 24;

void play(World world, std::uint8_t seed) {
    std::size_t cells = 0;
    for (const Map& map : world.maps) cells += map.cells.size() + map.floor.tiles.size();
    if (cells > kMostCells) return;
    Session session(std::move(world));
    constexpr int kWidth = 48;
    constexpr int kHeight = 32;
    std::array<Pixel, kWidth * kHeight> pixels{};
    for (int step = 0; step < kSteps; ++step) {
        Input input;
        input.forward = (seed >> (step % 8) & 1) != 0 ? 1.0 : -1.0;
        input.turn = (seed >> (step % 5) & 1) != 0 ? 1.0 : 0.0F;
        input.jump = step % 7 == seed % 7;
        input.use = step % 11 == 3;
        session.step(input);
        if (step % 8 == 0 && !session.draw({pixels.data(), kWidth, kHeight, kWidth})) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    LoadedScene loaded = loadFuzzed({reinterpret_cast<const char*>(data), size});
    if (loaded.world) play(std::move(*loaded.world), size > 0 ? data[size / 2] : std::uint8_t{0});
    return 0;
}

// Any text as a scene. What loads is played for some steps and drawn.
#include "scene/scene.h"
#include "session/session.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace slicecast;

namespace {

constexpr std::size_t kMostCells = 100'000;  // of a scene that is played: the others take too long
constexpr int kSteps = 24;

std::vector<std::uint8_t> readPicture(const std::string& name) {
    const std::string folder = SLICECAST_SOURCE_FOLDER "/tests/scene/broken/images/";
    std::ifstream file(folder + name, std::ios::binary);
    if (!file) std::abort();
    return {std::istreambuf_iterator<char>(file), {}};
}

// What a scene names is one of the tests' pictures, or stands for one of them.
const std::vector<std::uint8_t>& picture(const std::string& path) {
    static std::map<std::string, std::vector<std::uint8_t>> known;
    constexpr std::array kNames = {"brick.png", "see-through.png", "sheet.png", "sky.png"};
    const std::string name = path.substr(path.rfind('/') + 1);
    const bool isKnown = std::find(kNames.begin(), kNames.end(), name) != kNames.end();
    const std::string file = isKnown ? name : "tile.png";
    const auto [place, isNew] = known.try_emplace(file);
    if (isNew) place->second = readPicture(file);
    return place->second;
}

// Each fault says where, what was found and what was expected.
void checkFaults(const std::vector<Fault>& faults) {
    for (const Fault& fault : faults)
        if (fault.found.empty() || fault.expected.empty() || fault.file.empty()) std::abort();
}

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
    ParsedScene parsed = parseScene({reinterpret_cast<const char*>(data), size}, "fuzz.json");
    checkFaults(parsed.faults);
    checkFaults(parsed.warnings);
    if (!parsed.description) {
        if (parsed.faults.empty()) std::abort();
        return 0;
    }
    SceneFiles files;
    for (const std::string& name : parsed.files) files[name] = picture(name);
    LoadedScene loaded = loadScene(std::move(parsed), files);
    checkFaults(loaded.faults);
    if (loaded.world.has_value() == !loaded.faults.empty()) std::abort();
    if (loaded.world) play(std::move(*loaded.world), size > 0 ? data[size / 2] : std::uint8_t{0});
    return 0;
}

// Writes scenes with all that the schema knows as files into the folder of its argument.
#include "fuzz/fuzzed_scene.h"

#include <filesystem>
#include <fstream>
#include <string>

using namespace slicecast;

int main(int, char** arguments) {
    constexpr int kScenes = 150;
    constexpr std::size_t kMostBytes = 16'000;  // the fuzzers take no longer ones
    const std::filesystem::path folder = arguments[1];
    std::filesystem::create_directories(folder);
    SceneMaker& maker = sceneMaker();
    Random random(27);
    std::string before;
    for (int written = 0; written < kScenes;) {
        // Some are new, some change one of those
        const std::string text =
            before.empty() ? maker.fresh(random) : maker.changed(before, random);
        const std::string next = maker.mended(text, before, faultsOf);
        before = random.oneIn(3) || next.size() > kMostBytes ? "" : next;
        if (next.empty() || next.size() > kMostBytes) continue;
        maker.count(next);
        std::ofstream(folder / (std::to_string(written++) + ".json"), std::ios::binary) << next;
    }
}

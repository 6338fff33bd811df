#include "shipped.h"

#include "files/scene_file.h"
#include "processor_time.h"
#include "session/session.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace slicecast {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr int kSteps = 120;        // played first
constexpr double kFraction = 0.5;  // of the way between the last two steps
constexpr int kFramesOfTurn = 4;

struct SceneStart {
    std::string scene;
    std::unique_ptr<Session> session;
    double least = 1e9;  // seconds
};

std::vector<std::string> allScenes(const std::string& assets) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(assets + "/scenes")) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() == ".json" && name != "index") names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

bool printShipped(const std::string& assets, int frames, std::vector<std::string> scenes) {
    if (scenes.empty()) scenes = allScenes(assets);
    std::vector<SceneStart> starts;
    for (const std::string& name : scenes) {
        LoadedScene scene = readSceneFile(assets + "/scenes/" + name + ".json");
        for (const Fault& fault : scene.faults)
            std::fprintf(stderr, "%s\n", describe(fault).c_str());
        if (!scene.world) return false;
        starts.push_back({name, std::make_unique<Session>(std::move(*scene.world))});
        for (int step = 0; step < kSteps; ++step) starts.back().session->step({});
    }
    std::vector<Pixel> pixels(static_cast<std::size_t>(kWidth) * kHeight);
    for (int done = 0; done < frames; done += kFramesOfTurn) {
        for (SceneStart& start : starts) {
            for (int i = 0; i < kFramesOfTurn; ++i) {
                const double begin = processorSeconds();
                start.session->draw({pixels.data(), kWidth, kHeight, kWidth}, kFraction);
                start.least = std::min(start.least, processorSeconds() - begin);
            }
        }
    }
    for (const SceneStart& start : starts)
        std::printf("%-14s %7.3f ns/px\n", start.scene.c_str(),
                    start.least * 1e9 / (kWidth * kHeight));
    return true;
}

}  // namespace slicecast

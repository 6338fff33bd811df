#include "baked_light.h"

#include "files/scene_file.h"
#include "processor_time.h"
#include "session/session.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <vector>

namespace slicecast {
namespace {

constexpr std::array kLitScenes = {"harbour-town", "castle",     "hill-abbey", "garden",
                                   "glassworks",   "library",    "temple",     "water-palace",
                                   "night-works",  "first-walk", "wayhouse"};
constexpr int kSteadyFrames = 4;  // of a round
constexpr int kStepsPerFrame = 2;
constexpr int kGateFrames = 60;
constexpr int kLastFrames = 10;  // in which no gate opens any more

class LitCanvas {
public:
    // Milliseconds of the processor that drawing takes.
    double draw(Session& session) {
        const double begin = processorSeconds();
        session.draw({pixels_.data(), kWidth, kHeight, kWidth});
        return (processorSeconds() - begin) * 1e3;
    }

private:
    static constexpr int kWidth = 1280;
    static constexpr int kHeight = 720;
    std::vector<Pixel> pixels_ = std::vector<Pixel>(static_cast<std::size_t>(kWidth) * kHeight);
};

double middleOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

// A session with baked light and one without, side by side.
struct LitPair {
    Session lit;
    Session plain;

    explicit LitPair(const World& world) : lit(world.copy()), plain(world.copy()) {
        plain.setOption("baked", "off");
    }
    void step(const Input& input) {
        lit.step(input);
        plain.step(input);
    }
};

struct LitTimes {
    std::vector<double> bake;    // the first lit picture, without what every one takes
    std::vector<double> steady;  // later ones
    std::vector<double> plain;   // without baked light

    void measure(const World& world, LitCanvas& canvas) {
        LitPair pair(world);
        canvas.draw(pair.plain);  // brings textures into the caches
        const double first = canvas.draw(pair.lit);
        std::vector<double> later;
        for (int i = 0; i < kSteadyFrames; ++i) {
            later.push_back(canvas.draw(pair.lit));
            plain.push_back(canvas.draw(pair.plain));
        }
        bake.push_back(first - middleOf(later));
        steady.insert(steady.end(), later.begin(), later.end());
    }
};

// Eyes on the four sides of a gate, from where keys open it.
std::vector<Eye> eyesBefore(const Gate& gate) {
    const Box& box = gate.bounds;
    const double x = (box.west.value() + box.east.value()) / 2.0;
    const double y = (box.north.value() + box.south.value()) / 2.0;
    constexpr double kAway = 1.5;
    const Coordinate z = box.bottom + Coordinate{32768};
    return {{gate.map, toCoordinate(box.west.value() - kAway), toCoordinate(y), z, 0.0, 0.0},
            {gate.map, toCoordinate(box.east.value() + kAway), toCoordinate(y), z, 180.0, 0.0},
            {gate.map, toCoordinate(x), toCoordinate(box.north.value() - kAway), z, 90.0, 0.0},
            {gate.map, toCoordinate(x), toCoordinate(box.south.value() + kAway), z, 270.0, 0.0}};
}

// What baked light adds to the dearest frame while a gate opens, milliseconds more than to a frame
// in which nothing changes. The least of some repetitions; the dearest of all gates and eyes.
double dearestGateFrame(const World& world, LitCanvas& canvas, int repetitions) {
    double dearest = 0.0;
    for (const Gate& gate : world.gates) {
        for (const Eye& eye : eyesBefore(gate)) {
            std::vector<double> least(kGateFrames, 1e9);
            for (int repetition = 0; repetition < repetitions; ++repetition) {
                LitPair pair(world);
                pair.lit.setEye(eye);
                pair.plain.setEye(eye);
                canvas.draw(pair.lit);
                canvas.draw(pair.plain);
                for (int frame = 0; frame < kGateFrames; ++frame) {
                    for (int step = 0; step < kStepsPerFrame; ++step)
                        pair.step({.open = frame == 0});
                    const double lit = canvas.draw(pair.lit);
                    double& cost = least[static_cast<std::size_t>(frame)];
                    cost = std::min(cost, lit - canvas.draw(pair.plain));
                }
            }
            const double steady = middleOf({least.end() - kLastFrames, least.end()});
            dearest = std::max(dearest, *std::max_element(least.begin(), least.end()) - steady);
        }
    }
    return dearest;
}

}  // namespace

bool printBakedLight(const std::string& assets, int rounds, const std::string& only) {
    LitCanvas canvas;
    for (const char* name : kLitScenes) {
        if (!only.empty() && only != name) continue;
        const LoadedScene scene = readSceneFile(assets + "/scenes/" + name + ".json");
        if (!scene.world) return false;
        LitTimes times;
        for (int round = 0; round < rounds; ++round) times.measure(*scene.world, canvas);
        const double first = times.bake.front();
        const double steady = middleOf(times.steady);
        const double plain = middleOf(times.plain);
        std::printf("%-13s bake %6.2f ms  the first %6.2f  steady %5.2f of %5.2f  gate %6.2f\n",
                    name, middleOf(times.bake), first, steady - plain, steady,
                    dearestGateFrame(*scene.world, canvas, 3));
        std::fflush(stdout);
    }
    return true;
}

}  // namespace slicecast

#include "baked_light.h"

#include "canvas.h"
#include "views.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

namespace slicecast {
namespace {

constexpr int kSteadyFrames = 4;  // of a round
constexpr int kStepsPerFrame = 2;
constexpr int kGateFrames = 60;
constexpr int kLastFrames = 10;  // in which no gate opens any more

// Milliseconds of the processor that drawing takes.
double drawingTime(Session& session, Canvas& canvas) {
    return secondsOf([&] { session.draw(canvas.picture()); }) * 1e3;
}

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

    void measure(const World& world, Canvas& canvas) {
        LitPair pair(world);
        drawingTime(pair.plain, canvas);  // brings textures into the caches
        const double first = drawingTime(pair.lit, canvas);
        std::vector<double> later;
        for (int i = 0; i < kSteadyFrames; ++i) {
            later.push_back(drawingTime(pair.lit, canvas));
            plain.push_back(drawingTime(pair.plain, canvas));
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
double dearestGateFrame(const World& world, Canvas& canvas, int repetitions) {
    double dearest = 0.0;
    for (const Gate& gate : world.gates) {
        for (const Eye& eye : eyesBefore(gate)) {
            std::vector<double> least(kGateFrames, 1e9);
            for (int repetition = 0; repetition < repetitions; ++repetition) {
                LitPair pair(world);
                pair.lit.setEye(eye);
                pair.plain.setEye(eye);
                drawingTime(pair.lit, canvas);
                drawingTime(pair.plain, canvas);
                for (int frame = 0; frame < kGateFrames; ++frame) {
                    for (int step = 0; step < kStepsPerFrame; ++step)
                        pair.step({.open = frame == 0});
                    const double lit = drawingTime(pair.lit, canvas);
                    double& cost = least[static_cast<std::size_t>(frame)];
                    cost = std::min(cost, lit - drawingTime(pair.plain, canvas));
                }
            }
            const double steady = middleOf({least.end() - kLastFrames, least.end()});
            dearest = std::max(dearest, *std::max_element(least.begin(), least.end()) - steady);
        }
    }
    return dearest;
}

}  // namespace

bool printBakedLight(const std::string& root, int rounds, const std::vector<std::string>& scenes) {
    Canvas canvas;
    for (const std::string& name : scenes) {
        const std::unique_ptr<Session> session = openScene(root, name);
        if (!session) return false;
        const World world = session->takeWorld();
        LitTimes times;
        for (int round = 0; round < rounds; ++round) times.measure(world, canvas);
        const double first = times.bake.front();
        const double steady = middleOf(times.steady);
        const double plain = middleOf(times.plain);
        std::printf("%-13s bake %6.2f ms  the first %6.2f  steady %5.2f of %5.2f  gate %6.2f\n",
                    name.c_str(), middleOf(times.bake), first, steady - plain, steady,
                    dearestGateFrame(world, canvas, 3));
        std::fflush(stdout);
    }
    return true;
}

}  // namespace slicecast

// Measures how fast views are drawn, each beside the limit kernel, and a copy of the frame.
// Everything takes its turn round by round, so that whatever else the machine does falls on all
// alike; times are the least of all rounds. ROOT is the folder of the sources; views.h says what
// a VIEW is.
//
//     slicecast-bench ROOT ROUNDS VIEW...            prints JSON for tools/bench
//     slicecast-bench ROOT STEPS slowest SCENE...    the slowest of every so many steps of tours
//     slicecast-bench ROOT FRAMES overlays [NAME]    prints what each overlay takes, or one
//     slicecast-bench ROOT ROUNDS light SCENE...     prints what baked light takes

#include "baked_light.h"
#include "canvas.h"
#include "limit_kernel.h"
#include "overlays.h"
#include "phases.h"
#include "slowest.h"
#include "views.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// In a round, one after another; the first ones find other caches.
constexpr int kFrames = 4;
constexpr int kPhasedFrames = 2;

// Seconds of a frame: the least of each round.
using Times = std::vector<double>;

template <typename Draw>
void measure(Times& times, Draw&& draw) {
    double least = secondsOf(draw);
    for (int i = 1; i < kFrames; ++i) least = std::min(least, secondsOf(draw));
    times.push_back(least);
}

struct MeasuredView {
    std::string name;
    std::unique_ptr<Session> session;
    std::unique_ptr<PhasedFrame> phased = std::make_unique<PhasedFrame>(*session);
    Times times = {};
    Times limit = {};                      // at the same time
    Phases phases = {1.0, 1.0, 1.0, 1.0};  // of the quickest frame

    void measureRound(Canvas& canvas, LimitKernel& kernel) {
        measure(limit, [&] { kernel.draw(canvas.pixels.data()); });
        measure(times, [&] { session->draw(canvas.picture()); });
        for (int i = 0; i < kPhasedFrames; ++i) {
            const Phases now = phased->draw(canvas.picture());
            if (now.sum() < phases.sum()) phases = now;
        }
    }

    // The middle one of the rounds: what disturbs a view disturbs the limit beside it, too.
    double timesTheLimit() const {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < times.size(); ++i) ratios.push_back(times[i] / limit[i]);
        std::sort(ratios.begin(), ratios.end());
        return ratios[ratios.size() / 2];
    }
};

// Works out the view's light. False, and the reason printed, if the view cannot be drawn or its
// phased frame is another picture.
bool prepare(const MeasuredView& view, Canvas& canvas) {
    const auto refuse = [&view](const char* why) {
        std::fprintf(stderr, "slicecast-bench: %s %s\n", view.name.c_str(), why);
        return false;
    };
    if (!view.session->draw(canvas.picture())) return refuse("cannot be drawn");
    const std::vector<Pixel> drawn = canvas.pixels;
    std::fill(canvas.pixels.begin(), canvas.pixels.end(), 0);
    view.phased->draw(canvas.picture());
    return canvas.pixels == drawn || refuse("is another picture when drawn phase by phase");
}

// `spread`: how much longer than the least the middle one of the rounds took, as a share.
void printTimes(Times times) {
    std::sort(times.begin(), times.end());
    std::printf("\"nsPerPixel\": %.4f, \"spread\": %.4f", nsPerPixel(times.front()),
                times[times.size() / 2] / times.front() - 1.0);
}

int run(const std::string& root, int rounds, const std::vector<std::string>& names) {
    Canvas canvas;
    std::vector<MeasuredView> views;
    for (const std::string& name : names) {
        std::unique_ptr<Session> session = openView(root, name);
        if (!session) {
            std::fprintf(stderr, "slicecast-bench: there is no view \"%s\"\n", name.c_str());
            return 1;
        }
        views.push_back({name, std::move(session)});
        if (!prepare(views.back(), canvas)) return 1;
    }
    LimitKernel kernel(kWidth, kHeight);
    std::vector<Pixel> copied(canvas.pixels.size());
    Times limit;
    Times copy;
    for (int round = 0; round < rounds; ++round) {
        measure(copy, [&] {
            std::memcpy(copied.data(), canvas.pixels.data(), copied.size() * sizeof(Pixel));
        });
        measure(limit, [&] { kernel.draw(canvas.pixels.data()); });
        for (MeasuredView& view : views) view.measureRound(canvas, kernel);
    }

    std::printf("{ \"width\": %d, \"height\": %d, \"rounds\": %d,\n  \"copy\": { ", kWidth, kHeight,
                rounds);
    printTimes(copy);
    std::printf(" },\n  \"limit\": { ");
    printTimes(limit);
    std::printf(" },\n  \"views\": [");
    for (const MeasuredView& view : views) {
        std::printf("%s\n    { \"name\": \"%s\", ", &view == &views.front() ? "" : ",",
                    view.name.c_str());
        printTimes(view.times);
        const Phases& phases = view.phases;
        std::printf(", \"ratio\": %.4f,\n      \"phases\": { \"setUp\": %.4f, ",
                    view.timesTheLimit(), nsPerPixel(phases.setUp));
        std::printf("\"walk\": %.4f, \"paint\": %.4f, \"copy\": %.4f } }", nsPerPixel(phases.walk),
                    nsPerPixel(phases.paint), nsPerPixel(phases.copy));
    }
    std::printf("\n  ] }\n");
    return 0;
}

}  // namespace
}  // namespace slicecast

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv, argv + argc);
    const int rounds = argc >= 3 ? std::atoi(argv[2]) : 0;
    const std::string what = argc > 3 ? words[3] : "";
    if (rounds < 1 || argc < 4) {
        std::fprintf(stderr,
                     "usage: slicecast-bench SOURCES_FOLDER ROUNDS VIEW... | slowest SCENE... | "
                     "light SCENE... | overlays [NAME]\n");
        return 2;
    }
    const std::string& root = words[1];
    const std::vector<std::string> others(words.begin() + 4, words.end());
    if (what == "overlays")
        return slicecast::printOverlays(root, rounds, argc > 4 ? words[4] : "") ? 0 : 1;
    if (what == "light") return slicecast::printBakedLight(root, rounds, others) ? 0 : 1;
    if (what == "slowest") return slicecast::printSlowest(root, rounds, others) ? 0 : 1;
    return slicecast::run(root, rounds, {words.begin() + 3, words.end()});
}

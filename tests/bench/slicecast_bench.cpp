// Measures how fast fixed views are drawn, beside the limit kernel and a copy of the frame.
// Everything takes its turn round by round, so that whatever else the machine does falls on all
// alike; figures are medians over the rounds.
//
//     slicecast-bench ASSETS ROUNDS                    prints JSON for tools/bench
//     slicecast-bench ASSETS ROUNDS views TITLE...     the same of a few views: "castle, start"
//     slicecast-bench ASSETS ROUNDS overlays [NAME]    prints what each overlay takes, or one
//     slicecast-bench ASSETS ROUNDS light [SCENE]      prints what baked light takes
//     slicecast-bench ASSETS FRAMES shipped [SCENE...] prints what the starts of scenes take

#include "baked_light.h"
#include "limit_kernel.h"
#include "overlays.h"
#include "phases.h"
#include "processor_time.h"
#include "shipped.h"
#include "views.h"
#include "world/world_step.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// A picture, and memory for it.
struct Canvas {
    int width;
    int height;
    std::vector<Pixel> pixels = std::vector<Pixel>(static_cast<std::size_t>(width) * height);

    Picture picture() { return {pixels.data(), width, height, width}; }
    double nsPerPixel(double seconds) const { return seconds * 1e9 / pixels.size(); }
};

constexpr int kFrames = 2;      // of a view in a round
constexpr int kLargeEvery = 5;  // rounds: a large picture takes nine times as long as a usual one

// What draws, and how long it took by round.
struct Timed {
    Canvas& canvas;
    int frames;  // in a round
    std::function<void()> draw;
    std::vector<double> nsPerPixel = {};

    // The first frame brings its textures into the caches, as the frame before would have done in a
    // game.
    void measure(bool counts) {
        draw();
        const double begin = processorSeconds();
        for (int i = 0; i < frames; ++i) draw();
        if (counts) nsPerPixel.push_back(canvas.nsPerPixel(processorSeconds() - begin) / frames);
    }
};

struct MeasuredView {
    const View& view;
    Timed usual;
    Timed large;
    std::unique_ptr<PhasedFrame> phased;
    std::vector<Phases> phases = {};  // by round, seconds a frame

    void measurePhases(bool counts) {
        phased->draw(usual.canvas.picture());
        Phases sum;
        for (int i = 0; i < kFrames; ++i) sum += phased->draw(usual.canvas.picture());
        if (counts) phases.push_back(sum / kFrames);
    }
};

// Nothing, and the reason printed, if the view cannot be drawn or its phased frame is another
// picture.
std::optional<MeasuredView> prepare(const View& view, Canvas& usual, Canvas& large) {
    const auto draw = [&view](Canvas& canvas) {
        return view.session->draw(canvas.picture(), view.fraction);
    };
    const auto refuse = [&view](const char* why) -> std::optional<MeasuredView> {
        std::fprintf(stderr, "slicecast-bench: %s %s\n", view.title.c_str(), why);
        return std::nullopt;
    };
    if (!draw(usual)) return refuse("cannot be drawn");
    World world = view.session->world().copy();
    showBetween(world, view.fraction);

    auto phased = std::make_unique<PhasedFrame>(std::move(world), view.session->eye(view.fraction),
                                                view.session->options().render);
    std::vector<Pixel> drawn(usual.pixels.size());
    drawn.swap(usual.pixels);
    phased->draw(usual.picture());
    if (usual.pixels != drawn) return refuse("is another picture when drawn phase by phase");
    return MeasuredView{view, Timed{usual, kFrames, [draw, &usual] { draw(usual); }},
                        Timed{large, 1, [draw, &large] { draw(large); }}, std::move(phased)};
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

// The median of ofRound(0) to ofRound(rounds - 1).
template <typename OfRound>
double median(std::size_t rounds, OfRound&& ofRound) {
    std::vector<double> values;
    for (std::size_t i = 0; i < rounds; ++i) values.push_back(ofRound(i));
    return quantile(std::move(values), 0.5);
}

void printTimes(const Timed& timed, const Timed* to) {
    const double middle = quantile(timed.nsPerPixel, 0.5);
    const double spread =
        (quantile(timed.nsPerPixel, 0.75) - quantile(timed.nsPerPixel, 0.25)) / middle;
    std::printf("\"nsPerPixel\": %.4f, \"spread\": %.4f", middle, spread);
    if (to == nullptr) return;
    std::printf(", \"ratio\": %.4f", median(timed.nsPerPixel.size(), [&](std::size_t i) {
                    return timed.nsPerPixel[i] / to->nsPerPixel[i];
                }));
}

void printPhases(const MeasuredView& of, const Timed& limit) {
    const std::size_t rounds = of.phases.size();
    const auto nsPerPixel = [&](double Phases::*phase) {
        return of.usual.canvas.nsPerPixel(
            median(rounds, [&](std::size_t i) { return of.phases[i].*phase; }));
    };
    std::printf(
        ", \"walkShare\": %.4f, \"replay\": %.4f",
        median(rounds, [&](std::size_t i) { return of.phases[i].walk / of.phases[i].sum(); }),
        median(rounds, [&](std::size_t i) {
            return of.usual.canvas.nsPerPixel(of.phases[i].replay()) / limit.nsPerPixel[i];
        }));
    std::printf(
        ",\n      \"phases\": { \"setUp\": %.4f, \"walk\": %.4f, \"paint\": %.4f, \"copy\": %.4f }",
        nsPerPixel(&Phases::setUp), nsPerPixel(&Phases::walk), nsPerPixel(&Phases::paint),
        nsPerPixel(&Phases::copy));
}

int run(const std::string& assets, int rounds, const std::vector<std::string>& titles) {
    const std::optional<std::vector<View>> views = openViews(assets, titles);
    if (!views) return 1;
    Canvas usual{1280, 720};
    Canvas large{3840, 2160};
    std::vector<Pixel> copied(usual.pixels.size());
    LimitKernel usualKernel(usual.width, usual.height);
    LimitKernel largeKernel(large.width, large.height);

    Timed copy{usual, 8, [&] {
                   std::memcpy(copied.data(), usual.pixels.data(), copied.size() * sizeof(Pixel));
               }};
    Timed limit{usual, kFrames, [&] { usualKernel.draw(usual.pixels.data()); }};
    Timed largeLimit{large, 1, [&] { largeKernel.draw(large.pixels.data()); }};
    std::vector<MeasuredView> measured;
    for (const View& view : *views) {
        std::optional<MeasuredView> prepared = prepare(view, usual, large);
        if (!prepared) return 1;
        measured.push_back(std::move(*prepared));
    }

    // A few rounds do not count: engines of WebAssembly compile what runs often once more.
    const int warmUp = 5 + rounds / 10;
    for (int round = -warmUp; round < rounds; ++round) {
        const bool counts = round >= 0;
        const bool isLarge = round % kLargeEvery == 0;
        copy.measure(counts);
        limit.measure(counts);
        if (isLarge) largeLimit.measure(counts);
        for (MeasuredView& view : measured) {
            view.usual.measure(counts);
            view.measurePhases(counts);
            if (isLarge) view.large.measure(counts);
        }
    }

    std::printf("{ \"width\": %d, \"height\": %d, \"rounds\": %d,\n  \"copy\": { ", usual.width,
                usual.height, rounds);
    printTimes(copy, nullptr);
    std::printf(" },\n  \"limit\": { ");
    printTimes(limit, &copy);
    std::printf(",\n    \"large\": { \"width\": %d, \"height\": %d, ", large.width, large.height);
    printTimes(largeLimit, nullptr);
    std::printf(" } },\n  \"views\": [");
    for (const MeasuredView& of : measured) {
        std::printf("%s\n    { \"title\": \"%s\", ", &of == &measured.front() ? "" : ",",
                    of.view.title.c_str());
        printTimes(of.usual, &limit);
        printPhases(of, limit);
        std::printf(",\n      \"large\": { ");
        printTimes(of.large, &largeLimit);
        std::printf(" }");
        for (const MeasuredView& other : measured) {
            if (other.view.title != of.view.comparedWith) continue;
            std::printf(
                ",\n      \"comparedWith\": \"%s\", \"mostTimes\": %.2f, \"timesThat\": %.4f",
                other.view.title.c_str(), of.view.mostTimes,
                median(of.usual.nsPerPixel.size(), [&](std::size_t i) {
                    return of.usual.nsPerPixel[i] / other.usual.nsPerPixel[i];
                }));
        }
        std::printf(" }");
    }
    std::printf("\n  ] }\n");
    return 0;
}

}  // namespace
}  // namespace slicecast

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv, argv + argc);
    const std::string what = argc > 3 ? words[3] : "";
    const int rounds = argc >= 3 ? std::atoi(argv[2]) : 0;
    const bool isUnderstood = argc <= 3 || (what == "views" && argc > 4) || what == "shipped" ||
                              ((what == "overlays" || what == "light") && argc <= 5);
    if (rounds < 1 || !isUnderstood) {
        std::fprintf(stderr,
                     "usage: slicecast-bench ASSETS_FOLDER ROUNDS [views TITLE... | overlays "
                     "[NAME] | light [SCENE] | shipped [SCENE...]]\n");
        return 2;
    }
    if (what == "overlays")
        return slicecast::printOverlays(words[1], rounds, argc == 5 ? words[4] : "") ? 0 : 1;
    if (what == "light")
        return slicecast::printBakedLight(words[1], rounds, argc == 5 ? words[4] : "") ? 0 : 1;
    const std::vector<std::string> titles(words.begin() + std::min(argc, 4), words.end());
    if (what == "shipped") return slicecast::printShipped(words[1], rounds, titles) ? 0 : 1;
    return slicecast::run(words[1], rounds, titles);
}

#include "overlays.h"

#include "base/hash.h"
#include "canvas.h"
#include "views.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

constexpr std::array kScenes = {"harbour-town", "castle", "water-palace", "library"};

struct Case {
    const char* name;
    std::vector<std::pair<const char*, const char*>> options;
};

const std::vector<Case> kCases = {
    {"minimap", {{"minimap", "on"}}},
    {"minimap, all of it",
     {{"minimap", "on"}, {"minimapRays", "on"}, {"minimapTurns", "on"}, {"minimapReach", "6"}}},
    {"player panel", {{"playerPanel", "on"}}},
    {"process panel", {{"processPanel", "on"}}},
    {"inspector", {{"inspector", "on"}}},
    {"grid", {{"grid", "on"}}},
    {"slow drawing", {{"slow", "on"}}},
    {"half the columns", {{"drawnColumns", "640"}}},
    {"all",
     {{"minimap", "on"},
      {"playerPanel", "on"},
      {"processPanel", "on"},
      {"inspector", "on"},
      {"grid", "on"}}},
};

// A session with a clock that tells it nothing, and notes down how long the view and the overlays
// of each picture have taken.
struct Walk {
    std::unique_ptr<Session> session;
    std::vector<double> readings;
    std::vector<double> view;
    std::vector<double> overlays;
    Hash hash;

    Walk(std::unique_ptr<Session> opened, const Case& each) : session(std::move(opened)) {
        for (const auto& [name, value] : each.options) {
            const std::string fault = session->setOption(name, value);
            if (!fault.empty()) std::fprintf(stderr, "%s\n", fault.c_str());
        }
        session->setClock([this] {
            readings.push_back(processorSeconds());
            return 0.0;
        });
    }

    void draw(const Picture& picture, bool counts) {
        session->step({.forward = 0.3, .turn = 0.4});
        readings.clear();
        session->draw(picture);
        if (!counts || readings.size() != 3) return;
        view.push_back((readings[1] - readings[0]) * 1e3);
        overlays.push_back((readings[2] - readings[1]) * 1e3);
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; x += 2)
                hash.add(static_cast<std::int64_t>(std::uint64_t{picture.row(y)[x]} << 32 |
                                                   picture.row(y)[x + 1]));
        }
    }
};

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace

bool printOverlays(const std::string& root, int frames, const std::string& only) {
    Canvas canvas;
    const int warmUp = 5 + frames / 10;
    for (const char* scene : kScenes) {
        for (const Case& each : kCases) {
            if (!only.empty() && only != each.name) continue;
            std::unique_ptr<Session> session = openScene(root, scene);
            if (!session) return false;
            Walk walk(std::move(session), each);
            for (int i = -warmUp; i < frames; ++i) walk.draw(canvas.picture(), i >= 0);
            const double most = *std::max_element(walk.overlays.begin(), walk.overlays.end());
            const double overlay = median(walk.overlays);
            const double view = median(walk.view);
            std::printf("%-13s %-19s %7.3f ms  most %7.3f  view %6.2f  ratio %5.2f  %016llx\n",
                        scene, each.name, overlay, most, view, overlay / view,
                        static_cast<unsigned long long>(walk.hash.value()));
        }
    }
    return true;
}

}  // namespace slicecast

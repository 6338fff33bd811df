// Measures how fast fixed views of shipped scenes are drawn, beside the limit kernel and a copy of
// the frame. Everything takes its turn round by round, so that whatever else the machine does falls
// on all alike; figures are medians over the rounds.
//
//     slicecast-bench ASSETS ROUNDS                    prints JSON for tools/bench
//     slicecast-bench ASSETS ROUNDS overlays [NAME]    prints what each overlay takes, or one

#include "headless/scene_file.h"
#include "limit_kernel.h"
#include "many_objects.h"
#include "overlays.h"
#include "processor_time.h"
#include "session/session.h"
#include "walk_alone.h"

#include <algorithm>
#include <array>
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

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr int kManyObjects = 10'000;
constexpr int kObjectsSeen = 100;
constexpr double kPixels = static_cast<double>(kWidth) * kHeight;

// An eye in the map in which the scene starts, or in another one of it; without one, the start
// itself.
struct Place {
    double x, y, z, headingDegrees, look;
    const char* map = nullptr;
};
struct View {
    const char* scene;
    const char* name;
    std::optional<Place> place;
    int steps = 0;  // played first; then what moves is drawn half way between two steps
};

const std::array kViews = {
    View{"harbour-town", "start", {}},
    View{"harbour-town", "over the roofs", Place{24.0, 24.0, 6.5, 225.0, -0.3}},
    View{"castle", "start", {}},
    View{"castle", "from above", Place{44.6, 33.4, 5.5, 215.0, -0.2}},
    View{"library", "start", {}},
    View{"library", "in the gallery", Place{12.0, 10.0, 2.5, 100.0, -0.1}},
    View{"garden", "start", {}},
    View{"garden", "between hedges", Place{16.0, 16.0, 0.5, 250.0, 0.0}},
    View{"glassworks", "start", {}},    // see-through, animated and glowing faces, objects
    View{"water-palace", "start", {}},  // the floor is a mirror
    View{"water-palace", "hall", Place{13.6, 15.9, 1.5, 325.0, -0.1}},
    View{"castle", "before the gate", Place{28.5, 19.0, 3.5, 180.0, 0.02}},
    View{"library", "under the lift", Place{14.5, 27.2, 0.5, 240.0, 0.1}, 720},
    View{"wayhouse", "four doors", {}},
    View{"wayhouse", "endless corridor", Place{4.5, 2.0, 0.5, 0.0, 0.0, "corridor"}},
};

// One of the things that take turns.
struct Item {
    std::string scene;  // empty for the limit and the copy
    std::string name;
    int frames;  // per round and measurement
    std::function<void()> draw;
    std::vector<double> nsPerPixel = {};  // by round
    int comparedWith = -1;                // another item, which it should not be much slower than
    int walk = -1;                        // another item: its walk alone
};

// The first frame brings its textures into the caches, as the frame before would have done in a
// game.
double measure(const Item& item) {
    item.draw();
    const double begin = processorSeconds();
    for (int i = 0; i < item.frames; ++i) item.draw();
    return (processorSeconds() - begin) / item.frames * 1e9 / kPixels;
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

// Median of the ratios of two things in the same round.
double ratio(const std::vector<double>& of, const std::vector<double>& to) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < of.size(); ++i) ratios.push_back(of[i] / to[i]);
    return quantile(ratios, 0.5);
}

std::unique_ptr<Session> openScene(const std::string& assets, const View& view) {
    SceneFromFile scene = readScene(assets + "/scenes/" + view.scene + ".json");
    for (const Fault& fault : scene.faults) std::fprintf(stderr, "%s\n", describe(fault).c_str());
    if (!scene.world) return nullptr;
    auto session = std::make_unique<Session>(std::move(*scene.world));
    if (view.place) {
        const Place& p = *view.place;
        int map = session->player().map;
        const std::vector<Map>& maps = session->world().maps;
        for (std::size_t i = 0; p.map != nullptr && i < maps.size(); ++i) {
            if (maps[i].name == p.map) map = static_cast<int>(i);
        }
        if (!session->setEye({map, toCoordinate(p.x), toCoordinate(p.y), toCoordinate(p.z),
                              p.headingDegrees, p.look}))
            return nullptr;
    }
    return session;
}

// The garden with many objects, and with those of them alone that are seen.
bool addManyObjects(const std::string& assets, const Picture& picture, std::vector<Item>& items) {
    SceneFromFile scene = readScene(assets + "/scenes/garden.json");
    if (!scene.world) return false;
    const Eye eye = Session(*scene.world).eye();
    std::optional<ManyObjects> many = spreadObjects(*scene.world, eye, kManyObjects, kObjectsSeen);
    if (!many) return false;
    const auto alone = std::make_shared<Session>(std::move(many->seenOnly));
    const auto all = std::make_shared<Session>(std::move(many->all));
    items.push_back({"garden", "100 objects", 2, [alone, picture] { alone->draw(picture); }});
    items.push_back(
        {"garden", "10,000 objects, 100 seen", 2, [all, picture] { all->draw(picture); }});
    items.back().comparedWith = static_cast<int>(items.size()) - 2;
    return true;
}

// `items` are all, of which the second is the limit.
void printFigures(const Item& item, const std::vector<Item>& items, const char* end) {
    const double median = quantile(item.nsPerPixel, 0.5);
    const double spread =
        (quantile(item.nsPerPixel, 0.75) - quantile(item.nsPerPixel, 0.25)) / median;
    std::printf("{ \"scene\": \"%s\", \"name\": \"%s\", \"nsPerPixel\": %.4f, \"spread\": %.4f",
                item.scene.c_str(), item.name.c_str(), median, spread);
    const std::vector<double>& limit = items[1].nsPerPixel;
    if (&item != &items[0]) {
        const Item& other = items[&item == &items[1] ? 0 : 1];
        std::printf(", \"ratio\": %.4f", ratio(item.nsPerPixel, other.nsPerPixel));
    }
    if (item.comparedWith >= 0) {
        const Item& compared = items[static_cast<std::size_t>(item.comparedWith)];
        std::printf(", \"comparedWith\": \"%s\", \"timesThat\": %.4f", compared.name.c_str(),
                    ratio(item.nsPerPixel, compared.nsPerPixel));
    }
    if (item.walk >= 0) {
        const double walk =
            ratio(items[static_cast<std::size_t>(item.walk)].nsPerPixel, item.nsPerPixel);
        std::printf(", \"walkShare\": %.4f, \"painting\": %.4f", walk,
                    (1.0 - walk) * ratio(item.nsPerPixel, limit));
    }
    std::printf(" }%s\n", end);
}

int run(const std::string& assets, int rounds) {
    std::vector<Pixel> frame(static_cast<std::size_t>(kWidth) * kHeight);
    std::vector<Pixel> copy(frame.size());
    const Picture picture = {frame.data(), kWidth, kHeight, kWidth};
    LimitKernel limit(kWidth, kHeight);

    std::vector<Item> items;
    items.push_back({"", "copy", 8, [&] {
                         std::memcpy(copy.data(), frame.data(), frame.size() * sizeof(Pixel));
                     }});
    items.push_back({"", "limit", 2, [&] { limit.draw(frame.data()); }});
    for (const View& view : kViews) {
        const std::shared_ptr<Session> session = openScene(assets, view);
        for (int step = 0; session && step < view.steps; ++step) session->step({});
        if (!session || !session->draw(picture)) {
            std::fprintf(stderr, "slicecast-bench: %s, %s cannot be drawn\n", view.scene,
                         view.name);
            return 1;
        }
        items.push_back(
            {view.scene, view.name, 2, [session, picture, fraction = view.steps > 0 ? 0.5 : 1.0] {
                 session->draw(picture, fraction);
             }});
        const auto walk = std::make_shared<WalkAlone>(session->world(), session->eye(),
                                                      session->options().render);
        items.back().walk = static_cast<int>(items.size());
        items.push_back({"", "walk", 2, [session, walk] { walk->walk(kWidth, kHeight); }});
    }
    if (!addManyObjects(assets, picture, items)) {
        std::fprintf(stderr, "slicecast-bench: there is no room for many objects in the garden\n");
        return 1;
    }

    // A few rounds do not count: engines of WebAssembly compile what runs often once more.
    const int warmUp = 5 + rounds / 10;
    for (int round = -warmUp; round < rounds; ++round) {
        for (Item& item : items) {
            const double nsPerPixel = measure(item);
            if (round >= 0) item.nsPerPixel.push_back(nsPerPixel);
        }
    }

    std::printf("{ \"width\": %d, \"height\": %d, \"rounds\": %d,\n  \"copy\": ", kWidth, kHeight,
                rounds);
    printFigures(items[0], items, ",");
    std::printf("  \"limit\": ");
    printFigures(items[1], items, ",");
    std::printf("  \"views\": [\n");
    for (std::size_t i = 2; i < items.size(); ++i) {
        if (items[i].scene.empty()) continue;
        std::printf("    ");
        printFigures(items[i], items, i + 1 < items.size() ? "," : "");
    }
    std::printf("  ] }\n");
    return 0;
}

}  // namespace
}  // namespace slicecast

int main(int argc, char** argv) {
    const int rounds = argc >= 3 && argc <= 5 ? std::atoi(argv[2]) : 0;
    if (rounds < 1) {
        std::fprintf(stderr, "usage: slicecast-bench ASSETS_FOLDER ROUNDS [overlays [NAME]]\n");
        return 2;
    }
    if (argc > 3)
        return slicecast::printOverlays(argv[1], rounds, argc == 5 ? argv[4] : "") ? 0 : 1;
    return slicecast::run(argv[1], rounds);
}

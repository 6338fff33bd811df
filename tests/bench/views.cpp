#include "views.h"

#include "files/scene_file.h"
#include "many_objects.h"
#include "wide_land.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace slicecast {
namespace {

// An eye in the map in which the scene starts, or in another one of it; without one, the start
// itself.
struct Place {
    double x, y, z, headingDegrees, look;
    const char* map = nullptr;
};
struct Described {
    const char* scene;
    const char* name;
    std::optional<Place> place;
    int steps = 0;  // played first; then what moves is drawn half way between two steps
};

const std::array kViews = {
    Described{"harbour-town", "start", {}},
    Described{"harbour-town", "over the roofs", Place{24.0, 24.0, 6.5, 225.0, -0.3}},
    Described{"castle", "start", {}},
    Described{"castle", "from above", Place{44.6, 33.4, 5.5, 215.0, -0.2}},
    Described{"library", "start", {}},
    Described{"library", "in the gallery", Place{12.0, 10.0, 2.5, 100.0, -0.1}},
    Described{"garden", "start", {}},
    Described{"garden", "between hedges", Place{16.0, 16.0, 0.5, 250.0, 0.0}},
    Described{"glassworks", "start", {}},    // see-through, animated and glowing faces, objects
    Described{"water-palace", "start", {}},  // the floor is a mirror
    Described{"water-palace", "hall", Place{13.6, 15.9, 1.5, 325.0, -0.1}},
    Described{"castle", "before the gate", Place{28.5, 19.0, 3.5, 180.0, 0.02}},
    Described{"library", "under the lift", Place{14.5, 27.2, 0.5, 240.0, 0.1}, 720},
    Described{"wayhouse", "four doors", {}},
    Described{"wayhouse", "endless corridor", Place{4.5, 2.0, 0.5, 0.0, 0.0, "corridor"}},
    // What a raycaster of 8 bits can draw, so that others can be compared on equal terms.
    Described{"yardstick", "flat hall", Place{2.5, 12.0, 0.5, 10.0, 0.0, "flat"}},
    Described{"yardstick", "hall of heights", Place{2.0, 2.0, 0.9, 40.0, -0.2, "heights"}},
};

constexpr const char* kFewTitle = "garden, 100 objects";
constexpr const char* kManyTitle = "garden, 10,000 objects, 100 seen";
constexpr int kManyObjects = 10'000;
constexpr int kObjectsSeen = 100;
// The objects that are not seen are looked at once a frame.
constexpr double kMostTimesTheSeen = 1.5;

constexpr const char* kSmallLandTitle = "stones on 64 x 64 tiles";
constexpr const char* kWideLandTitle = "stones on 2048 x 2048 tiles";
constexpr double kMostTimesTheSmall = 1.15;

std::string titleOf(const Described& view) {
    return std::string(view.scene) + ", " + view.name;
}

std::unique_ptr<Session> openScene(const std::string& assets, const Described& view) {
    LoadedScene scene = readSceneFile(assets + "/scenes/" + view.scene + ".json");
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
    for (int step = 0; step < view.steps; ++step) session->step({});
    return session;
}

// Adds two views of the garden: with many objects, and with only those of them that are seen.
bool addManyObjects(const std::string& assets, std::vector<View>& views) {
    LoadedScene scene = readSceneFile(assets + "/scenes/garden.json");
    if (!scene.world) return false;
    const Eye eye = Session(scene.world->copy()).eye();
    std::optional<ManyObjects> many = spreadObjects(*scene.world, eye, kManyObjects, kObjectsSeen);
    if (!many) {
        std::fprintf(stderr, "slicecast-bench: there is no room for many objects in the garden\n");
        return false;
    }
    views.push_back({kFewTitle, std::make_shared<Session>(std::move(many->seenOnly))});
    views.push_back({kManyTitle, std::make_shared<Session>(std::move(many->all)), 1.0, kFewTitle,
                     kMostTimesTheSeen});
    return true;
}

// The same stones in a small and in a large map; the floor beyond the small one looks as it does in
// the large one.
bool addLands(const std::string& assets, std::vector<View>& views) {
    const LoadedScene scene = readSceneFile(assets + "/scenes/yardstick.json");
    if (!scene.world) return false;
    views.push_back(
        {kSmallLandTitle, std::make_shared<Session>(stonesOnLand(scene.world->copy(), 64))});
    views.push_back({kWideLandTitle,
                     std::make_shared<Session>(stonesOnLand(scene.world->copy(), 2048)), 1.0,
                     kSmallLandTitle, kMostTimesTheSmall});
    return true;
}

}  // namespace

std::optional<std::vector<View>> openViews(const std::string& assets,
                                           const std::vector<std::string>& titles) {
    std::vector<std::string> unknown = titles;
    const auto isWanted = [&](const std::string& title) {
        std::erase(unknown, title);
        return titles.empty() || std::find(titles.begin(), titles.end(), title) != titles.end();
    };
    std::vector<View> views;
    for (const Described& view : kViews) {
        if (!isWanted(titleOf(view))) continue;
        std::shared_ptr<Session> session = openScene(assets, view);
        if (!session) {
            std::fprintf(stderr, "slicecast-bench: %s cannot be drawn\n", titleOf(view).c_str());
            return std::nullopt;
        }
        views.push_back({titleOf(view), std::move(session), view.steps > 0 ? 0.5 : 1.0});
    }
    const bool wantsFew = isWanted(kFewTitle);
    const bool wantsMany = isWanted(kManyTitle);
    if ((wantsFew || wantsMany) && !addManyObjects(assets, views)) return std::nullopt;
    const bool wantsSmall = isWanted(kSmallLandTitle);
    const bool wantsWide = isWanted(kWideLandTitle);
    if ((wantsSmall || wantsWide) && !addLands(assets, views)) return std::nullopt;
    for (const std::string& title : unknown)
        std::fprintf(stderr, "slicecast-bench: there is no view \"%s\"\n", title.c_str());
    if (!unknown.empty()) return std::nullopt;
    return views;
}

}  // namespace slicecast

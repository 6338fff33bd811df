#include "views.h"

#include "files/recording_file.h"
#include "files/scene_file.h"
#include "many_objects.h"
#include "wide_land.h"
#include "world/time_step.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>

namespace slicecast {
namespace {

constexpr int kManyObjects = 10'000;
constexpr int kObjectsSeen = 100;

World withObjects(const World& world, World ManyObjects::*which) {
    const Eye eye = Session(world.copy()).eye();
    std::optional<ManyObjects> many = spreadObjects(world, eye, kManyObjects, kObjectsSeen);
    if (!many) std::fprintf(stderr, "slicecast-bench: there is no room for many objects\n");
    return many ? std::move((*many).*which) : World{};
}

struct Made {
    const char* name;
    const char* scene;  // of the frozen set, from which it is made
    World (*make)(World);
    std::optional<Eye> eye = {};
};

World asItIs(World world) {
    return world;
}

// What raycasters of 8 bits can draw, so that others can be compared on equal terms; many objects,
// and those of them alone that are seen; the same stones in a wide and in a small land. The floor
// beyond the small one looks as it does in the wide one.
const std::array kMade = {
    Made{"flat hall", "yardstick", asItIs,
         Eye{0, toCoordinate(2.5), toCoordinate(12.0), toCoordinate(0.5), 10.0, 0.0}},
    Made{"hall of heights", "yardstick", asItIs,
         Eye{1, toCoordinate(2.0), toCoordinate(2.0), toCoordinate(0.9), 40.0, -0.2}},
    Made{"100 objects", "garden",
         [](World world) { return withObjects(world, &ManyObjects::seenOnly); }},
    Made{"10,000 objects, 100 seen", "garden",
         [](World world) { return withObjects(world, &ManyObjects::all); }},
    Made{"stones on 64 x 64 tiles", "yardstick",
         [](World world) { return stonesOnLand(std::move(world), 64); }},
    Made{"stones on 2048 x 2048 tiles", "yardstick",
         [](World world) { return stonesOnLand(std::move(world), 2048); }},
};

std::unique_ptr<Session> openMade(const std::string& root, const Made& made) {
    LoadedScene scene = readSceneFile(root + "/tests/frozen/scenes/" + made.scene + ".json");
    World world = scene.world ? made.make(std::move(*scene.world)) : World{};
    if (world.maps.empty()) return nullptr;
    auto session = std::make_unique<Session>(std::move(world));
    if (made.eye && !session->setEye(*made.eye)) return nullptr;
    return session;
}

}  // namespace

std::unique_ptr<Session> openScene(const std::string& root, const std::string& name) {
    LoadedScene scene = readSceneFile(root + "/assets/scenes/" + name + ".json");
    for (const Fault& fault : scene.faults) std::fprintf(stderr, "%s\n", describe(fault).c_str());
    return scene.world ? std::make_unique<Session>(std::move(*scene.world)) : nullptr;
}

std::optional<Replay> openTour(const std::string& root, const std::string& scene) {
    ReadRecording tour = readRecordingFile(root + "/assets/tours/" + scene + ".txt");
    for (const Fault& fault : tour.faults) std::fprintf(stderr, "%s\n", describe(fault).c_str());
    if (!tour.recording) return std::nullopt;
    return std::optional<Replay>(std::in_place, std::move(*tour.recording));
}

std::unique_ptr<Session> openView(const std::string& root, const std::string& name) {
    for (const Made& made : kMade) {
        if (name == made.name) return openMade(root, made);
    }
    const std::size_t at = name.find('@');
    std::unique_ptr<Session> session = openScene(root, name.substr(0, at));
    if (!session) return nullptr;
    if (at == std::string::npos) {
        for (int step = 0; step < kStepsPerSecond; ++step) session->step({});
        return session;
    }
    std::optional<Replay> tour = openTour(root, name.substr(0, at));
    const std::int64_t steps = std::atoll(name.c_str() + at + 1);
    while (tour && tour->stepsDone() < steps) {
        if (!tour->step(*session)) {
            std::fprintf(stderr, "slicecast-bench: %s: the tour is over earlier\n", name.c_str());
            return nullptr;
        }
    }
    return tour ? std::move(session) : nullptr;
}

}  // namespace slicecast

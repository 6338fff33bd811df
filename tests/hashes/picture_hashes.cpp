// Prints one line per view: its name and the hash of its picture, and one line per stretch of a
// run: its name and a fingerprint of the state. Of the recorded tours it prints both at each mark.
// Builds by different compilers must print the same.
//
//     picture-hashes FOLDER        of the frozen set, tests/frozen

#include "base/angle.h"
#include "base/random.h"
#include "files/recording_file.h"
#include "files/scene_file.h"
#include "generated_world.h"
#include "session/recording_text.h"
#include "session/session.h"

#include <algorithm>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

// 64-bit FNV-1a.
std::uint64_t hashOf(const void* bytes, std::size_t count) {
    const auto* at = static_cast<const unsigned char*>(bytes);
    std::uint64_t hash = 14695981039346656037u;
    for (std::size_t i = 0; i < count; ++i) hash = (hash ^ at[i]) * 1099511628211u;
    return hash;
}

void printLine(const std::string& name, std::uint64_t hash) {
    std::printf("%s %016" PRIx64 "\n", name.c_str(), hash);
}

void printAngles() {
    static double sines[3600];
    for (int i = 0; i < 3600; ++i) sines[i] = sinDegrees(i * 0.1) + atanDegrees(i * 0.01);
    printLine("angles", hashOf(sines, sizeof sines));
}

// A picture that the renderer refuses has no hash; that it does so must be the same everywhere too.
template <typename Draw>
void printPicture(const std::string& name, int width, int height, Draw&& draw) {
    Image image(width, height);
    const bool drawn = draw(Picture{image.pixels.data(), width, height, width});
    printLine(name + (drawn ? "" : " refused"),
              hashOf(image.pixels.data(), image.pixels.size() * sizeof(Pixel)));
}

Input anyInput(Random& random) {
    Input input;
    input.forward = random.oneIn(4) ? 0.0 : random.between(-0.5, 1.5);
    input.strafe = random.oneIn(2) ? 0.0 : random.between(-1.0, 1.0);
    input.turn = random.oneIn(2) ? 0.0 : random.between(-1.0, 1.0);
    input.look = random.oneIn(3) ? random.between(-1.0, 1.0) : 0.0;
    input.fly = random.oneIn(2) ? random.between(-1.0, 1.0) : 0.0;
    input.turnDegrees = random.oneIn(6) ? random.between(-3.0, 3.0) : 0.0;
    input.lookHeights = random.oneIn(6) ? random.between(-0.02, 0.02) : 0.0;
    input.jump = random.oneIn(4);
    input.fast = random.oneIn(4);
    input.slow = random.oneIn(8);
    return input;
}

// Somebody presses keys at random, now walking, now flying.
void printRun(const std::string& name, Session& session, std::uint64_t seed, int steps) {
    constexpr int kStepsOfAnInput = 24;
    constexpr int kStepsOfALine = 1000;
    Random random(seed);
    Input input;
    session.reset();
    for (int step = 0; step < steps; ++step) {
        if (step % kStepsOfAnInput == 0) {
            input = anyInput(random);
            if (random.oneIn(20)) session.setFlying(!session.player().flying);
        }
        session.step(input);
        if ((step + 1) % kStepsOfALine == 0)
            printLine(name + " after " + std::to_string(step + 1) + " steps",
                      session.fingerprint());
    }
    printPicture(name + " where it ends", 320, 200,
                 [&](const Picture& picture) { return session.draw(picture, 0.5); });
}

// Somewhere over the map, mostly at the height of a person.
Eye anyEye(Random& random, const World& world, int map) {
    const Map& m = world.maps[static_cast<std::size_t>(map)];
    Eye eye;
    eye.map = map;
    eye.x = {random.between(0, m.width * 65536 - 1)};
    eye.y = {random.between(0, m.depth * 65536 - 1)};
    eye.z = {random.oneIn(2) ? 32768 : random.between(1, (m.levels + 2) * 65536)};
    eye.headingDegrees = random.between(0.0, 360.0);
    eye.look = random.oneIn(3) ? random.between(-1.0, 1.0) : 0.0;
    return eye;
}

// One picture of each old way of drawing, and one of several.
void printOldWays(const std::string& name, Session& session) {
    const std::vector<std::vector<std::pair<const char*, const char*>>> ways = {
        {},
        {{"classic.march", "on"}},
        {{"classic.march", "on"}, {"classic.step", "0.3"}, {"classic.reach", "60"}},
        {{"classic.projection", "equalAngles"}},
        {{"classic.projection", "equalAnglesCorrected"}, {"classic.sineSteps", "3600"}},
        {{"classic.stretched", "on"}, {"classic.painter", "on"}},
        {{"classic.oneLevel", "on"}, {"classic.pixelSize", "3"}, {"textures", "off"}},
        {{"classic.mirroredTextures", "on"}, {"classic.roofs", "flat"}, {"classic.seams", "on"}},
        {{"classic.firstHits", "on"}, {"classic.noOwnCell", "on"}, {"classic.roofs", "missing"}},
        {{"classic.columnDepth", "on"}, {"classic.driftingHorizon", "on"}},
        {{"classic.wrongScale", "on"}, {"classic.flippedMirrors", "on"}},
        {{"classic.portalsOverdrawn", "on"}, {"compare", "0.6"}},
    };
    session.reset();
    session.setOption("method", "classic");
    for (std::size_t i = 0; i < ways.size(); ++i) {
        for (const auto& [option, value] : ways[i]) session.setOption(option, value);
        printPicture(name + " old way " + std::to_string(i), 160, 100,
                     [&](const Picture& picture) { return session.draw(picture); });
        for (const auto& [option, value] : ways[i])
            session.setOption(option, optionValue({}, option));
    }
    session.setOption("method", "exact");
}

bool printScene(const std::filesystem::path& path, std::uint64_t seed) {
    LoadedScene scene = readSceneFile(path.string());
    for (const Fault& fault : scene.faults) std::fprintf(stderr, "%s\n", describe(fault).c_str());
    if (!scene.world) return false;
    Session session(std::move(*scene.world));
    const std::string name = path.stem().string();
    const auto print = [&](const std::string& view, int width, int height) {
        printPicture(name + " " + view, width, height,
                     [&](const Picture& picture) { return session.draw(picture); });
    };
    print("start", 1280, 720);
    print("start small", 320, 200);
    session.setOption("smooth", "on");
    print("start smooth", 640, 400);
    session.setOption("smooth", "off");
    Random random(seed);
    for (int map = 0; map < static_cast<int>(session.world().maps.size()); ++map) {
        for (int i = 0; i < 5; ++i) {
            session.setEye(anyEye(random, session.world(), map));
            print("map " + std::to_string(map) + " eye " + std::to_string(i), 320, 200);
        }
    }
    session.setOption("minimap", "on");
    print("minimap", 320, 200);
    session.setOption("minimap", "off");
    printOldWays(name, session);
    printRun(name + " run", session, seed, 4000);
    return true;
}

// What generated views show, all together.
struct Shown {
    int portals = 0;
    std::int64_t mirroredRows = 0;
    std::int64_t layers = 0;
    std::int64_t objectSlices = 0;

    void add(const FrameReport& report) {
        portals = std::max(portals, report.deepestPortal);
        mirroredRows += report.mirroredRows;
        layers += report.layers;
        objectSlices += report.objectSlices;
    }
    bool isEverything() const {
        return portals > 4 && mirroredRows > 100'000 && layers > 100'000 && objectSlices > 1000;
    }
};

void printGenerated(std::uint64_t seed, Shown& shown) {
    constexpr int kViews = 4;
    // "lit" as in generatedWorld
    const std::string name = "generated " + std::to_string(seed) + (seed % 6 >= 3 ? " lit" : "");
    Renderer renderer;
    World world = generatedWorld(seed);
    for (std::uint64_t i = 0; i < kViews; ++i) {
        const GeneratedView view = generatedView(world, seed * kViews + i);
        world.steps = 44 * static_cast<std::int64_t>(i);
        printPicture(name + " view " + std::to_string(i), view.width, view.height,
                     [&](const Picture& picture) {
                         return renderer.draw(world, view.eye, view.options, picture);
                     });
        shown.add(renderer.report());
    }
    // The first one once more, with smooth textures
    GeneratedView view = generatedView(world, seed * kViews);
    view.options.smooth = true;
    view.options.textures = true;
    printPicture(name + " smooth", view.width, view.height, [&](const Picture& picture) {
        return renderer.draw(world, view.eye, view.options, picture);
    });
    if (seed % 6 < 2) {
        Session session(std::move(world));
        printOldWays(name, session);
        printRun(name + " run", session, seed, 2000);
    }
}

// A recorded tour: the state and the picture at each of its marks and at its end.
bool printTour(const std::filesystem::path& assets, const std::filesystem::path& path) {
    ReadRecording read = readRecordingFile(path);
    for (const Fault& fault : read.faults) std::fprintf(stderr, "%s\n", describe(fault).c_str());
    if (!read.recording) return false;
    LoadedScene scene =
        readSceneFile((assets / "scenes" / (read.recording->scene + ".json")).string());
    for (const Fault& fault : scene.faults) std::fprintf(stderr, "%s\n", describe(fault).c_str());
    if (!scene.world) return false;

    Session session(std::move(*scene.world));
    Replay replay(std::move(*read.recording));
    const auto print = [&](const std::string& mark) {
        const std::string name = "tour " + path.stem().string() + " " + mark;
        printLine(name + " after " + std::to_string(replay.stepsDone()) + " steps",
                  session.fingerprint());
        printPicture(name, 320, 200,
                     [&](const Picture& picture) { return session.draw(picture, 0.5); });
    };
    for (std::size_t passed = 0; replay.step(session);) {
        for (; passed < replay.marks().size(); ++passed) print(replay.marks()[passed].name);
    }
    print("end");
    return true;
}

// The files of a folder with that ending, in the order of their names. index.json is the list of
// the scenes.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder,
                                           const char* ending) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (entry.path().extension() == ending && entry.path().filename() != "index.json")
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

int printAll(const std::filesystem::path& assets) {
    printAngles();
    const std::vector<std::filesystem::path> scenes = filesIn(assets / "scenes", ".json");
    if (scenes.empty()) {
        std::fprintf(stderr, "picture-hashes: there are no scenes in %s\n",
                     (assets / "scenes").string().c_str());
        return 1;
    }
    std::uint64_t seed = 1;
    for (const std::filesystem::path& scene : scenes) {
        if (!printScene(scene, seed++)) return 1;
    }
    for (const std::filesystem::path& tour : filesIn(assets / "tours", ".txt")) {
        if (!printTour(assets, tour)) return 1;
    }
    constexpr std::uint64_t kWorlds = 96;
    Shown shown;
    for (std::uint64_t i = 0; i < kWorlds; ++i) printGenerated(i, shown);
    // Only odd ones have blocks that move
    for (std::uint64_t i = kFirstWithRamps; i < kFirstWithRamps + 24; i += 2)
        printGenerated(i, shown);
    if (!shown.isEverything()) {
        std::fprintf(stderr,
                     "picture-hashes: generated views show too little: %d portals deep, %" PRId64
                     " mirrored rows, %" PRId64 " see-through runs, %" PRId64
                     " slices of objects\n",
                     shown.portals, shown.mirroredRows, shown.layers, shown.objectSlices);
        return 1;
    }
    return 0;
}

}  // namespace
}  // namespace slicecast

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr,
                     "usage: picture-hashes FOLDER        of the frozen set, tests/frozen\n");
        return 2;
    }
    return slicecast::printAll(argv[1]);
}

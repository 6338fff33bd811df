// The program in a window: plays a scene until the window is closed. In a page src/wasm starts it.

#ifndef __EMSCRIPTEN__

#include "app/arguments.h"
#include "app/find_scene.h"
#include "app/thread_crew.h"
#include "app/window_shell.h"
#include "files/recording_file.h"
#include "files/scene_file.h"
#include "files/write_file.h"

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

using namespace slicecast;

namespace {

// A game of that scene, drawn by the crew. Prints all faults; null if the scene cannot be played.
std::unique_ptr<Session> openGame(const std::filesystem::path& scene, Crew& crew) {
    LoadedScene loaded = readSceneFile(scene);
    for (const Fault& fault : loaded.faults) std::fprintf(stderr, "%s\n", describe(fault).c_str());
    for (const Fault& warning : loaded.warnings)
        std::fprintf(stderr, "warning: %s\n", describe(warning).c_str());
    if (!loaded.world) return nullptr;
    auto game = std::make_unique<Session>(std::move(*loaded.world));
    game->renderer().setCrew(&crew);
    return game;
}

// Empty on success, else an error message.
std::string applyArguments(Session& game, const Arguments& arguments) {
    for (const auto& [name, value] : arguments.options) {
        std::string fault = game.setOption(name, value);
        if (!fault.empty()) return fault;
    }
    if (arguments.map.empty()) return {};
    std::string names;
    const std::vector<Map>& maps = game.world().maps;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        names += (i > 0 ? ", \"" : "\"") + maps[i].name + '"';
        if (maps[i].name != arguments.map) continue;
        const Eye eye = {static_cast<int>(i), toCoordinate(0.5 * maps[i].width),
                         toCoordinate(0.5 * maps[i].depth), toCoordinate(maps[i].levels + 0.5)};
        return game.setEye(eye) ? std::string()
                                : "the game cannot start in the map \"" + arguments.map + '"';
    }
    return "there is no map \"" + arguments.map + "\"; expected " + names;
}

std::string windowTitle(const Session& game) {
    return game.world().title.empty() ? "Slicecast" : game.world().title;
}

int fail(const std::string& fault) {
    std::fprintf(stderr, "slicecast: %s\n", fault.c_str());
    return 1;
}

// The recording to replay. Prints all faults; empty if there are any.
std::optional<Recording> openRecording(const std::filesystem::path& file) {
    ReadRecording read = readRecordingFile(file);
    for (const Fault& fault : read.faults) std::fprintf(stderr, "%s\n", describe(fault).c_str());
    return std::move(read.recording);
}

std::filesystem::path programFolder() {
    char* folder = SDL_GetBasePath();
    std::filesystem::path path = folder != nullptr ? folder : "";
    SDL_free(folder);
    return path;
}

// The current recording and the file that it is written to.
class RecordingFile {
public:
    RecordingFile(App& app, std::string file) : app_(app), file_(std::move(file)) {}

    void begin(const std::filesystem::path& scene) {
        scene_ = scene.stem().string();
        app_.record(scene_);
    }
    // Writes the recording, if there is one. False on failure.
    bool save() {
        const std::optional<Recording> recording = app_.takeRecording();
        if (!recording) return true;
        const std::string file = file_.empty() ? scene_ + "-recording.txt" : file_;
        const std::string fault = writeWholeFile(file, writeRecording(*recording));
        if (!fault.empty()) return fail(fault) == 0;
        std::printf("%s: %lld steps\n", file.c_str(), static_cast<long long>(recording->steps));
        return true;
    }

private:
    App& app_;
    std::string file_;
    std::string scene_;
};

}  // namespace

int main(int argc, char** argv) {
    const ReadArguments read = readArguments(argc, argv);
    if (!read.arguments) return read.exitStatus;
    const Arguments& arguments = *read.arguments;

    // The scene
    std::filesystem::path scene = arguments.scene;
    std::optional<Recording> replay;
    if (!arguments.replay.empty()) {
        replay = openRecording(arguments.replay);
        if (!replay) return 1;
        if (scene.empty()) scene = findScene(replay->scene, arguments.replay, programFolder());
        if (scene.empty())
            return fail("the recording's scene, \"" + replay->scene +
                        "\", was not found; give its file: slicecast SCENE.json --replay FILE");
        if (scene.stem() != replay->scene) {
            return fail("--replay: found a recording of the scene \"" + replay->scene +
                        "\", expected one of \"" + scene.stem().string() + "\"");
        }
    }
    if (scene.empty()) {
        scene = findOpeningScene(programFolder());
        if (scene.empty())
            return fail("the opening scene was not found; give a scene: slicecast SCENE.json");
    }
    ThreadCrew crew(arguments.threads);
    std::unique_ptr<Session> game = openGame(scene, crew);
    if (!game) return 1;

    // The window
    WindowShell shell(arguments.window);
    App app(shell);
    app.setKeys(arguments.keys);
    RecordingFile file(app, arguments.record);
    const std::string title = windowTitle(*game);
    Session& first = *game;
    app.play(std::move(game));
    if (!arguments.record.empty()) file.begin(scene);
    const std::string fault = applyArguments(first, arguments);
    if (!fault.empty()) return fail(fault);
    if (replay) app.replay(std::move(*replay));
    const std::string noWindow = shell.open(app, title);
    if (!noWindow.empty()) return fail(noWindow);

    const auto open = [&](const std::filesystem::path& path) {
        std::unique_ptr<Session> next = openGame(path, crew);
        if (!next) return false;
        file.save();
        scene = path;
        shell.setTitle(windowTitle(*next));
        app.play(std::move(next));
        return true;
    };
    shell.run([&](const std::filesystem::path& dropped) { open(dropped); },
              [&] {
                  if (app.isRecording()) {
                      file.save();
                  } else if (open(scene)) {
                      file.begin(scene);
                  }
              });
    return file.save() ? 0 : 1;
}

#endif

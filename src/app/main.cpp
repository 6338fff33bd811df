// The program in a window: plays a scene until the window is closed. In a page src/wasm starts it.

#ifndef __EMSCRIPTEN__

#include "app/arguments.h"
#include "app/find_scene.h"
#include "app/thread_crew.h"
#include "app/window_shell.h"
#include "files/print_line.h"
#include "files/recording_file.h"
#include "files/scene_file.h"
#include "files/write_file.h"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace slicecast;

namespace {

// A game of that scene, drawn by the crew. Prints all faults; null if the scene cannot be played.
std::unique_ptr<Session> openGame(const std::filesystem::path& scene, Crew& crew) {
    LoadedScene loaded = readSceneFile(scene);
    for (const Fault& fault : loaded.faults) printLine(stderr, describe(fault));
    for (const Fault& warning : loaded.warnings)
        printLine(stderr, {"warning: ", describe(warning)});
    if (!loaded.world) return nullptr;
    auto game = std::make_unique<Session>(std::move(*loaded.world));
    game->renderer().setCrew(&crew);
    return game;
}

// Empty on success, else an error message.
std::string applyArguments(Session& game, const Arguments& arguments) {
    game.setOption("wideFov", "on");  // a window may have any shape
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
    printLine(stderr, {"slicecast: ", fault});
    return 1;
}

// The recording to replay. Prints all faults; empty if there are any.
std::optional<Recording> openRecording(const std::filesystem::path& file) {
    ReadRecording read = readRecordingFile(file);
    for (const Fault& fault : read.faults) printLine(stderr, describe(fault));
    return std::move(read.recording);
}

std::filesystem::path programFolder() {
    char* folder = SDL_GetBasePath();
    std::filesystem::path path = folder != nullptr ? folder : "";
    SDL_free(folder);
    return path;
}

// The current recording and the file that it is written to: the one of the command line, else one
// in the current folder. If that cannot be written, a file of the same name in the home folder.
class RecordingFile {
public:
    RecordingFile(App& app, WindowShell& shell, std::string file)
        : app_(app), shell_(shell), file_(std::move(file)) {}

    // Looks for a place for the recording of a scene, before anything is played in vain. Says so if
    // it is another one than usual. False, with the reason in the window, if there is none.
    bool prepare(const std::filesystem::path& scene) {
        scene_ = scene.stem().string();
        places_ = {file_.empty() ? scene_ + "-recording.txt" : file_};
        const char* home = std::getenv("HOME");
        if (home != nullptr && *home != '\0') {
            const std::filesystem::path name = std::filesystem::path(places_[0]).filename();
            places_.push_back((std::filesystem::path(home) / name).string());
        }
        std::string fault;
        while (!places_.empty()) {
            const std::string why = whyNotWritable(places_[0]);
            if (why.empty()) break;
            if (fault.empty()) fault = why;
            places_.erase(places_.begin());
        }
        if (places_.empty()) {
            complain("cannot record: " + fault);
        } else if (!fault.empty()) {
            complain(fault + "; the recording goes to \"" + places_[0] + '"');
        }
        return !places_.empty();
    }
    void begin() { app_.record(scene_); }

    // Writes the recording, if there is one. False if it is not where it was expected.
    bool save() {
        const std::optional<Recording> recording = app_.takeRecording();
        if (!recording) return true;
        const std::string text = writeRecording(*recording);
        for (const std::string& place : places_) {
            const std::string fault = writeWholeFile(place, text);
            if (fault.empty()) {
                printLine(stdout, {place, ": ", recording->steps, " steps"});
                return &place == places_.data();
            }
            complain(fault);
        }
        return false;
    }

private:
    void complain(const std::string& fault) {
        fail(fault);
        shell_.showMessage(fault);
    }

    App& app_;
    WindowShell& shell_;
    std::string file_;
    std::string scene_;
    std::vector<std::string> places_;  // to try in turn
};

}  // namespace

int main(int argc, char** argv) {
    const ReadArguments read = readArguments(argc, argv);
    if (!read.arguments) return read.exitStatus;
    const Arguments& arguments = *read.arguments;

    if (!arguments.record.empty()) {
        const std::string fault = whyNotWritable(arguments.record);
        if (!fault.empty()) return fail("--record: " + fault);
    }

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
    RecordingFile file(app, shell, arguments.record);
    const std::string title = windowTitle(*game);
    Session& first = *game;
    app.play(std::move(game));
    if (!arguments.record.empty() && file.prepare(scene)) file.begin();
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
                  } else if (file.prepare(scene) && open(scene)) {
                      file.begin();
                  }
              });
    return file.save() ? 0 : 1;
}

#endif

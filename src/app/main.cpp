// The program. In a page it begins to draw into the canvas and returns at once; in a window it plays a scene until the window is closed.

#ifdef __EMSCRIPTEN__

#include "app/page_shell.h"

// SDL has a page call main with arguments; one without would never be called.
int main(int, char**) {
    return slicecast::beginPageProgram() ? 0 : 1;
}

#else

#include "app/arguments.h"
#include "app/scene_file.h"
#include "app/window_shell.h"

#include <cstdio>
#include <memory>
#include <string>

using namespace slicecast;

namespace {

// A game of that scene, or null with all faults printed.
std::unique_ptr<Session> openGame(const std::filesystem::path& scene) {
    LoadedScene loaded = readSceneFile(scene);
    for (const Fault& fault : loaded.faults) std::fprintf(stderr, "%s\n", describe(fault).c_str());
    return loaded.world ? std::make_unique<Session>(std::move(*loaded.world)) : nullptr;
}

// Empty on success, else what was wrong.
std::string applyArguments(Session& game, const Arguments& arguments) {
    for (const auto& [name, value] : arguments.options) {
        const std::string fault = game.setOption(name, value);
        if (!fault.empty()) return fault;
    }
    if (arguments.map.empty()) return {};
    std::string names;
    const std::vector<Map>& maps = game.world().maps;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        names += (i > 0 ? ", \"" : "\"") + maps[i].name + '"';
        if (maps[i].name != arguments.map) continue;
        const Eye eye = {static_cast<int>(i), toCoordinate(0.5 * maps[i].width), toCoordinate(0.5 * maps[i].depth), toCoordinate(maps[i].levels + 0.5)};
        return game.setEye(eye) ? std::string() : "nobody can be in the map \"" + arguments.map + '"';
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

}  // namespace

int main(int argc, char** argv) {
    const ReadArguments read = readArguments(argc, argv);
    if (!read.arguments) return read.exitStatus;
    const Arguments& arguments = *read.arguments;

    // The scene
    std::filesystem::path scene = arguments.scene;
    if (scene.empty()) {
        char* folder = SDL_GetBasePath();
        scene = findOpeningScene(folder != nullptr ? folder : "");
        SDL_free(folder);
        if (scene.empty()) return fail("the scenes that come with it are not there; give it one: slicecast SCENE.json");
    }
    std::unique_ptr<Session> game = openGame(scene);
    if (!game) return 1;
    const std::string fault = applyArguments(*game, arguments);
    if (!fault.empty()) return fail(fault);

    // The window
    WindowShell shell(arguments.window);
    App app(shell);
    const std::string noWindow = shell.open(app, windowTitle(*game));
    if (!noWindow.empty()) return fail(noWindow);
    app.play(std::move(game));
    shell.run([&](const std::filesystem::path& dropped) {
        std::unique_ptr<Session> next = openGame(dropped);
        if (!next) return;
        shell.setTitle(windowTitle(*next));
        app.play(std::move(next));
    });
    return 0;
}

#endif

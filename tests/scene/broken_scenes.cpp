#include "scene/broken_scenes.h"

#include "scene/scene_files.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string_view>

namespace slicecast {
namespace {

[[noreturn]] void end(const std::string& problem) {
    std::fprintf(stderr, "tests/scene/broken/cases.txt: %s\n", problem.c_str());
    std::exit(1);
}

// The lines of a change, each with its end of line.
struct Change {
    std::string from, to;
};

void apply(Change& change, BrokenScene& scene) {
    if (change.from.empty() && change.to.empty()) return;
    if (change.from.empty() || change.to.empty()) end(scene.name + ": a change is incomplete");
    change.from.pop_back();
    change.to.pop_back();
    const std::size_t at = scene.text.find(change.from);
    if (at == std::string::npos || scene.text.find(change.from, at + 1) != std::string::npos)
        end(scene.name + ": \"" + change.from + "\" does not stand exactly once in the file");
    scene.text.replace(at, change.from.size(), change.to);
    change = {};
}

// The first line of a case: "NAME: FILE, VERDICT".
BrokenScene beginCase(const std::string& line) {
    const std::size_t colon = line.find(": ");
    const std::size_t comma = line.find(',');
    if (colon == std::string::npos || comma == std::string::npos)
        end("expected \"NAME: FILE, VERDICT\": " + line);
    const std::filesystem::path file =
        brokenScenesFolder() / line.substr(colon + 2, comma - colon - 2);
    if (!std::filesystem::exists(file)) end("there is no file " + file.string());
    return {line.substr(0, colon), readText(file), {}};
}

}  // namespace

std::filesystem::path brokenScenesFolder() {
    return sceneTestFolder() / "broken";
}

std::vector<BrokenScene> brokenScenes() {
    std::vector<BrokenScene> scenes;
    bool isInside = false;  // a case
    Change change;
    std::istringstream list(readText(brokenScenesFolder() / "cases.txt"));
    for (std::string line; std::getline(list, line);) {
        if (line.empty()) isInside = false;
        if (line.empty() || line.starts_with('#')) continue;
        if (!isInside) {
            scenes.push_back(beginCase(line));
            isInside = true;
            continue;
        }
        BrokenScene& scene = scenes.back();
        const std::string rest = line.size() > 2 ? line.substr(2) : "";
        if (line.starts_with('-')) {
            if (!change.to.empty()) apply(change, scene);
            change.from += rest + "\n";
        } else if (line.starts_with('+')) {
            change.to += rest + "\n";
        } else {
            apply(change, scene);
            scene.faults.push_back(line);
        }
    }
    return scenes;
}

}  // namespace slicecast

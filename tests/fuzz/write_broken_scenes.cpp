// Writes the broken scenes as files into the folder of its argument.
#include "scene/broken_scenes.h"

#include <filesystem>
#include <fstream>

int main(int, char** arguments) {
    const std::filesystem::path folder = arguments[1];
    std::filesystem::create_directories(folder);
    for (const slicecast::BrokenScene& scene : slicecast::brokenScenes())
        std::ofstream(folder / (scene.name + ".json"), std::ios::binary) << scene.text;
}

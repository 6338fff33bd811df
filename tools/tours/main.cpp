// slicecast-tours: plays the tours through the shipped scenes and writes the recordings.
//
//     slicecast-tours assets

#include "files/scene_file.h"
#include "files/write_file.h"
#include "session/recording_text.h"
#include "tours/tours.h"

#include <cstdio>
#include <filesystem>
#include <utility>

using namespace slicecast;

int main(int argc, char** argv) {
    outliveClosedPipes();
    if (argc != 2) {
        std::fprintf(stderr, "usage: slicecast-tours ASSETS_FOLDER\n");
        return 2;
    }
    const std::filesystem::path assets = argv[1];
    int status = 0;
    for (const Tour& tour : allTours()) {
        LoadedScene scene =
            readSceneFile((assets / "scenes" / (std::string(tour.scene) + ".json")).string());
        for (const Fault& fault : scene.faults)
            std::fprintf(stderr, "%s\n", describe(fault).c_str());
        if (!scene.world) return 1;
        Guide guide(std::move(*scene.world), tour.scene);
        tour.give(guide);
        std::string trouble = guide.trouble();
        if (trouble.empty()) {
            trouble =
                writeWholeFile((assets / "tours" / (std::string(tour.scene) + ".txt")).string(),
                               writeRecording(guide.finish()));
        }
        if (trouble.empty()) continue;
        std::fprintf(stderr, "slicecast-tours: %s: %s\n", tour.scene, trouble.c_str());
        status = 1;
    }
    return status;
}

// Draws what a player sees at the start of a scene into a PNG file.
//
//     example-picture assets/scenes/castle.json castle.png

#include <slicecast/slicecast.h>

#include <cstdio>
#include <string>
#include <utility>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: example-picture SCENE.json PICTURE.png\n");
        return 2;
    }

    // A scene, or everything that is wrong with it
    slicecast::LoadResult loaded = slicecast::loadSceneFile(argv[1]);
    for (const slicecast::Fault& fault : loaded.faults)
        std::fprintf(stderr, "%s\n", slicecast::describe(fault).c_str());
    if (!loaded.scene) return 1;

    // A game with that scene, and its first picture
    slicecast::Game game(std::move(*loaded.scene));
    const std::string fault = slicecast::saveImage(game.picture(1280, 720), argv[2]);
    if (!fault.empty()) std::fprintf(stderr, "%s\n", fault.c_str());
    return fault.empty() ? 0 : 1;
}

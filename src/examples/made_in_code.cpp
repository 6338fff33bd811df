// Makes a world without a scene file, walks in it, and draws it.
//
//     example-made-in-code stairs.png

#include <slicecast/slicecast.h>

#include <cstdio>
#include <string>
#include <utility>

using namespace slicecast;

namespace {

// Rows of bricks, 32 x 32 pixels.
Image bricks() {
    Image image(32, 32);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const int shift = y / 8 % 2 * 8;  // every second row begins half a brick later
            const bool isMortar = y % 8 == 0 || (x + shift) % 16 == 0;
            image.at(x, y) = toPixel(isMortar ? Colour{196, 188, 172} : Colour{158, 84, 62});
        }
    }
    return image;
}

// A yard with a wall around it, and stairs that lead up to the east.
LoadResult makeYard() {
    SceneBuilder builder("A yard");
    const auto brick = builder.texture("brick", bricks());
    const auto grass = builder.colour("grass", {96, 132, 72});
    const auto slate = builder.colour("slate", {92, 98, 110});
    const auto wall = builder.block({.name = "wall", .texture = brick, .topTexture = slate});
    const auto step = builder.block({.name = "step", .texture = brick, .top = 0.5});

    const auto yard =
        builder.map({.name = "yard", .width = 12, .depth = 8, .levels = 3, .floor = grass});
    builder.fill(yard, {.width = 12, .levels = 2}, wall);          // north
    builder.fill(yard, {.y = 7, .width = 12, .levels = 2}, wall);  // south
    builder.fill(yard, {.depth = 8, .levels = 2}, wall);           // west
    builder.fill(yard, {.x = 11, .depth = 8, .levels = 3}, wall);  // east
    builder.fill(yard, {.x = 7, .y = 3, .depth = 2}, step);
    builder.fill(yard, {.x = 8, .y = 3, .depth = 2}, wall);
    builder.start(yard, {.x = 1.5, .y = 2.0, .headingDegrees = 18.0});
    return std::move(builder).build();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: example-made-in-code PICTURE.png\n");
        return 2;
    }
    LoadResult made = makeYard();
    for (const Fault& fault : made.faults) std::fprintf(stderr, "%s\n", describe(fault).c_str());
    if (!made.scene) return 1;

    Game game(std::move(*made.scene));
    for (int step = 0; step < kStepsEachSecond; ++step) game.step({.forward = 1.0, .slow = true});
    const Camera camera = game.camera();
    std::printf("after a second: x %.2f, y %.2f, eye at %.2f\n", camera.x, camera.y, camera.z);

    const std::string fault = saveImage(game.picture(640, 400), argv[1]);
    if (!fault.empty()) std::fprintf(stderr, "%s\n", fault.c_str());
    return fault.empty() ? 0 : 1;
}

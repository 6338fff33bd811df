// Makes a room, draws it, and tells a pixel of it: the wall before the player.

#include "world/world.h"

#include <slicecast/slicecast.h>

#include <cstdio>
#include <utility>

int main() {
    slicecast::SceneBuilder builder("Outside");
    const auto red = builder.colour("red", {200, 0, 0});
    const auto wall = builder.block({.name = "wall", .texture = red});
    const auto room = builder.map({.name = "room", .width = 5, .depth = 3, .floor = red});
    builder.fill(room, {.x = 4, .depth = 3}, wall);
    slicecast::LoadResult built = std::move(builder).build();
    if (!built.scene) return 1;

    slicecast::Game game(std::move(*built.scene));
    const slicecast::Image picture = game.picture(64, 40);
    if (picture.empty()) return 1;
    const slicecast::Colour middle = slicecast::toColour(picture.at(32, 20));
    std::printf("%s, %d: %d %d %d\n", SLICECAST_VERSION, kHostsWorld, middle.r, middle.g, middle.b);
    return middle.r > 100 && middle.g == 0 ? 0 : 1;
}

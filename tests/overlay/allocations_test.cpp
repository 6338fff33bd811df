// Overlays that are drawn with every picture take no memory for it.

#include "../count_allocations.h"
#include "canvas.h"
#include "overlay/minimap.h"
#include "overlay/panels.h"
#include "overlay/pixel_grid.h"
#include "overlay/slow_drawing.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(Allocations, NoneAfterTheFirstPicture) {
    Canvas canvas(1280, 720);
    World world;
    world.blueprints.emplace_back();
    world.maps.push_back(makeMap("a map with a long enough name", 40, 40, 3, kNoTexture));
    world.maps[0].setCell(20, 15, 0, 1);
    world.maps[0].objects.resize(100);
    const Eye eye = {.map = 0,
                     .x = toCoordinate(20.5),
                     .y = toCoordinate(20.5),
                     .z = toCoordinate(0.5),
                     .headingDegrees = 33.0};
    const ProcessTimes times = {.framesPerSecond = 60.0,
                                .stepMilliseconds = 1.0,
                                .viewMilliseconds = 1.0,
                                .overlayMilliseconds = 1.0};
    const FrameReport report;
    SlowDrawing slow;
    Minimap minimap;
    const auto draw = [&] {
        slow.show(canvas.picture, 2);
        drawPixelGrid(canvas.picture);
        minimap.draw(world, eye, {.level = 0, .rays = true, .turns = true, .reach = 2.0},
                     canvas.picture);
        drawPlayerPanel({.map = world.maps[0].name, .x = 20.5, .y = 20.5, .z = 0.5},
                        canvas.picture);
        drawProcessPanel({.times = &times, .report = &report}, canvas.picture);
    };
    draw();
    const long before = allocations;
    draw();
    EXPECT_EQ(allocations, before);
    ::operator delete(::operator new(1));
    EXPECT_EQ(allocations, before + 1) << "they are counted";
}

}  // namespace
}  // namespace slicecast

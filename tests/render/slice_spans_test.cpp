// What the walk finds in small worlds, as text: the first stage of a slice, alone.
//
// Pictures are 200 x 200 pixels at 90 degrees, so d is 100 and the horizon is row 100. Column 100
// looks along the heading but for 1/200: at depth t the ray is t/200 to the right of its beginning.
// With the eye at (2.5, 2.5), heading east, the western border of tile x is at depth x - 2.5, and a
// height h above the eye in row 100 - 100 h / t; rows begin with the first whose centre lies below.
#include "scenes.h"
#include "slice_stage.h"
#include "span_text.h"

#include <gtest/gtest.h>

#include <tuple>

namespace slicecast::known {
namespace {

constexpr Colour kGlass = {200, 220, 255, 90};

World hall(int levels = 1) {
    return emptyWorld(12, 5, levels, plain("floor", {60, 60, 60, 255}));
}

BlueprintId addNamed(World& world, const char* name, double bottom = 0.0, double top = 1.0,
                     Colour colour = kWhite, int size = 8) {
    return addBlock(world, addTexture(world, plain(name, colour, size)), toCoordinate(bottom),
                    toCoordinate(top));
}

void setRow(World& world, int x, BlueprintId block, int level = 0, int map = 0) {
    Map& there = world.maps[static_cast<std::size_t>(map)];
    for (int y = 0; y < there.depth; ++y) there.setCell(x, y, level, block);
}

// Of column 100; with a line break before it, as literals have.
std::string found(World& world, const Eye& eye) {
    markSeeThrough(world);
    markPortals(world);
    SliceStage stage(world, eye, 200, 200);
    return '\n' + SpanText(world).of(stage.find(100));
}

Eye eyeInHall(double z = 0.5) {
    return eyeAt(2.5, 2.5, z, 0.0);
}

// All rows below the horizon are floor, beyond the grid too, which ends with tile 11.
TEST(SliceSpans, AnEmptyHall) {
    World world = hall();
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 100-200 over 2,2 to 12,2 and on: floor at -0.5, light 1
sky 0-100
)");
}

// The border at depth 3.5: 100 + 50 / 3.5 = 114.29. The one at 5.5: 109.09.
TEST(SliceSpans, AFloorOfTwoTextures) {
    World world = hall();
    const TextureId carpet = addTexture(world, plain("carpet", kWhite));
    for (int x = 6; x < 8; ++x) world.maps[0].floor.tiles[world.maps[0].tileIndex(x, 2)] = carpet;
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 114-200 over 2,2 to 5,2: floor at -0.5, light 1
floor 109-114 over 6,2 to 7,2: carpet at -0.5, light 1
floor 100-109 over 8,2 to 12,2 and on: floor at -0.5, light 1
sky 0-100
)");
}

// The floor at depth 10 is in row 105; what is farther is haze.
TEST(SliceSpans, TheFloorEndsAtFar) {
    World world = hall();
    world.maps[0].far = 10.0;
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 105-200 over 2,2 to 12,2 and on: floor at -0.5, light 1
sky 0-100
haze 100-105
)");
}

// At depth 3.5, 100 -+ 14.29. Level of detail: 3.5 * 64 = 224 texels are more than 100 and 200, so
// 2, with 16 texels a side. The ray is at 0.5175 of the tile: texel 8. Light 256 * 2 / 3.5 = 146.3,
// fog 255 * (3.5 - 1) / 5 = 127.5.
TEST(SliceSpans, AWall) {
    World world = hall();
    setRow(world, 6, addNamed(world, "wall", 0.0, 1.0, kWhite, 64));
    world.maps[0].light = {.on = true, .intensity = 2.0, .multiplier = 1.0};
    world.maps[0].fog = {.on = true, .start = 1.0, .end = 6.0};
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 114-200 over 2,2 to 5,2: floor at -0.5, light 1
side 86-114 west of 6,2,0: wall detail 2, u 8, v 0-15, depth 3.5, light 146, fog 128
sky 0-86
)");
}

// The upper edge of depth 4 is in row 87.5, the centre of row 87. Crossed eastward it counts as a
// little nearer, so it lies a little higher; crossed westward it lies a little lower. The lower
// edge goes the other way.
TEST(SliceSpans, EdgesOnTheCentresOfRows) {
    World world = hall();
    const BlueprintId wall = addNamed(world, "wall");
    setRow(world, 10, wall);
    setRow(world, 1, wall);
    EXPECT_EQ(found(world, eyeAt(6.0, 2.5, 0.5, 0.0)), R"(
floor 113-200 over 6,2 to 9,2: floor at -0.5, light 1
side 87-113 west of 10,2,0: wall detail 0, u 4, v 0-7, depth 4, light 256, fog 0
sky 0-87
)");
    EXPECT_EQ(found(world, eyeAt(6.0, 2.5, 0.5, 180.0)), R"(
floor 112-200 over 6,2 to 2,2: floor at -0.5, light 1
side 88-112 east of 1,2,0: wall detail 0, u 4, v 0-7, depth 4, light 256, fog 0
sky 0-88
)");
}

// From 1.5 above the floor: the upper edge, 1 below the eye, at 100 + 100 / 2.5 = 140 before and
// 128.57 behind; the lower one at 160 before. Half a block shows the lower half of its texture. The
// floor behind goes on where the roof ends.
TEST(SliceSpans, AStepFromAbove) {
    World world = hall();
    setRow(world, 5, addNamed(world, "step", 0.0, 0.5));
    EXPECT_EQ(found(world, eyeInHall(1.5)), R"(
floor 160-200 over 2,2 to 4,2: floor at -1.5, light 1
side 140-160 west of 5,2,0: step detail 0, u 4, v 4-7, depth 2.5, light 256, fog 0
roof 129-140 of 5,2,0: step at -1, light 1
floor 100-129 over 6,2 to 12,2 and on: floor at -1.5, light 1
sky 0-100
)");
}

// From 2.5: edges 0.5, 1.5 and 2.5 below the eye, at 120, 160 and 200 before and 114.29 behind for
// the roof. Between the two blocks there is none.
TEST(SliceSpans, ATowerFromAbove) {
    World world = hall(2);
    setRow(world, 5, addNamed(world, "base"));
    setRow(world, 5, addNamed(world, "top"), 1);
    EXPECT_EQ(found(world, eyeInHall(2.5)), R"(
side 120-160 west of 5,2,1: top detail 0, u 4, v 0-7, depth 2.5, light 256, fog 0
roof 114-120 of 5,2,1: top at -0.5, light 1
side 160-200 west of 5,2,0: base detail 0, u 4, v 0-7, depth 2.5, light 256, fog 0
floor 100-114 over 6,2 to 12,2 and on: floor at -2.5, light 1
sky 0-100
)");
}

// Between 1.5 and 1.75, which is 1 and 1.25 above the eye: 100 - 40 and 100 - 50 before, 100 -
// 28.57 for the lower edge behind. Rows are seen above it and below it.
TEST(SliceSpans, ABridgeFromBelow) {
    World world = hall(2);
    setRow(world, 5, addNamed(world, "bridge", 0.5, 0.75), 1);
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 100-200 over 2,2 to 12,2 and on: floor at -0.5, light 1
side 50-60 west of 5,2,1: bridge detail 0, u 4, v 2-3, depth 2.5, light 256, fog 0
underside 60-71 of 5,2,1: bridge at 1, light 1, from below
sky 0-50
sky 71-100
)");
}

// Half a unit above the eye it ends with the grid, at depth 9.5: 100 - 5.26.
TEST(SliceSpans, ACeiling) {
    World world = hall();
    const TextureId boards = addTexture(world, plain("boards", kWhite));
    Map& map = world.maps[0];
    map.ceiling = {.height = tileEdge(1), .tiles = {}, .light = 0.75, .glow = false};
    map.ceiling.tiles.assign(map.floor.tiles.size(), boards);
    EXPECT_EQ(found(world, eyeInHall()), R"(
ceiling 0-95 over 2,2 to 11,2: boards at 0.5, light 0.75, from below
floor 100-200 over 2,2 to 12,2 and on: floor at -0.5, light 1
sky 95-100
)");
}

// From above it is half a unit below the eye: 100 + 50 / 2.5 before, 100 + 50 / 4.5 behind.
TEST(SliceSpans, ACeilingFromAbove) {
    World world = hall();
    const TextureId boards = addTexture(world, plain("boards", kWhite));
    Map& map = world.maps[0];
    map.ceiling = {.height = tileEdge(1), .tiles = {}, .light = 1.0, .glow = true};
    map.ceiling.tiles.assign(map.floor.tiles.size(), kNoTexture);
    for (int x = 5; x < 7; ++x) map.ceiling.tiles[map.tileIndex(x, 2)] = boards;
    EXPECT_EQ(found(world, eyeInHall(1.5)), R"(
ceiling 111-120 over 5,2 to 6,2: boards at -0.5, light 1, glows, from below
floor 100-111 over 2,2 to 12,2 and on: floor at -1.5, light 1
floor 120-200 over 2,2 to 12,2 and on: floor at -1.5, light 1
sky 0-100
)");
}

// A see-through ceiling closes no rows.
TEST(SliceSpans, ACeilingOfGlass) {
    World world = hall();
    const TextureId glass = addTexture(world, plain("glass", kGlass));
    Map& map = world.maps[0];
    map.ceiling.height = tileEdge(1);
    map.ceiling.tiles.assign(map.floor.tiles.size(), glass);
    EXPECT_EQ(found(world, eyeInHall()), R"(
layer ceiling 0-95 over 2,2 to 11,2: glass at 0.5, light 1, from below
floor 100-200 over 2,2 to 12,2 and on: floor at -0.5, light 1
sky 0-100
)");
}

// A block of glass from depth 2.5 to 3.5, 100 -+ 20 before and 100 -+ 14.29 behind: its near side,
// then what of it is below the eye, then what is above, all seen from inside; a wall at 5.5 shows
// behind it, 100 -+ 9.09. No row is closed by glass: the floor is one span, which stands where its
// first rows were closed.
TEST(SliceSpans, APane) {
    World world = hall();
    world.maps[0].setCell(5, 2, 0, addNamed(world, "glass", 0.0, 1.0, kGlass));
    setRow(world, 8, addNamed(world, "wall"));
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 109-200 over 2,2 to 7,2: floor at -0.5, light 1
layer side 80-120 west of 5,2,0: glass detail 0, u 4, v 0-7, depth 2.5, light 256, fog 0
layer underside 114-120 of 5,2,0: glass at -0.5, light 1, from below
layer side 100-114 east of 5,2,0: glass detail 0, u 3, v 4-7, depth 3.5, light 256, fog 0
layer roof 80-86 of 5,2,0: glass at 0.5, light 1
layer side 86-100 east of 5,2,0: glass detail 0, u 3, v 0-3, depth 3.5, light 256, fog 0
side 91-109 west of 8,2,0: wall detail 0, u 4, v 0-7, depth 5.5, light 256, fog 0
sky 0-91
)");
}

// Between two blocks of one blueprint there is nothing, unless they do not join. The far side is at
// depth 4.5: 100 -+ 11.11.
TEST(SliceSpans, PanesThatJoin) {
    World world = hall();
    const BlueprintId glass = addNamed(world, "glass", 0.0, 1.0, kGlass);
    world.maps[0].setCell(5, 2, 0, glass);
    world.maps[0].setCell(6, 2, 0, glass);
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 100-200 over 2,2 to 12,2 and on: floor at -0.5, light 1
layer side 80-120 west of 5,2,0: glass detail 0, u 4, v 0-7, depth 2.5, light 256, fog 0
layer underside 114-120 of 5,2,0: glass at -0.5, light 1, from below
layer roof 80-86 of 5,2,0: glass at 0.5, light 1
layer underside 111-114 of 6,2,0: glass at -0.5, light 1, from below
layer side 100-111 east of 6,2,0: glass detail 0, u 3, v 4-7, depth 4.5, light 256, fog 0
layer roof 86-89 of 6,2,0: glass at 0.5, light 1
layer side 89-100 east of 6,2,0: glass detail 0, u 3, v 0-3, depth 4.5, light 256, fog 0
sky 0-100
)");
    world.blueprints[glass].join = false;
    const std::string apart = found(world, eyeInHall());
    EXPECT_NE(apart.find("layer side 86-114 west of 6,2,0"), std::string::npos) << apart;
    EXPECT_NE(apart.find("layer side 100-114 east of 5,2,0"), std::string::npos) << apart;
    EXPECT_NE(apart.find("layer side 86-100 east of 5,2,0"), std::string::npos) << apart;
}

// At depth 2.75, a unit wide and a quarter high: from 0.25 below the eye, 100 + 9.09, to 0.5 below,
// 118.18. Before it the floor is closed, and behind it a wall.
TEST(SliceSpans, AnObjectBeforeAWall) {
    World world = hall();
    setRow(world, 6, addNamed(world, "wall"));
    world.sprites.push_back(makeSprite("stone", Image(8, 8)));
    world.maps[0].objects.push_back({.sprite = 0,
                                     .x = toCoordinate(5.25),
                                     .y = toCoordinate(2.5),
                                     .z = {},
                                     .width = tileEdge(1),
                                     .height = toCoordinate(0.25)});
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 114-200 over 2,2 to 5,2: floor at -0.5, light 1
layer object 109-118 of 0: stone detail 0, u 4, v 0-7, depth 2.75, light 256, fog 0
side 86-114 west of 6,2,0: wall detail 0, u 4, v 0-7, depth 3.5, light 256, fog 0
sky 0-86
)");
}

// A second map with a wall in its tile 3; the first one's portals lead to its tile (1, 1).
World hallWithPortal(const Portal& portal) {
    World world = hall();
    world.maps.push_back(makeMap("beyond", 5, 4, 2, addTexture(world, plain("sand", kWhite))));
    world.maps[1].light.on = false;
    world.portals.push_back(portal);
    return world;
}

constexpr Portal kPortal = {.fromMap = 0, .fromX = 6, .fromY = 2, .toMap = 1, .toX = 1, .toY = 1};

// The portal's face at depth 3.5, 100 -+ 14.29; behind it a wall two tiles on, at 5.5.
TEST(SliceSpans, APortalInAFace) {
    World world = hallWithPortal(kPortal);
    const BlueprintId gate = addNamed(world, "gate");
    world.blueprints[gate].faces[static_cast<std::size_t>(Face::west)].portal = 0;
    world.maps[0].setCell(6, 2, 0, gate);
    setRow(world, 3, addNamed(world, "wall"), 0, 1);
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 114-200 over 2,2 to 5,2: floor at -0.5, light 1
sky 0-86
floor 109-114 over 1,1 to 2,1: sand at -0.5, light 1, map 1, behind 1
side 91-109 west of 3,1,0: wall detail 0, u 4, v 0-7, depth 5.5, light 256, fog 0, map 1, behind 1
sky 86-91, map 1, behind 1
portal 0 86-114 at depth 3.5
)");
    world.portalLimit = 0;
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 114-200 over 2,2 to 5,2: floor at -0.5, light 1
side 86-114 west of 6,2,0: gate detail 0, u 4, v 0-7, depth 3.5, light 256, fog 0
sky 0-86
)");
}

World hallWithPortalTile(int turn, int levels) {
    Portal portal = kPortal;
    portal.turn = turn;
    portal.levels = levels;
    World world = hallWithPortal(portal);
    Map& map = world.maps[0];
    map.tilePortals.assign(map.floor.tiles.size(), kNoPortal);
    map.tilePortals[map.tileIndex(6, 2)] = 0;
    const BlueprintId wall = addNamed(world, "wall");
    for (int x = 0; x < 5; ++x) world.maps[1].setCell(x, 3, 1, wall);
    return world;
}

// A portal tile acts at all heights. Turned once, eastward rays run southward beyond it. A level
// higher the floor is 1.5 below the eye, and what passes under the wall there meets it only outside
// the grid.
TEST(SliceSpans, APortalTileTurnedAndRaised) {
    World world = hallWithPortalTile(1, 1);
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 114-200 over 2,2 to 5,2: floor at -0.5, light 1
side 91-109 north of 1,3,1: wall detail 0, u 4, v 0-7, depth 5.5, light 256, fog 0, map 1, behind 1
floor 109-114 over 1,4 to 1,4 and on: sand at -1.5, light 1, map 1, behind 1
sky 0-91, map 1, behind 1
portal 0 0-114 at depth 3.5
)");
}

// A level lower the floor is 0.5 above the eye: rays that come out below it, from 100 - 14.29 on,
// end in haze. The wall reaches from 1.5 to 2.5 above the eye, 100 - 45.45 and 100 - 27.27 before
// and 100 - 23.08 behind.
TEST(SliceSpans, APortalTileTurnedAndLowered) {
    World world = hallWithPortalTile(1, -1);
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 114-200 over 2,2 to 5,2: floor at -0.5, light 1
haze 86-114, map 1, behind 1
side 55-73 north of 1,3,1: wall detail 0, u 4, v 0-7, depth 5.5, light 256, fog 0, map 1, behind 1
underside 73-77 of 1,3,1: wall at 1.5, light 1, from below, map 1, behind 1
sky 0-55, map 1, behind 1
sky 77-86, map 1, behind 1
portal 0 0-114 at depth 3.5
)");
}

// A mirror of 128 parts of 255, half a unit below the eye. What shows in it stands upside down in
// the lower half: row r of it is row 199 - r. Seen from half a unit below the floor, the wall
// reaches from 0.5 to 1.5 above the viewpoint: 100 - 14.29 and 100 - 42.86.
TEST(SliceSpans, AMirrorFloor) {
    World world = hall();
    setRow(world, 6, addNamed(world, "wall"));
    world.maps[0].floor.mirror = 128;
    EXPECT_EQ(found(world, eyeInHall()), R"(
floor 114-200 over 2,2 to 5,2: floor at -0.5, light 1, mirror
side 86-114 west of 6,2,0: wall detail 0, u 4, v 0-7, depth 3.5, light 256, fog 0
sky 0-86
mirror 114-200 at -0.5, strength 128
reflected side 57-86 west of 6,2,0: wall detail 0, u 4, v 0-7, depth 3.5, light 256, fog 0
reflected sky 0-57
)");
}

// A mirror at height 0.5, a unit below the eye, so the viewpoint is at -0.5. Its rows 129 to 140
// show rows 60 to 71: the wall, cut off at the mirror, and not the step before it, which the rays
// from below would meet first.
TEST(SliceSpans, AMirrorRoof) {
    World world = hall();
    setRow(world, 4, addNamed(world, "step", 0.0, 0.25));
    const BlueprintId pool = addNamed(world, "pool", 0.0, 0.5);
    world.blueprints[pool].faces[static_cast<std::size_t>(Face::top)].mirror = 200;
    setRow(world, 5, pool);
    setRow(world, 6, addNamed(world, "wall"));
    EXPECT_EQ(found(world, eyeInHall(1.5)), R"(
side 183-200 west of 4,2,0: step detail 0, u 4, v 6-7, depth 1.5, light 256, fog 0
roof 150-183 of 4,2,0: step at -1.25, light 1
side 140-150 west of 5,2,0: pool detail 0, u 4, v 4-5, depth 2.5, light 256, fog 0
roof 129-140 of 5,2,0: pool at -1, light 1, mirror
side 114-129 west of 6,2,0: wall detail 0, u 4, v 0-3, depth 3.5, light 256, fog 0
roof 111-114 of 6,2,0: wall at -0.5, light 1
floor 100-111 over 7,2 to 12,2 and on: floor at -1.5, light 1
sky 0-100
mirror 129-140 at -1, strength 200
reflected side 60-71 west of 6,2,0: wall detail 0, u 4, v 0-3, depth 3.5, light 256, fog 0
)");
}

// From 0.75 before the far side of a block: its side, 100 -+ 66.67, and beside it the underside and
// the roof, all seen from inside.
TEST(SliceSpans, TheEyeInABlock) {
    World world = hall();
    world.maps[0].setCell(2, 2, 0, addNamed(world, "block"));
    EXPECT_EQ(found(world, eyeAt(2.25, 2.5, 0.5, 0.0)), R"(
underside 167-200 of 2,2,0: block at -0.5, light 1, from below
side 100-167 east of 2,2,0: block detail 0, u 3, v 4-7, depth 0.75, light 256, fog 0
roof 0-33 of 2,2,0: block at 0.5, light 1
side 33-100 east of 2,2,0: block detail 0, u 3, v 0-3, depth 0.75, light 256, fog 0
)");
}

// Nothing is left of the slice before.
TEST(SliceSpans, ASecondSliceStartsEmpty) {
    World world = hall();
    setRow(world, 6, addNamed(world, "wall"));
    SliceStage stage(world, eyeInHall(), 200, 200);
    const std::string first = SpanText(world).of(stage.find(100));
    stage.find(0);
    EXPECT_EQ(SpanText(world).of(stage.find(100)), first);
}

// At least two layers for each pane. Red panes beyond the column's last layer are as if they were
// not there.
TEST(SliceSpans, LayersBeyondTheMostAreLeftOut) {
    constexpr int kPanes = static_cast<int>(kMaxLayers) / 2;
    const auto hallOf = [](int clear, int red) {
        World world = emptyWorld(500, 5, 1, plain("floor", {60, 60, 60, 255}));
        for (const auto& [panes, colour, from] : {std::tuple{clear, Colour{60, 60, 60, 1}, 4},
                                                  {red, Colour{255, 0, 0, 200}, 4 + clear}}) {
            const BlueprintId pane = addNamed(world, "pane", 0.0, 1.0, colour);
            world.blueprints[pane].join = false;
            for (int i = 0; i < panes; ++i) setRow(world, from + i, pane);
        }
        markSeeThrough(world);
        return world;
    };
    const auto layersOf = [](const World& world) {
        SliceStage stage(world, eyeInHall(), 200, 200);
        return stage.find(100).upright.layers;
    };
    const auto pictureOf = [](const World& world) { return draw(world, eyeInHall(), 200, 40); };
    EXPECT_LT(layersOf(hallOf(10, 20)), kMaxLayers);
    EXPECT_EQ(layersOf(hallOf(kPanes, 0)), kMaxLayers);
    EXPECT_EQ(layersOf(hallOf(kPanes, 50)), kMaxLayers);
    EXPECT_NE(pictureOf(hallOf(10, 20)).pixels, pictureOf(hallOf(10, 0)).pixels);
    EXPECT_EQ(pictureOf(hallOf(kPanes, 50)).pixels, pictureOf(hallOf(kPanes, 0)).pixels);
}

}  // namespace
}  // namespace slicecast::known

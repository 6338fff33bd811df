// Compares the tracer with answers worked out on paper: portals and mirrors.
#include "tracer.h"

#include <gtest/gtest.h>

namespace slicecast::judge {
namespace {

constexpr BlueprintId kWall = 1;

Image plainImage(Colour colour) {
    Image image(8, 8);
    for (Pixel& pixel : image.pixels) pixel = toPixel(colour);
    return image;
}

Texture plain(Colour colour) {
    return makeTexture("plain", plainImage(colour));
}

// Two maps, 9 x 9 and 7 x 5 tiles, three levels, without light; one blueprint, a full block.
World twoMaps() {
    World world;
    world.textures = {plain({10, 20, 30, 255}), plain({200, 100, 50, 255})};
    CellBlueprint wall;
    for (FaceBlueprint& face : wall.faces) face.texture = 1;
    world.blueprints.push_back(wall);
    world.maps = {makeMap("entry", 9, 9, 3, 0), makeMap("exit", 7, 5, 3, 0)};
    world.maps[0].sky.low = {1, 1, 1, 255};
    world.maps[1].sky.low = {2, 2, 2, 255};
    world.maps[0].haze = {3, 3, 3, 255};
    world.maps[1].haze = {4, 4, 4, 255};
    return world;
}

// Puts a block at (x, y, level) of the first map; all its faces are that portal.
void addPortalBlock(World& world, int x, int y, int level, const Portal& portal) {
    CellBlueprint block = world.blueprints[kWall];
    for (FaceBlueprint& face : block.faces)
        face.portal = static_cast<PortalId>(world.portals.size());
    world.portals.push_back(portal);
    world.blueprints.push_back(block);
    world.maps[0].setCell(x, y, level, static_cast<BlueprintId>(world.blueprints.size() - 1));
    markPortals(world);
}

View eyeAt(double x, double y, double z, double heading) {
    View view;
    view.x = toCoordinate(x);
    view.y = toCoordinate(y);
    view.z = toCoordinate(z);
    view.headingDegrees = heading;
    view.fovDegrees = 90.0;  // a row's slope is its distance from the middle in half picture widths
    view.width = 100;
    view.height = 100;
    return view;
}

// What a ray meets, front to back. Its slopes to the right and up are per unit of depth.
std::vector<Sight> along(const World& world, const View& view, double sideways, double up) {
    std::vector<Sight> sights;
    Tracer(world, view).look(50.0 + 50.0 * sideways, 50.0 - 50.0 * up, sights);
    return sights;
}

// The ray goes east into the west face of (5, 4), and comes out of the north side of (3, 1) going
// south. The wall at (3, 3) is 2.5 + 2 away. What is right of the middle for the eye lies west
// there.
TEST(Tracer, GoesOnTurnedBehindAPortal) {
    World world = twoMaps();
    addPortalBlock(world, 5, 4, 0, {0, 5, 4, 1, 3, 1, 1, 0});
    world.maps[1].setCell(3, 3, 0, kWall);
    const std::vector<Sight> sights = along(world, eyeAt(2.5, 4.5, 0.5, 0.0), 0.05, 0.0);
    ASSERT_EQ(sights.size(), 1u);
    EXPECT_EQ(sights[0].kind, Sight::Kind::side);
    EXPECT_EQ(sights[0].face, Face::north);
    EXPECT_EQ(sights[0].map, 1);
    EXPECT_DOUBLE_EQ(sights[0].depth, 4.5);
    // x = 3.5 - 0.05 * 4.5 in the exit map; the north face's u runs the other way.
    EXPECT_NEAR(sights[0].u, -(0.5 - 0.05 * 4.5), 1e-12);
}

// The same portal, raised by two levels: height 0.5 before it is height 2.5 behind it.
TEST(Tracer, ShiftsByWholeLevels) {
    World world = twoMaps();
    addPortalBlock(world, 5, 4, 0, {0, 5, 4, 1, 3, 1, 1, 2});
    world.maps[1].setCell(3, 3, 0, kWall);
    EXPECT_EQ(along(world, eyeAt(2.5, 4.5, 0.5, 0.0), 0.0, 0.0)[0].kind, Sight::Kind::sky);
    world.maps[1].setCell(3, 3, 2, kWall);
    EXPECT_DOUBLE_EQ(along(world, eyeAt(2.5, 4.5, 0.5, 0.0), 0.0, 0.0)[0].depth, 4.5);
    // Lowered by one, the ray comes out below the floor: it ends at the portal, in the exit's haze.
    world.portals[0].levels = -1;
    const std::vector<Sight> below = along(world, eyeAt(2.5, 4.5, 0.5, 0.0), 0.0, 0.0);
    ASSERT_EQ(below.size(), 1u);
    EXPECT_EQ(below[0].kind, Sight::Kind::haze);
    EXPECT_EQ(below[0].colour, (Colour{4, 4, 4, 255}));
    EXPECT_DOUBLE_EQ(below[0].depth, 2.5);
}

// A portal leads to the tile before it, so a ray passes it again and again. At the limit, a portal
// face shows its own texture, and a portal tile shows haze.
TEST(Tracer, PassesAsManyPortalsAsItMay) {
    World world = twoMaps();
    addPortalBlock(world, 5, 4, 0, {0, 5, 4, 0, 4, 4, 0, 0});
    for (const int limit : {0, 1, 5}) {
        world.portalLimit = limit;
        const std::vector<Sight> sights = along(world, eyeAt(2.5, 4.5, 0.5, 0.0), 0.0, 0.0);
        ASSERT_EQ(sights.size(), 1u);
        EXPECT_EQ(sights[0].kind, Sight::Kind::side);
        EXPECT_EQ(sights[0].portals, limit);
        EXPECT_DOUBLE_EQ(sights[0].depth, 2.5 + limit);
    }
    world.maps[0].setCell(5, 4, 0, kEmptyCell);
    world.maps[0].tilePortals.assign(81, kNoPortal);
    world.maps[0].tilePortals[world.maps[0].tileIndex(5, 4)] = 0;
    const std::vector<Sight> sights = along(world, eyeAt(2.5, 4.5, 0.5, 0.0), 0.0, 0.0);
    EXPECT_EQ(sights[0].kind, Sight::Kind::haze);
    EXPECT_DOUBLE_EQ(sights[0].depth, 7.5);
    // A portal tile acts at any height, but not on an eye inside it.
    EXPECT_EQ(along(world, eyeAt(2.5, 4.5, 9.5, 0.0), 0.0, 0.0)[0].kind, Sight::Kind::haze);
    EXPECT_EQ(along(world, eyeAt(5.5, 4.5, 0.5, 0.0), 0.0, 0.0)[0].kind, Sight::Kind::sky);
}

// From inside its block, a portal face is invisible and leads nowhere.
TEST(Tracer, APortalActsFromOutsideOnly) {
    World world = twoMaps();
    addPortalBlock(world, 5, 4, 0, {0, 5, 4, 1, 3, 1, 0, 0});
    const std::vector<Sight> sights = along(world, eyeAt(5.5, 4.5, 0.5, 0.0), 0.0, 0.0);
    ASSERT_EQ(sights.size(), 1u);
    EXPECT_EQ(sights[0].map, 0);
    EXPECT_EQ(sights[0].kind, Sight::Kind::sky);
    // An eye on a border is in the tile to the east. So a ray going west from the block's east
    // border enters the block, and one going east from its west border starts inside.
    EXPECT_EQ(along(world, eyeAt(6.0, 4.5, 0.5, 180.0), 0.0, 0.0)[0].map, 1);
    EXPECT_EQ(along(world, eyeAt(5.0, 4.5, 0.5, 0.0), 0.0, 0.0)[0].map, 0);
    EXPECT_EQ(along(world, eyeAt(5.5, 4.5, 1.0, 0.0), 0.0, -0.5)[0].map, 1);
}

// The eye is 1.5 above a mirror, and the ray falls by half a unit each unit: it meets the mirror at
// depth 3, then rises to the middle of a wall at depth 4, or into the sky without a wall.
TEST(Tracer, RisesAgainFromAMirror) {
    World world = twoMaps();
    world.maps[0].floor.mirror = 100;
    world.maps[0].setCell(5, 4, 0, kWall);
    std::vector<Sight> sights = along(world, eyeAt(1.0, 4.5, 1.5, 0.0), 0.0, -0.5);
    ASSERT_EQ(sights.size(), 2u);
    EXPECT_EQ(sights[0].kind, Sight::Kind::floor);
    EXPECT_EQ(sights[0].mirror, 100);
    EXPECT_DOUBLE_EQ(sights[0].depth, 3.0);
    EXPECT_EQ(sights[1].kind, Sight::Kind::side);
    EXPECT_DOUBLE_EQ(sights[1].depth, 4.0);
    EXPECT_DOUBLE_EQ(sights[1].v, 0.5);
    world.maps[0].setCell(5, 4, 0, kEmptyCell);
    sights = along(world, eyeAt(1.0, 4.5, 1.5, 0.0), 0.0, -0.5);
    ASSERT_EQ(sights.size(), 2u);
    EXPECT_EQ(sights[1].kind, Sight::Kind::sky);
    // Beyond `far` the floor is haze and no mirror. `mirrors` multiplies the mirror's strength.
    world.maps[0].far = 2.9;
    EXPECT_EQ(along(world, eyeAt(1.0, 4.5, 1.5, 0.0), 0.0, -0.5).size(), 1u);
    world.maps[0].far = 3.1;
    View view = eyeAt(1.0, 4.5, 1.5, 0.0);
    view.mirrors = 0.5;
    EXPECT_EQ(along(world, view, 0.0, -0.5)[0].mirror, 50);
    view.mirrors = 0.0;
    EXPECT_EQ(along(world, view, 0.0, -0.5).size(), 1u);
}

// A ray meets objects of the entry map only before the portal, those of the exit map only behind
// it.
TEST(Tracer, MeetsObjectsOfTheMapThatItIsIn) {
    World world = twoMaps();
    world.sprites.push_back(makeSprite("plain", plainImage({9, 9, 9, 255})));
    addPortalBlock(world, 5, 4, 0, {0, 5, 4, 1, 3, 1, 1, 0});
    const auto objectAt = [](double x, double y) {
        Object object;
        object.x = toCoordinate(x);
        object.y = toCoordinate(y);
        object.width = tileEdge(1);
        object.height = tileEdge(1);
        return object;
    };
    // Of each map, one object on the ray's way, and one in its line on the portal's other side
    world.maps[0].objects = {objectAt(3.5, 4.5), objectAt(7.5, 4.5)};
    world.maps[1].objects = {objectAt(3.5, 3.5), objectAt(3.5, 0.5)};
    const std::vector<Sight> sights = along(world, eyeAt(2.5, 4.5, 0.5, 0.0), 0.0, 0.0);
    ASSERT_EQ(sights.size(), 3u);
    EXPECT_EQ(sights[0].map, 0);
    EXPECT_DOUBLE_EQ(sights[0].depth, 1.0);
    EXPECT_EQ(sights[1].map, 1);
    EXPECT_DOUBLE_EQ(sights[1].depth, 5.0);
    EXPECT_EQ(sights[2].kind, Sight::Kind::sky);
}

}  // namespace
}  // namespace slicecast::judge

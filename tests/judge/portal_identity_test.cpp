// Portals that must not be seen: to a copy of what they hide, and just before one's eye is carried
// through.
#include "draw.h"
#include "turned_copy.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace slicecast::judge {
namespace {

// Random worlds without portals of their own; eyes outside all blocks, off all borders.
bool isFit(const Scene& scene) {
    const View& view = scene.view;
    const Map& map = scene.world.maps[static_cast<std::size_t>(view.map)];
    const auto onGrid = [](Coordinate c) {
        return (c.raw & 0x1fff) < 16 || (c.raw & 0x1fff) > 0x1ff0;
    };
    if (!scene.world.portals.empty() || onGrid(view.x) || onGrid(view.y)) return false;
    const double turns = view.headingDegrees / 45.0;
    if (turns == static_cast<int>(turns)) return false;
    const BlueprintId id = map.cell(view.x.tile(), view.y.tile(), view.z.tile());
    if (id == kEmptyCell) return true;
    const Coordinate height = view.z - tileEdge(view.z.tile());
    return height < scene.world.blueprints[id].bottom || height > scene.world.blueprints[id].top;
}

// What fills only a part of its tile joins nothing through portals, and has none. Blocks with
// slopes do not join through them either; and a slope that has gone along with a part of a tile
// does not reach over all of it.
void fillTiles(World& world) {
    for (CellBlueprint& blueprint : world.blueprints) {
        blueprint.plan = {};
        if (blueprint.seeThrough || movesSideways(world, blueprint)) blueprint.slopes = {};
    }
    markPlans(world);
}

// Ripples end at portals.
void calm(World& world) {
    for (Map& map : world.maps) map.floor.ripples = 0;
    for (CellBlueprint& blueprint : world.blueprints)
        blueprint.faces[static_cast<std::size_t>(Face::top)].ripples = 0;
}

// A turned block is of another blueprint, so that it does not join the one before the portal; and a
// panorama must have quarters.
void prepareForTurn(World& world, int turn) {
    fillTiles(world);
    calm(world);
    if (turn == 0) return;
    for (CellBlueprint& blueprint : world.blueprints) blueprint.join = false;
    Sky& sky = world.maps[0].sky;
    sky.stars = {};  // like the clouds, they cannot be turned
    sky.clouds = {};
    if (sky.kind != Sky::Kind::panorama) return;
    Image wider(sky.panorama.width * 4, sky.panorama.height);
    for (int y = 0; y < wider.height; ++y) {
        for (int x = 0; x < wider.width; ++x)
            wider.at(x, y) = sky.panorama.at(x % sky.panorama.width, y) ^
                             static_cast<Pixel>(x / sky.panorama.width * 16);
    }
    sky.panorama = std::move(wider);
}

// Parts of what moves sideways join along their way whatever `join` says, but not through portals.
// Turned, no blocks join through them.
bool joinsOnlyHere(const World& world, int turn) {
    return std::any_of(
        world.blueprints.begin(), world.blueprints.end(), [&](const CellBlueprint& block) {
            return block.seeThrough && movesSideways(world, block) && (turn != 0 || !block.join);
        });
}

// Portals from map 0 to its copy, map 1: on whole tiles, on some faces of opaque blocks, on all
// faces of see-through ones.
void addPortalsToCopy(Random& random, World& world, int turn) {
    Map& map = world.maps[0];
    map.tilePortals.assign(static_cast<std::size_t>(map.width * map.depth), kNoPortal);
    const int often = random.between(2, 8);
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const Tile exit = turnedTile(map, {x, y}, turn);
            const auto portal = static_cast<PortalId>(world.portals.size());
            world.portals.push_back({0, x, y, 1, exit.x, exit.y, turn, 0});
            if (random.oneIn(2 * often)) map.tilePortals[map.tileIndex(x, y)] = portal;
            for (int level = 0; level < map.levels; ++level) {
                const BlueprintId from = map.cell(x, y, level);
                if (from == kEmptyCell || !random.oneIn(often)) continue;
                CellBlueprint block = world.blueprints[from];
                for (FaceBlueprint& face : block.faces) {
                    if (block.seeThrough || random.oneIn(2)) face.portal = portal;
                }
                world.blueprints.push_back(block);
                map.setCell(x, y, level, static_cast<BlueprintId>(world.blueprints.size() - 1));
            }
        }
    }
    markPortals(world);
}

int differences(const Image& a, const Image& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) count += a.pixels[i] != b.pixels[i];
    return count;
}

// Of the pixels that differ, those whose rays pass fewer portals than they may.
int differencesWithinTheLimit(const Image& a, const Image& b, const World& world,
                              const View& view) {
    int count = 0;
    std::vector<Sight> sights;
    const Tracer tracer(world, view);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            if (a.at(x, y) == b.at(x, y)) continue;
            Notes notes;
            tracer.look(x + 0.5, y + 0.5, sights, &notes);
            const auto has = [&](Note note) { return notes[static_cast<std::size_t>(note)]; };
            count += !has(Note::faceAtLimit) && !has(Note::tileAtLimit);
        }
    }
    return count;
}

class PortalIdentity : public testing::TestWithParam<int> {};

TEST_P(PortalIdentity, APortalToACopyIsNotSeen) {
    const int turn = GetParam();
    Renderer renderer;
    int pictures = 0;
    int changed = 0;
    for (std::uint64_t seed = 5000; pictures < 300; ++seed) {
        Scene scene = randomScene(seed, 96, 60);
        if (!isFit(scene) || joinsOnlyHere(scene.world, turn)) continue;
        scene.view.baked = false;  // that light knows no portals
        // Shares are rounded down, so those of a turned texture are not quite the same
        if (turn != 0) scene.view.smooth = false;
        ++pictures;
        prepareForTurn(scene.world, turn);
        const Image before = draw(renderer, scene.world, scene.view);
        Random random(seed);
        ASSERT_EQ(addTurnedCopy(scene.world, 0, turn), 1);
        addPortalsToCopy(random, scene.world, turn);
        EXPECT_EQ(differences(before, draw(renderer, scene.world, scene.view)), 0)
            << "seed " << seed;
        // The portals are there: in a copy of another colour they show.
        scene.world.maps[1].haze = {255, 0, 255, 255};
        scene.world.maps[1].fog = {true, 0.0, 0.001};
        scene.view.fog = true;
        changed += differences(before, draw(renderer, scene.world, scene.view)) > 0;
    }
    EXPECT_GE(changed, pictures / 2);
}

// The eye stands just before a crossing that all its rays pass, or on it, and then where the portal
// carries it.
TEST_P(PortalIdentity, AnEyeCarriedOverSeesTheSame) {
    const int turn = GetParam();
    Renderer renderer;
    int pictures = 0;
    int changed = 0;
    for (std::uint64_t seed = 9000; pictures < 300; ++seed) {
        Scene scene = randomScene(seed, 96, 60);
        World& world = scene.world;
        if (world.portals.empty() || world.maps.size() < 2 || world.maps[0].width < 3 ||
            world.maps[0].depth < 3)
            continue;
        fillTiles(world);
        Random random(seed);
        Map& map = world.maps[0];
        const auto exitMap = static_cast<int>(world.maps.size()) - 1;
        Map& other = world.maps[static_cast<std::size_t>(exitMap)];
        if (other.width < 3 || other.depth < 3) continue;
        ++pictures;

        // One more portal, a tile's or that of a full block, entered in one of four directions.
        const Tile entry = {random.between(1, map.width - 2), random.between(1, map.depth - 2)};
        const Tile exit = {random.between(1, other.width - 2), random.between(1, other.depth - 2)};
        const int direction = random.below(4);
        const Tile step = Place::turned(Tile{1, 0}, direction);
        const Portal portal = {0,      entry.x, entry.y, exitMap,
                               exit.x, exit.y,  turn,    random.between(0, 2)};
        const auto id = static_cast<PortalId>(world.portals.size());
        world.portals.push_back(portal);
        Place place;
        place = place.through(portal);

        View& view = scene.view;
        view.map = 0;
        const int level = random.below(map.levels);
        view.z = {level * 65536 + random.between(2000, 63000)};
        view.look = random.between(-0.2, 0.2);
        view.fovDegrees = random.between(40.0, 80.0);
        view.headingDegrees = 90.0 * direction + random.between(-20.0, 20.0);
        // Nothing stands where the eye is, in either map, and no other tile's portal leads out of
        // there.
        const Tile before = {entry.x - step.x, entry.y - step.y};
        const Tile carried = place.tileOf(before);
        map.occupied[map.tileIndex(before.x, before.y)] = 0;
        other.occupied[other.tileIndex(carried.x, carried.y)] = 0;
        if (!other.tilePortals.empty())
            other.tilePortals[other.tileIndex(exit.x, exit.y)] = kNoPortal;
        // Faces in the plane in which rays come out do not act on them; all others do.
        const auto side = static_cast<std::size_t>((direction + turn + 3) % 4);
        for (int i = 0; i < other.levels; ++i) {
            const BlueprintId cell = other.cell(exit.x, exit.y, i);
            if (!world.blueprints[cell].hasPortals && !random.oneIn(3)) continue;
            CellBlueprint block =
                instanceOf(world, cell == kEmptyCell ? static_cast<BlueprintId>(1) : cell);
            block.faces[side].portal = kNoPortal;
            if (block.top <= block.bottom) continue;
            for (const Face face : {Face::top, Face::bottom}) {
                if (random.oneIn(2))
                    block.faces[static_cast<std::size_t>(face)].portal =
                        static_cast<PortalId>(random.below(static_cast<int>(id) + 1));
            }
            world.blueprints.push_back(block);
            other.setCell(exit.x, exit.y, i, static_cast<BlueprintId>(world.blueprints.size() - 1));
        }
        const auto leadThere = [&] {
            if (random.oneIn(2)) {
                map.tilePortals.resize(static_cast<std::size_t>(map.width * map.depth), kNoPortal);
                map.tilePortals[map.tileIndex(entry.x, entry.y)] = id;
                return;
            }
            if (!map.tilePortals.empty())
                map.tilePortals[map.tileIndex(entry.x, entry.y)] = kNoPortal;
            CellBlueprint block = world.blueprints[1];
            block.bottom = {};
            block.top = tileEdge(1);
            for (FaceBlueprint& face : block.faces) face.portal = id;
            world.blueprints.push_back(block);
            map.setCell(entry.x, entry.y, level,
                        static_cast<BlueprintId>(world.blueprints.size() - 1));
        };
        leadThere();
        markPortals(world);
        world.portalLimit = 20;

        // So near that all rays pass the face, and not at the texels' borders.
        const int near = random.oneIn(3) ? 0 : random.between(1, 40);
        const int aside = random.between(-20000, 20000) | 1;
        const auto raw = [&](int tile, int ahead, int across) {
            return Coordinate{tile * 65536 + 32768 + ahead * (-32768 - near) + across * aside};
        };
        view.x = raw(entry.x, step.x, step.y);
        view.y = raw(entry.y, step.y, step.x);
        // On a border the eye is in the tile to the east or south of it.
        if (near == 0 && (step.x > 0 || step.y > 0)) {
            view.x = {view.x.raw - step.x};
            view.y = {view.y.raw - step.y};
        }
        const Image here = draw(renderer, world, view);
        View there = view;
        there.map = exitMap;
        const Tile turned = Place::turned(Tile{view.x.raw, view.y.raw}, turn);
        there.x = {turned.x + place.x * 65536};
        there.y = {turned.y + place.y * 65536};
        there.z = view.z + tileEdge(portal.levels);
        there.headingDegrees = view.headingDegrees + 90.0 * turn;
        EXPECT_EQ(differencesWithinTheLimit(here, draw(renderer, world, there), world, view), 0)
            << "seed " << seed;
        // It is the portal that leads there.
        world.portals[id].levels += 40;
        changed += differences(here, draw(renderer, world, view)) > 0;
    }
    EXPECT_GE(changed, pictures / 2);
}

INSTANTIATE_TEST_SUITE_P(Turns, PortalIdentity, testing::Values(0, 1, 2, 3));

}  // namespace
}  // namespace slicecast::judge

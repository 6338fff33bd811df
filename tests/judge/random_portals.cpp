#include "random_portals.h"

#include <algorithm>
#include <vector>

namespace slicecast::judge {
namespace {

struct Cell {
    int x;
    int y;
    int level;
};

Cell anyCell(Random& random, const Map& map) {
    const int x = random.below(map.width);
    const int y = random.below(map.depth);
    return {x, y, random.below(map.levels)};
}

// A blueprint of its own for what moves or leads elsewhere.
BlueprintId addInstance(World& world, BlueprintId blueprint) {
    world.blueprints.push_back(instanceOf(world, blueprint));
    return static_cast<BlueprintId>(world.blueprints.size() - 1);
}

// Most portals keep the level; of the others most lead to a level that the exit map has.
int anyShift(Random& random) {
    return random.oneIn(3) ? random.between(-3, 3) : 0;
}

PortalId anyPortal(Random& random, World& world, int map, int x, int y, bool twins) {
    Portal portal;
    portal.fromMap = map;
    portal.fromX = x;
    portal.fromY = y;
    portal.toMap = random.below(static_cast<int>(world.maps.size()));
    const Map& exit = world.maps[static_cast<std::size_t>(portal.toMap)];
    // Every other exit is rather where blocks stand.
    const int tries = random.oneIn(2) ? 6 : 1;
    for (int i = 0;
         i < tries && (i == 0 || exit.occupied[exit.tileIndex(portal.toX, portal.toY)] == 0); ++i) {
        portal.toX = random.below(exit.width);
        portal.toY = random.below(exit.depth);
    }
    portal.turn = random.below(4);
    portal.levels = anyShift(random);
    if (twins && random.oneIn(2)) portal = {map, x, y, 1 - map, x, y, 0, 0};
    world.portals.push_back(portal);
    return static_cast<PortalId>(world.portals.size() - 1);
}

// Some rows of glass that joins, the same in both maps.
void addRowsOfGlass(Random& random, World& world, Map& first, Map& second) {
    for (int i = 0; i < 6; ++i) {
        const auto id = static_cast<BlueprintId>(
            random.between(1, static_cast<int>(world.blueprints.size()) - 1));
        const CellBlueprint& blueprint = world.blueprints[id];
        const Cell from = anyCell(random, first);
        if (!blueprint.seeThrough || !blueprint.join || blueprint.top <= blueprint.bottom) continue;
        for (int x = from.x; x < std::min(first.width, from.x + 6); ++x) {
            first.setCell(x, from.y, from.level, id);
            second.setCell(x, from.y, from.level, id);
        }
    }
}

// Makes one map's blocks and planes like another's.
void makeAlike(Map& twin, const Map& map) {
    twin.width = map.width;
    twin.depth = map.depth;
    twin.levels = map.levels;
    twin.cells = map.cells;
    twin.occupied = map.occupied;
    twin.floor.tiles = map.floor.tiles;
    twin.ceiling.tiles = map.ceiling.tiles;
    twin.ceiling.height = map.ceiling.height;
}

}  // namespace

void addPortals(Random& random, World& world) {
    world.portalLimit = random.oneIn(3) ? random.between(0, 5) : random.between(3, 5);
    // Sometimes two maps are alike and some portals lead from one to the other without a seam, so
    // that blocks join behind a portal.
    const bool twins = world.maps.size() >= 2 && random.oneIn(2);
    if (twins) {
        makeAlike(world.maps[1], world.maps[0]);
        addRowsOfGlass(random, world, world.maps[0], world.maps[1]);
    }
    const int shape = static_cast<int>(world.blueprints.size());
    for (int m = 0; m < static_cast<int>(world.maps.size()); ++m) {
        Map& map = world.maps[static_cast<std::size_t>(m)];
        const int tiles = map.width * map.depth;
        // Where the floor ends in haze, portals behind it are not reached.
        if (random.oneIn(3)) map.far = random.between(1.0, 8.0);
        // Faces: blocks that are there, and new ones.
        const int blocks = random.between(1, std::max(2, std::min(24, tiles * map.levels / 6)));
        for (int i = 0; i < blocks; ++i) {
            const Cell cell = anyCell(random, map);
            BlueprintId from = map.cell(cell.x, cell.y, cell.level);
            while (from == kEmptyCell ||
                   world.blueprints[from].top <= world.blueprints[from].bottom) {
                from = static_cast<BlueprintId>(random.between(1, shape - 1));
            }
            const BlueprintId id = addInstance(world, from);
            const bool all = random.oneIn(4);
            for (FaceBlueprint& face : world.blueprints[id].faces) {
                if (all || random.oneIn(2))
                    face.portal = anyPortal(random, world, m, cell.x, cell.y, twins && m < 2);
            }
            world.blueprints[id].mover = random.oneIn(6) ? id : -1;
            map.setCell(cell.x, cell.y, cell.level, id);
            // Like any that moves, such a block may be empty at the moment.
            if (random.oneIn(10))
                map.occupied[map.tileIndex(cell.x, cell.y)] &= ~(1u << cell.level);
        }
        if (!random.oneIn(2)) continue;
        map.tilePortals.assign(static_cast<std::size_t>(tiles), kNoPortal);
        const int portals = random.between(1, std::max(1, std::min(16, tiles / 6)));
        for (int i = 0; i < portals; ++i) {
            const Cell cell = anyCell(random, map);
            map.tilePortals[map.tileIndex(cell.x, cell.y)] =
                anyPortal(random, world, m, cell.x, cell.y, twins && m < 2);
        }
    }
    markPortals(world);
}

void addMirrors(Random& random, World& world) {
    const auto strength = [&] {
        return static_cast<std::uint8_t>(random.oneIn(6) ? 255 : random.between(1, 255));
    };
    for (Map& map : world.maps) {
        if (!random.oneIn(3)) map.floor.mirror = strength();
    }
    for (CellBlueprint& blueprint : world.blueprints) {
        if (random.oneIn(2))
            blueprint.faces[static_cast<std::size_t>(Face::top)].mirror = strength();
    }
}

void addMovers(Random& random, World& world) {
    const int shapes = static_cast<int>(world.blueprints.size());
    for (Map& map : world.maps) {
        const int movers = random.between(1, 4);
        for (int i = 0; i < movers; ++i) {
            const Cell cell = anyCell(random, map);
            const int levels = random.between(1, map.levels - cell.level);
            auto shape = static_cast<BlueprintId>(random.between(1, shapes - 1));
            // Parts of glass join: if there is any, most are of it.
            for (int tries = 0;
                 tries < 8 && !(world.blueprints[shape].seeThrough && world.blueprints[shape].join);
                 ++tries) {
                shape = static_cast<BlueprintId>(random.between(1, shapes - 1));
            }
            const int wide = std::min(map.width - cell.x, random.between(1, 2));
            const int empty = random.oneIn(4) ? random.below(levels) : levels;
            const int mover = 1000 + static_cast<int>(world.blueprints.size());
            for (int level = 0; level < levels; ++level) {
                const BlueprintId id = addInstance(world, shape);
                CellBlueprint& part = world.blueprints[id];
                part.mover = mover;
                if (level > 0) part.bottom = {};
                if (level < levels - 1) part.top = tileEdge(1);
                if (part.bottom >= part.top) part.bottom = {};
                if (level >= empty) part.top = part.bottom;
                for (int x = cell.x; x < cell.x + wide; ++x) {
                    map.setCell(x, cell.y, cell.level + level, id);
                    if (level >= empty)
                        map.occupied[map.tileIndex(x, cell.y)] &= ~(1u << (cell.level + level));
                }
            }
        }
    }
}

void addKin(Random& random, World& world) {
    for (Map& map : world.maps) {
        for (int y = 0; y < map.depth; ++y) {
            for (int x = 0; x < map.width; ++x) {
                for (int level = 0; level < map.levels; ++level) {
                    const CellBlueprint& block = world.blueprints[map.cell(x, y, level)];
                    if (!block.hasPortals || !block.seeThrough || block.origin == kEmptyCell)
                        continue;
                    const BlueprintId kin = block.origin;
                    const int up = random.between(-1, 1);
                    const int east = up == 0 ? random.between(-1, 1) : 0;
                    const int south = up == 0 && east == 0 ? 1 : 0;
                    const Cell at = {x + east, y + south, level + up};
                    if (at.level < 0 || at.level >= map.levels || !map.contains(at.x, at.y) ||
                        world.blueprints[map.cell(at.x, at.y, at.level)].hasPortals)
                        continue;
                    map.setCell(at.x, at.y, at.level, kin);
                }
            }
        }
    }
}

void changeMovers(Random& random, World& world) {
    bool join = true;
    Coordinate rise;
    for (std::size_t i = 1; i < world.blueprints.size(); ++i) {
        CellBlueprint& part = world.blueprints[i];
        if (part.mover < 0) continue;
        if (part.mover != world.blueprints[i - 1].mover) {
            join = !random.oneIn(2);
            rise = {random.oneIn(3) ? 8192 * random.below(8) : random.below(65536)};
        }
        part.join = part.join && join;
        part.textureRise = rise;
    }
}

void addUneven(Random& random, World& world, bool coarse) {
    const auto height = [&] {
        return coarse ? random.between(0, 8) * 8192 : random.between(0, 65536);
    };
    for (Map& map : world.maps) {
        for (int i = random.between(4, 24); i > 0; --i) {
            const Cell cell = anyCell(random, map);
            const BlueprintId shape = map.cell(cell.x, cell.y, cell.level);
            const bool alongX = random.oneIn(2);
            const int step = random.oneIn(2) ? 1 : -1;
            const Cell at = {cell.x + (alongX ? step : 0), cell.y + (alongX ? 0 : step),
                             cell.level};
            const int low = height();
            const int high = height();
            if (low == high || !map.contains(at.x, at.y)) continue;
            const CellBlueprint& block = world.blueprints[shape];
            const CellBlueprint& there = world.blueprints[map.cell(at.x, at.y, at.level)];
            if (!block.seeThrough || !block.join || block.isWater || block.hasPortals ||
                block.mover >= 0 || there.hasPortals || there.mover >= 0)
                continue;
            const BlueprintId id = addInstance(world, shape);
            CellBlueprint& part = world.blueprints[id];
            part.mover = 20000 + static_cast<int>(id);
            part.bottom = {std::min(low, high)};
            part.top = {std::max(low, high)};
            map.setCell(at.x, at.y, at.level, id);
        }
    }
}

namespace {

// One row of cells along an axis from a place on, in which a block of that shape reaches from `low`
// to `high` along the axis. Its parts are one mover.
struct Slider {
    Axis axis;
    Cell from;
    int cells;
    Coordinate low;
    Coordinate high;
    BlueprintId shape;
    int mover;
    int motion;
    Coordinate offset;
};

void placeSlider(World& world, Map& map, const Slider& slider) {
    Cell at = slider.from;
    int& place = slider.axis == Axis::x ? at.x : at.y;
    for (int i = 0; i < slider.cells; ++i, ++place) {
        if (!map.contains(at.x, at.y)) return;
        const CellBlueprint& there = world.blueprints[map.cell(at.x, at.y, at.level)];
        if (there.hasPortals || there.mover >= 0) return;
        const BlueprintId id = addInstance(world, slider.shape);
        CellBlueprint& part = world.blueprints[id];
        const auto within = [&](Coordinate edge) {
            return std::clamp(edge - tileEdge(i), Coordinate{0}, tileEdge(1));
        };
        const bool alongX = slider.axis == Axis::x;
        (alongX ? part.plan.west : part.plan.north) = within(slider.low);
        (alongX ? part.plan.east : part.plan.south) = within(slider.high);
        (alongX ? part.textureEast : part.textureSouth) = slider.offset;
        part.mover = slider.mover;
        part.motion = slider.motion;
        map.setCell(at.x, at.y, at.level, id);
        const bool isEmpty = within(slider.high) <= within(slider.low);
        if (isEmpty) map.occupied[map.tileIndex(at.x, at.y)] &= ~(1u << at.level);
    }
}

}  // namespace

void addSliders(Random& random, World& world, bool coarse) {
    const int shapes = static_cast<int>(world.blueprints.size());
    const int motions = static_cast<int>(world.motions.size());
    for (const Axis axis : {Axis::x, Axis::y}) {
        world.motions.emplace_back();
        world.motions.back().axis = axis;
    }
    for (Map& map : world.maps) {
        for (int i = random.between(1, 5); i > 0; --i) {
            Slider slider;
            slider.axis = random.oneIn(2) ? Axis::x : Axis::y;
            slider.from = anyCell(random, map);
            slider.shape = static_cast<BlueprintId>(random.between(1, shapes - 1));
            const CellBlueprint& shape = world.blueprints[slider.shape];
            if (shape.hasPortals || shape.mover >= 0 || shape.isWater ||
                shape.plan.half != Half::none)
                continue;
            slider.mover = 5000 + static_cast<int>(world.blueprints.size());
            slider.motion = motions + static_cast<int>(slider.axis);
            const int fraction = coarse ? random.below(8) * 8192 : random.below(65536);
            const int levels = random.between(1, std::min(2, map.levels - slider.from.level));
            slider.offset = {random.oneIn(4) ? 0 : fraction};
            for (int level = 0; level < levels; ++level, ++slider.from.level) {
                slider.cells = random.between(1, 4);
                const int length = random.oneIn(4) ? random.between(4096, 65536)
                                                   : 65536 * std::max(1, slider.cells - 1);
                slider.low = {fraction};
                slider.high = {fraction + length};
                placeSlider(world, map, slider);
            }
        }
    }
    markPlans(world);
}

void widenSliders(World& world) {
    for (Map& map : world.maps) {
        for (int y = map.depth - 1; y >= 0; --y) {
            for (int x = map.width - 1; x >= 0; --x) {
                for (int level = 0; level < map.levels; ++level) {
                    const std::size_t cell = map.cellIndex(x, y, level);
                    const CellBlueprint& block = world.blueprints[map.cells[cell]];
                    if (!movesSideways(world, block) || block.slopes.any() || block.mover % 2 != 0)
                        continue;
                    const Axis axis = world.motions[static_cast<std::size_t>(block.motion)].axis;
                    const int besideX = axis == Axis::x ? x : x + 1;
                    const int besideY = axis == Axis::x ? y + 1 : y;
                    if (!map.contains(besideX, besideY)) continue;
                    const std::size_t beside = map.cellIndex(besideX, besideY, level);
                    if (map.cells[beside] != kEmptyCell) continue;
                    const bool isEmpty = !map.isOccupied(x, y, level);
                    map.setCell(besideX, besideY, level, map.cells[cell]);
                    if (isEmpty) map.occupied[map.tileIndex(besideX, besideY)] &= ~(1u << level);
                }
            }
        }
    }
}

bool isExitFromLevelFace(const World& world, int map, int x, int y) {
    const auto leadsHere = [&](PortalId id) {
        if (id == kNoPortal) return false;
        const Portal& portal = world.portals[id];
        return portal.toMap == map && portal.toX == x && portal.toY == y;
    };
    return std::any_of(world.blueprints.begin(), world.blueprints.end(), [&](const auto& block) {
        return leadsHere(block.face(Face::top).portal) ||
               leadsHere(block.face(Face::bottom).portal);
    });
}

namespace {

// Whether rays come out of a roof or an underside in the tile, or its ceiling is between two
// heights.
bool isTileTaken(const World& world, int mapIndex, const Cell& cell, Coordinate low,
                 Coordinate high) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    return isExitFromLevelFace(world, mapIndex, cell.x, cell.y) ||
           (!map.ceiling.tiles.empty() && map.ceiling.height > low && map.ceiling.height < high);
}

// A shape of slopes, over its whole plan.
CellBlueprint anyRamp(Random& random, const CellBlueprint& from, bool coarse) {
    CellBlueprint ramp = from;
    const auto height = [&] {
        return Coordinate{coarse ? random.between(0, 8) * 8192 : random.between(0, 65536)};
    };
    Slant bottom;
    Slant top;
    do {
        bottom.from = random.oneIn(2) ? Coordinate{} : height();
        bottom.to = random.oneIn(2) ? bottom.from : height();
        top.from = height();
        top.to = random.oneIn(4) ? top.from : height();
    } while (bottom.from > top.from || bottom.to > top.to ||
             (bottom.from == top.from && bottom.to == top.to) ||
             (bottom.isLevel() && top.isLevel()));
    ramp.slopes = slopesTo(static_cast<Face>(random.below(4)), bottom, top);
    ramp.bottom = bottom.least();
    ramp.top = top.most();
    for (FaceBlueprint& face : ramp.faces) face.lamp = kNoLamp;
    if (!top.isLevel()) ramp.faces[static_cast<std::size_t>(Face::top)].mirror = 0;
    return ramp;
}

// A wedge on its level's base, along the axis. A part of it that has gone on sideways may dip below
// the base where light sees it: a bit longer than it is.
CellBlueprint anyWedge(Random& random, const CellBlueprint& from, Axis axis) {
    CellBlueprint wedge = from;
    const Face ahead = axis == Axis::x ? Face::east : Face::south;
    const Face back = axis == Axis::x ? Face::west : Face::north;
    wedge.bottom = {};
    wedge.top = {random.between(1, 4) * 16384};
    wedge.slopes = slopesTo(random.oneIn(4) ? ahead : back, {}, {Coordinate{}, wedge.top});
    wedge.faces[static_cast<std::size_t>(Face::top)].mirror = 0;
    return wedge;
}

// What two cells along the axis, `place` 0 and 1, hold of a ramp that has gone on from the first by
// an offset. Heights are those of the cell.
CellBlueprint partOfRamp(const CellBlueprint& ramp, Axis axis, Coordinate offset, int place) {
    CellBlueprint part = ramp;
    const Coordinate way = offset - tileEdge(place);
    const auto within = [&](Coordinate edge) {
        return std::clamp(edge + way, Coordinate{0}, tileEdge(1));
    };
    Coordinate& low = axis == Axis::x   ? part.plan.west
                      : axis == Axis::y ? part.plan.north
                                        : part.bottom;
    Coordinate& high = axis == Axis::x   ? part.plan.east
                       : axis == Axis::y ? part.plan.south
                                         : part.top;
    low = within(low);
    high = within(high);
    for (Slant* const slant : {&part.slopes.bottom, &part.slopes.top}) {
        if (axis == Axis::z) {
            slant->from = slant->from + way;
            slant->to = slant->to + way;
        } else if (part.slopes.alongX == (axis == Axis::x) && !slant->isLevel()) {
            slant->shift = way;
        }
    }
    (axis == Axis::x   ? part.textureEast
     : axis == Axis::y ? part.textureSouth
                       : part.textureRise) = offset;
    Slant& top = part.slopes.top;
    Slant& bottom = part.slopes.bottom;
    if (std::min(top.from, top.to) >= tileEdge(1)) top = {tileEdge(1), tileEdge(1)};
    if (std::max(bottom.from, bottom.to) <= Coordinate{0}) bottom = {};
    return part;
}

}  // namespace

void addRamps(Random& random, World& world, bool coarse, bool wedges) {
    const int shapes = static_cast<int>(world.blueprints.size());
    const int motions = static_cast<int>(world.motions.size());
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        world.motions.emplace_back();
        world.motions.back().axis = axis;
    }
    for (int m = 0; m < static_cast<int>(world.maps.size()); ++m) {
        Map& map = world.maps[static_cast<std::size_t>(m)];
        for (int i = random.between(3, 8) * (wedges ? 3 : 1); i > 0; --i) {
            const bool isSideways = wedges || random.oneIn(3);
            const Axis axis = isSideways ? (random.oneIn(2) ? Axis::x : Axis::y) : Axis::z;
            Cell from = anyCell(random, map);
            if (wedges) from.level = 0;
            auto shape = static_cast<BlueprintId>(random.between(1, shapes - 1));
            if (random.oneIn(2)) {  // rather glass, through which one sees from part to part
                for (int tries = 0; tries < 8 && !world.blueprints[shape].seeThrough; ++tries)
                    shape = static_cast<BlueprintId>(random.between(1, shapes - 1));
            }
            const CellBlueprint& like = world.blueprints[shape];
            const Coordinate offset = {coarse ? random.below(8) * 8192 : random.below(65536)};
            const int wide = random.between(1, 2);
            if (like.hasPortals || like.mover >= 0 || like.isWater || like.plan.half != Half::none)
                continue;
            CellBlueprint ramp =
                wedges ? anyWedge(random, like, axis) : anyRamp(random, like, coarse);
            ramp.origin = like.origin == kEmptyCell ? shape : like.origin;
            ramp.mover = 9000 + static_cast<int>(world.blueprints.size());
            ramp.motion = motions + static_cast<int>(axis);
            // Two cells along the axis, in one or two rows beside each other
            std::vector<Cell> cells;
            bool isTaken = false;
            for (int place = 0; place < 2 * wide; ++place) {
                const int along = place % 2;
                const int beside = place / 2;
                const Cell at = {from.x + (axis == Axis::x   ? along
                                           : axis == Axis::z ? beside
                                                             : 0),
                                 from.y + (axis == Axis::y   ? along
                                           : axis == Axis::x ? beside
                                                             : 0),
                                 from.level + (axis == Axis::z   ? along
                                               : axis == Axis::y ? beside
                                                                 : 0)};
                const CellBlueprint& there = world.blueprints[map.cell(at.x, at.y, at.level)];
                isTaken = isTaken || !map.contains(at.x, at.y) || at.level >= map.levels ||
                          there.hasPortals || there.mover >= 0 ||
                          isTileTaken(world, m, at, tileEdge(at.level), tileEdge(at.level + 1));
                cells.push_back(at);
            }
            if (isTaken) continue;
            const auto first = static_cast<BlueprintId>(world.blueprints.size());
            for (int along = 0; along < 2; ++along)
                world.blueprints.push_back(partOfRamp(ramp, axis, offset, along));
            for (std::size_t k = 0; k < cells.size(); ++k) {
                const Cell& at = cells[k];
                const auto id = static_cast<BlueprintId>(first + k % 2);
                const CellBlueprint& part = world.blueprints[id];
                map.setCell(at.x, at.y, at.level, id);
                if (part.top <= part.bottom || part.plan.east <= part.plan.west ||
                    part.plan.south <= part.plan.north)
                    map.occupied[map.tileIndex(at.x, at.y)] &= ~(1u << at.level);
            }
        }
    }
    markPlans(world);
}

}  // namespace slicecast::judge

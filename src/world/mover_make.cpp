// Finds the movers of a world and gives each blueprints of its own.
#include "base/number_text.h"
#include "base/sort.h"
#include "base/task_list.h"
#include "base/words.h"
#include "world/mover.h"
#include "world/moving_cells.h"
#include "world/world.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace slicecast {
namespace {

// The cells of a shaft in the scene, the lowest first, and their blueprints.
struct Run {
    CellPlace at;
    std::vector<BlueprintId> blueprints;

    // Shafts are shared by runs in the same place along the axis, between which there is no order.
    bool isBefore(const Run& other, Axis axis) const {
        const int place = placeIn(axis);
        const int otherPlace = other.placeIn(axis);
        return place != otherPlace ? place < otherPlace : blueprints < other.blueprints;
    }
    int placeIn(Axis axis) const {
        CellPlace cell = at;
        return placeAlong(cell, axis);
    }
    int lastIn(Axis axis) const { return placeIn(axis) + static_cast<int>(blueprints.size()) - 1; }
};

// A tile of a map.
struct MapTile {
    int map = 0;
    int x = 0;
    int y = 0;

    friend auto operator<=>(const MapTile&, const MapTile&) = default;
};

// Sorted: the tiles where portals in roofs and undersides lead.
std::vector<MapTile> exitsOfLevelFaces(const World& world) {
    std::vector<MapTile> exits;
    for (const CellBlueprint& block : world.blueprints) {
        for (const Face face : {Face::top, Face::bottom}) {
            const PortalId id = block.face(face).portal;
            if (id == kNoPortal) continue;
            const Portal& portal = world.portals[id];
            exits.push_back({portal.toMap, portal.toX, portal.toY});
        }
    }
    mergeSort(exits, std::less<>());
    return exits;
}

// A mover that is being made.
struct InMaking {
    Mover mover;
    std::vector<CellPlace> cells = {};     // of a run follow each other
    std::size_t next = 0;                  // in `cells`
    std::vector<Run> runs = {};            // of the shafts
    std::vector<std::size_t> sorted = {};  // indices into it
};

std::string numberText(Coordinate number) {
    std::string text(fixedText(number.value(), 6));
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

// How a fault names the axis.
std::string_view axisName(Axis axis) {
    return axis == Axis::x ? "x" : axis == Axis::y ? "y" : "height";
}

}  // namespace

struct MoverMaker::Work {
    World& world;
    TaskList& tasks;
    std::vector<BlueprintId> kinds;
    std::vector<MapTile> exits;                       // see exitsOfLevelFaces
    std::size_t cells = kMaxMovingCells;              // remaining
    std::vector<std::vector<CellPlace>> groups = {};  // of the map
    std::size_t group = 0;                            // the next one
    std::optional<InMaking> making = {};
    std::size_t placesDone = 0;  // in the task
    std::size_t partsMade = 0;
    bool isOver = false;  // after a fault that ends it
    std::vector<PlacingFault> faults = {};

    void addFault(int map, const CellPlace& at, std::string found, std::string expected) {
        faults.push_back({map, at.x, at.y, at.level, std::move(found), std::move(expected)});
    }
    std::string blockOf(BlueprintId id) const {
        return words("the moving block \"", world.blueprints[id].name, "\"");
    }

    void beginMap(std::size_t mapIndex);
    bool makeSome(std::size_t mapIndex);
    void end();
    void beginMover(int mapIndex);
    bool makeNextRun(int mapIndex);
    bool makeShaft(int mapIndex, const Run& run, const Motion& motion, int mover, Shaft& shaft);
    bool findReach(int mapIndex, const Run& run, const Motion& motion, Shaft& shaft);
    bool takeRun(int mapIndex, const Run& run, const Motion& motion, Shaft& shaft);
    bool hasRoomForSlopes(int mapIndex, const Run& run, const Motion& motion,
                          const CellPlace& cell);
};

// Sets a shaft's extent, its places and blueprints.
bool MoverMaker::Work::makeShaft(int mapIndex, const Run& run, const Motion& motion, int mover,
                                 Shaft& shaft) {
    const std::string block = blockOf(run.blueprints[0]);
    CellBlueprint lowest = world.blueprints[run.blueprints.front()];
    CellBlueprint highest = world.blueprints[run.blueprints.back()];
    if (const Slopes& slopes = lowest.slopes;
        slopes.any() && run.blueprints.size() > 1 &&
        (!motion.isSideways() || slopes.alongX == (motion.axis == Axis::x))) {
        addFault(mapIndex, run.at,
                 motion.isSideways() ? words(block, " in a row along its \"rise\"")
                                     : words(block, " stacked, with slopes between its parts"),
                 motion.isSideways() ? "a motion across the \"rise\", or one tile alone"
                                     : "level moving blocks where they are stacked");
        return false;
    }
    for (std::size_t i = 0; i + 1 < run.blueprints.size(); ++i) {
        CellBlueprint part = world.blueprints[run.blueprints[i]];
        CellBlueprint next = world.blueprints[run.blueprints[i + 1]];
        if (highEdge(part, motion.axis) == tileEdge(1) &&
            lowEdge(next, motion.axis) == Coordinate{0})
            continue;
        addFault(mapIndex, run.at,
                 words(block, motion.isSideways() ? " in a row" : " stacked",
                       " with a gap between its parts"),
                 motion.isSideways()
                     ? words("a \"plan\" that goes on along ", axisName(motion.axis),
                             " where moving blocks touch")
                     : "a bottom of 0 and a top of 1 where moving blocks are stacked");
        return false;
    }
    shaft.slopes = lowest.slopes;
    shaft.low = tileEdge(run.placeIn(motion.axis)) + lowEdge(lowest, motion.axis);
    shaft.high = tileEdge(run.lastIn(motion.axis)) + highEdge(highest, motion.axis);
    if (!findReach(mapIndex, run, motion, shaft)) return false;

    // A blueprint for each place
    const std::size_t parts = static_cast<std::size_t>(shaft.last - shaft.first + 1);
    partsMade += parts;
    if (partsMade > kMaxMoverParts ||
        world.blueprints.size() + parts > static_cast<std::size_t>(kMaxBlueprints)) {
        addFault(mapIndex, run.at,
                 partsMade > kMaxMoverParts
                     ? words("more than ", kMaxMoverParts, " parts of moving blocks")
                     : words(block, " whose parts make more than ", kMaxBlueprints, " blueprints"),
                 motion.isSideways()
                     ? "fewer moving blocks and gates, or fewer tiles that they reach"
                     : "fewer moving blocks and gates, or fewer levels that they reach");
        return false;
    }
    shaft.firstPart = static_cast<BlueprintId>(world.blueprints.size());
    for (int place = shaft.first; place <= shaft.last; ++place) {
        const int source = std::clamp(place, run.placeIn(motion.axis), run.lastIn(motion.axis)) -
                           run.placeIn(motion.axis);
        CellBlueprint part = instanceOf(world, run.blueprints[static_cast<std::size_t>(source)]);
        lowEdge(part, motion.axis) = Coordinate{0};
        highEdge(part, motion.axis) = tileEdge(1);
        part.mover = mover;
        world.blueprints.push_back(std::move(part));
    }
    return true;
}

// Sets the places that a shaft reaches, which must lie in the map.
bool MoverMaker::Work::findReach(int mapIndex, const Run& run, const Motion& motion, Shaft& shaft) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    const std::string block = blockOf(run.blueprints[0]);
    const Coordinate least = std::min(motion.from, motion.to);
    const Coordinate most = std::max(motion.from, motion.to);
    const Coordinate lowest = motion.edges == MovingEdges::high ? shaft.low : shaft.low + least;
    const Coordinate highest = motion.edges == MovingEdges::low ? shaft.high : shaft.high + most;
    const int end = motion.axis == Axis::x   ? map.width
                    : motion.axis == Axis::y ? map.depth
                                             : map.levels;
    if (lowest < Coordinate{0} || highest > tileEdge(end)) {
        addFault(mapIndex, run.at,
                 words(block, " that moves from ", axisName(motion.axis), " ", numberText(lowest),
                       " to ", numberText(highest)),
                 motion.isSideways()
                     ? words("a motion that stays in the map, from ", axisName(motion.axis),
                             " 0 to ", end)
                     : words("a motion that stays between 0 and the map's ", end, " levels"));
        return false;
    }
    if (lowest >= highest) {
        addFault(mapIndex, run.at,
                 motion.isSideways() ? words(block, " whose edges never part")
                                     : words(block, " whose top never gets above its bottom"),
                 "a motion during which the block is visible");
        return false;
    }
    shaft.first = std::min(run.placeIn(motion.axis), lowest.tile());
    shaft.last = std::max(run.lastIn(motion.axis), Coordinate{highest.raw - 1}.tile());
    return true;
}

// Whether neither a ceiling nor the rays of a portal begin between the lowest and the highest point
// of a block with slopes that comes to a cell.
bool MoverMaker::Work::hasRoomForSlopes(int mapIndex, const Run& run, const Motion& motion,
                                        const CellPlace& cell) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    const auto block = [&] { return words(blockOf(run.blueprints[0]), " with slopes"); };
    const auto where = [&] { return words(" tile (", cell.x, ", ", cell.y, ")"); };
    const CellBlueprint& shape = world.blueprints[run.blueprints[0]];
    const bool isUpright = !motion.isSideways();
    const Coordinate least = isUpright ? std::min(motion.from, motion.to) : Coordinate{};
    const Coordinate most = isUpright ? std::max(motion.from, motion.to) : Coordinate{};
    const Ceiling& ceiling = map.ceiling;
    if (!ceiling.tiles.empty() && ceiling.tiles[map.tileIndex(cell.x, cell.y)] != kNoTexture &&
        ceiling.height > tileEdge(run.at.level) + shape.bottom + least &&
        ceiling.height < tileEdge(run.at.level) + shape.top + most) {
        addFault(mapIndex, run.at, words(block(), " that moves through the ceiling of", where()),
                 "a motion above or below the ceiling, or none there");
        return false;
    }
    if (!std::binary_search(exits.begin(), exits.end(), MapTile{mapIndex, cell.x, cell.y}))
        return true;
    addFault(mapIndex, run.at,
             words(block(), " that moves to", where(),
                   ", where a portal in a roof or an underside leads"),
             "a motion elsewhere, or a level block");
    return false;
}

// Takes the cells that a run reaches, which must be empty except for its own.
bool MoverMaker::Work::takeRun(int mapIndex, const Run& run, const Motion& motion, Shaft& shaft) {
    const Axis axis = motion.axis;
    Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    const std::size_t reached =
        static_cast<std::size_t>(shaft.last - shaft.first + 1) - run.blueprints.size();
    if (reached > cells) {
        addFault(mapIndex, run.at,
                 words("moving blocks that reach more than ", kMaxMovingCells, " cells"),
                 "fewer or smaller ones");
        return false;
    }
    cells -= reached;
    CellPlace cell = run.at;
    int& place = placeAlong(cell, axis);
    for (place = shaft.first; place <= shaft.last; ++place) {
        const BlueprintId there = map.cell(cell.x, cell.y, cell.level);
        const bool isOwn = place >= run.placeIn(axis) && place <= run.lastIn(axis);
        if (!isOwn && there != kEmptyCell) {
            const CellBlueprint& other = world.blueprints[there];
            const std::string where = axis == Axis::z
                                          ? words(" on level ", place)
                                          : words(" in tile (", cell.x, ", ", cell.y, ")");
            addFault(
                mapIndex, run.at,
                words(blockOf(run.blueprints[0]), " that runs into \"", other.name, "\"", where),
                other.mover >= 0 ? "moving blocks that do not reach each other"
                                 : "empty cells wherever it moves");
            return false;
        }
        if (shaft.slopes.any() && !hasRoomForSlopes(mapIndex, run, motion, cell)) return false;
        map.setChangingCell(cell.x, cell.y, cell.level,
                            static_cast<BlueprintId>(shaft.firstPart + (place - shaft.first)));
    }
    place = shaft.first;
    shaft.runs.push_back({static_cast<std::uint32_t>(map.tileIndex(cell.x, cell.y)), cell.level});
    return true;
}

void MoverMaker::Work::beginMover(int mapIndex) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    making.emplace();
    making->cells = std::move(groups[group++]);
    const CellPlace& first = making->cells[0];
    Mover& mover = making->mover;
    mover.map = mapIndex;
    mover.motion = world.blueprints[map.cell(first.x, first.y, first.level)].motion;
    mover.west = mover.east = first.x;
    mover.north = mover.south = first.y;
    const Axis axis = world.motions[static_cast<std::size_t>(mover.motion)].axis;
    mergeSort(making->cells, [axis](CellPlace a, CellPlace b) {
        const int placeA = std::exchange(placeAlong(a, axis), 0);
        const int placeB = std::exchange(placeAlong(b, axis), 0);
        return a != b ? a < b : placeA < placeB;
    });
}

// False if it has a fault.
bool MoverMaker::Work::makeNextRun(int mapIndex) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    Mover& mover = making->mover;
    const std::vector<CellPlace>& places = making->cells;
    std::size_t& i = making->next;
    std::vector<Run>& runs = making->runs;
    std::vector<std::size_t>& sorted = making->sorted;
    const Motion& motion = world.motions[static_cast<std::size_t>(mover.motion)];
    const Axis axis = motion.axis;
    Run run = {places[i], {}};
    CellPlace next = run.at;
    for (; i < places.size() && places[i] == next; ++i, ++placeAlong(next, axis))
        run.blueprints.push_back(map.cell(next.x, next.y, next.level));
    // Its shaft, shared by all places with the same run
    const auto known =
        std::lower_bound(sorted.begin(), sorted.end(), run,
                         [&](std::size_t a, const Run& b) { return runs[a].isBefore(b, axis); });
    const bool isNew = known == sorted.end() || run.isBefore(runs[*known], axis);
    const std::size_t number = isNew ? runs.size() : *known;
    if (isNew) {
        mover.shafts.emplace_back();
        if (!makeShaft(mapIndex, run, motion, static_cast<int>(world.movers.size()),
                       mover.shafts.back()))
            return false;
        sorted.insert(known, number);
        runs.push_back(run);
    }
    Shaft& shaft = mover.shafts[number];
    if (!takeRun(mapIndex, run, motion, shaft)) return false;
    const bool alongX = axis == Axis::x;
    const bool alongY = axis == Axis::y;
    mover.west = std::min(mover.west, alongX ? shaft.first : run.at.x);
    mover.east = std::max(mover.east, alongX ? shaft.last : run.at.x);
    mover.north = std::min(mover.north, alongY ? shaft.first : run.at.y);
    mover.south = std::max(mover.south, alongY ? shaft.last : run.at.y);
    placesDone += static_cast<std::size_t>(shaft.last - shaft.first + 1) + run.blueprints.size();
    return true;
}

// Makes movers of the map's groups, for one task. False if none are left.
bool MoverMaker::Work::makeSome(std::size_t number) {
    const auto mapIndex = static_cast<int>(number);
    constexpr std::size_t kPlacesOfTask = 4096;
    placesDone = 0;
    while (placesDone < kPlacesOfTask) {
        if (!making) {
            if (group == groups.size() || faults.size() >= kMaxPlacingFaults) return false;
            if (world.movers.size() == kMaxMovers) {
                addFault(mapIndex, groups[group][0],
                         words("more than ", kMaxMovers,
                               " moving blocks, of which those that touch are one"),
                         words("at most ", kMaxMovers, " in a scene"));
                isOver = true;
                return false;
            }
            beginMover(mapIndex);
        }
        if (!makeNextRun(mapIndex)) {
            making.reset();
        } else if (making->next == making->cells.size()) {
            world.movers.push_back(std::move(making->mover));
            making.reset();
        }
    }
    return true;
}

void MoverMaker::Work::beginMap(std::size_t mapIndex) {
    if (isOver) return;
    groups.clear();
    group = 0;
    if (groupCells(world.maps[mapIndex], kinds, cells, groups)) {
        tasks.add<&Work::makeSome>(*this, mapIndex);
        return;
    }
    addFault(static_cast<int>(mapIndex), {},
             words("more than ", kMaxMovingCells, " cells of moving blocks"),
             "fewer or smaller ones");
    isOver = true;
}

void MoverMaker::Work::end() {
    if (faults.empty()) resetMovers(world);
}

MoverMaker::MoverMaker(World& world, TaskList& tasks)
    : work_(new Work{world, tasks, kindsOf(world, &CellBlueprint::motion), {}}) {
    const std::vector<BlueprintId>& kinds = work_->kinds;
    if (std::all_of(kinds.begin(), kinds.end(),
                    [](BlueprintId kind) { return kind == kEmptyCell; }))
        return;
    work_->exits = exitsOfLevelFaces(world);
    for (std::size_t map = 0; map < world.maps.size(); ++map)
        tasks.add<&Work::beginMap>(*work_, map);
    tasks.add<&Work::end>(*work_);
}

MoverMaker::~MoverMaker() = default;

std::vector<PlacingFault> MoverMaker::takeFaults() {
    return std::move(work_->faults);
}

std::vector<PlacingFault> makeMovers(World& world) {
    TaskList tasks;
    MoverMaker maker(world, tasks);
    tasks.doAll();
    return maker.takeFaults();
}

}  // namespace slicecast

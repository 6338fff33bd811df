// Finds the movers of a world and gives each blueprints of its own.
#include "base/number_text.h"
#include "base/words.h"
#include "world/mover.h"
#include "world/moving_cells.h"
#include "world/world.h"

#include <algorithm>
#include <string>

namespace slicecast {
namespace {

// The levels that a shaft's cells occupy in the scene, lowest first, and their blueprints.
struct Run {
    int firstLevel = 0;
    std::vector<BlueprintId> blueprints;

    int lastLevel() const { return firstLevel + static_cast<int>(blueprints.size()) - 1; }
    friend bool operator==(const Run&, const Run&) = default;
};

struct Maker {
    World& world;
    std::size_t cells = kMaxMovingCells;  // remaining
    std::vector<PlacingFault> faults;

    void addFault(int map, const CellPlace& at, std::string found, std::string expected) {
        faults.push_back({map, at.x, at.y, at.level, std::move(found), std::move(expected)});
    }
    std::string blockOf(BlueprintId id) const {
        return words("the moving block \"", world.blueprints[id].name, "\"");
    }

    void makeMover(int mapIndex, const std::vector<CellPlace>& group);
    bool makeShaft(int mapIndex, const CellPlace& at, const Run& run, const Motion& motion,
                   int mover, Shaft& shaft);
    bool takeTile(int mapIndex, const CellPlace& at, const Run& run, Shaft& shaft);
};

std::string heightText(Coordinate height) {
    std::string text(fixedText(height.value(), 6));
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

// Sets a shaft's extent, levels and blueprints. `at` is its lowest cell in its first tile.
bool Maker::makeShaft(int mapIndex, const CellPlace& at, const Run& run, const Motion& motion,
                      int mover, Shaft& shaft) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    const std::string block = blockOf(run.blueprints[0]);
    for (std::size_t i = 0; i + 1 < run.blueprints.size(); ++i) {
        if (world.blueprints[run.blueprints[i]].top == tileEdge(1) &&
            world.blueprints[run.blueprints[i + 1]].bottom == Coordinate{0})
            continue;
        addFault(mapIndex, at, words(block, " stacked with a gap between its parts"),
                 "a bottom of 0 and a top of 1 where moving blocks are stacked");
        return false;
    }
    shaft.low = tileEdge(run.firstLevel) + world.blueprints[run.blueprints.front()].bottom;
    shaft.high = tileEdge(run.lastLevel()) + world.blueprints[run.blueprints.back()].top;

    // Its range
    const Coordinate least = std::min(motion.from, motion.to);
    const Coordinate most = std::max(motion.from, motion.to);
    const Coordinate lowest = motion.edges == MovingEdges::top ? shaft.low : shaft.low + least;
    const Coordinate highest = motion.edges == MovingEdges::bottom ? shaft.high : shaft.high + most;
    if (lowest < Coordinate{0} || highest > tileEdge(map.levels)) {
        addFault(mapIndex, at,
                 words(block, " that moves from height ", heightText(lowest), " to ",
                       heightText(highest)),
                 words("a motion that stays between 0 and the map's ", map.levels, " levels"));
        return false;
    }
    if (lowest >= highest) {
        addFault(mapIndex, at, words(block, " whose top never gets above its bottom"),
                 "a motion during which the block is visible");
        return false;
    }
    shaft.firstLevel = std::min(run.firstLevel, lowest.tile());
    shaft.lastLevel = std::max(run.lastLevel(), Coordinate{highest.raw - 1}.tile());

    // A blueprint for each level
    const std::size_t parts = static_cast<std::size_t>(shaft.lastLevel - shaft.firstLevel + 1);
    if (world.blueprints.size() + parts > static_cast<std::size_t>(kMaxBlueprints)) {
        addFault(mapIndex, at,
                 words(block, " whose parts make more than ", kMaxBlueprints, " blueprints"),
                 "fewer moving blocks and gates, or fewer levels that they reach");
        return false;
    }
    shaft.firstPart = static_cast<BlueprintId>(world.blueprints.size());
    for (int level = shaft.firstLevel; level <= shaft.lastLevel; ++level) {
        const int source = std::clamp(level, run.firstLevel, run.lastLevel()) - run.firstLevel;
        CellBlueprint part = instanceOf(world, run.blueprints[static_cast<std::size_t>(source)]);
        part.bottom = Coordinate{0};
        part.top = tileEdge(1);
        part.mover = mover;
        world.blueprints.push_back(std::move(part));
    }
    return true;
}

// Takes a tile's cells in the shaft's range, which must be empty except for its own.
bool Maker::takeTile(int mapIndex, const CellPlace& at, const Run& run, Shaft& shaft) {
    Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    const std::size_t reached =
        static_cast<std::size_t>(shaft.lastLevel - shaft.firstLevel + 1) - run.blueprints.size();
    if (reached > cells) {
        addFault(mapIndex, at,
                 words("moving blocks that reach more than ", kMaxMovingCells, " cells"),
                 "fewer or smaller ones");
        return false;
    }
    cells -= reached;
    for (int level = shaft.firstLevel; level <= shaft.lastLevel; ++level) {
        const BlueprintId there = map.cell(at.x, at.y, level);
        const bool isOwn = level >= run.firstLevel && level <= run.lastLevel();
        if (!isOwn && there != kEmptyCell) {
            const CellBlueprint& other = world.blueprints[there];
            addFault(mapIndex, at,
                     words(blockOf(run.blueprints[0]), " that runs into \"", other.name,
                           "\" on level ", level),
                     other.mover >= 0 ? "moving blocks that do not reach each other"
                                      : "empty cells wherever it moves");
            return false;
        }
        map.setChangingCell(at.x, at.y, level,
                            static_cast<BlueprintId>(shaft.firstPart + (level - shaft.firstLevel)));
    }
    shaft.tiles.push_back(map.tileIndex(at.x, at.y));
    return true;
}

void Maker::makeMover(int mapIndex, const std::vector<CellPlace>& group) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    const int index = static_cast<int>(world.movers.size());
    Mover mover;
    mover.map = mapIndex;
    mover.motion = world.blueprints[map.cell(group[0].x, group[0].y, group[0].level)].motion;
    mover.west = mover.east = group[0].x;
    mover.north = mover.south = group[0].y;
    const Motion& motion = world.motions[static_cast<std::size_t>(mover.motion)];
    std::vector<Run> runs;  // of the shafts
    for (std::size_t i = 0; i < group.size();) {
        // A vertical run of cells
        const CellPlace at = group[i];
        Run run;
        run.firstLevel = at.level;
        for (; i < group.size() &&
               group[i] ==
                   CellPlace{at.x, at.y, run.firstLevel + static_cast<int>(run.blueprints.size())};
             ++i) {
            run.blueprints.push_back(map.cell(at.x, at.y, group[i].level));
        }
        // Its shaft, shared by all tiles with the same run
        const auto known = std::find(runs.begin(), runs.end(), run);
        const auto shaft = static_cast<std::size_t>(known - runs.begin());
        if (known == runs.end()) {
            mover.shafts.emplace_back();
            if (!makeShaft(mapIndex, at, run, motion, index, mover.shafts.back())) return;
            runs.push_back(run);
        }
        if (!takeTile(mapIndex, at, run, mover.shafts[shaft])) return;
        mover.west = std::min(mover.west, at.x);
        mover.east = std::max(mover.east, at.x);
        mover.north = std::min(mover.north, at.y);
        mover.south = std::max(mover.south, at.y);
    }
    world.movers.push_back(std::move(mover));
}

}  // namespace

std::vector<PlacingFault> makeMovers(World& world) {
    const std::vector<BlueprintId> kinds = kindsOf(world, &CellBlueprint::motion);
    if (std::all_of(kinds.begin(), kinds.end(),
                    [](BlueprintId kind) { return kind == kEmptyCell; }))
        return {};
    Maker maker{world, kMaxMovingCells, {}};
    for (std::size_t map = 0; map < world.maps.size(); ++map) {
        std::vector<std::vector<CellPlace>> groups;
        if (!groupCells(world.maps[map], kinds, maker.cells, groups)) {
            maker.addFault(static_cast<int>(map), {},
                           words("more than ", kMaxMovingCells, " cells of moving blocks"),
                           "fewer or smaller ones");
            break;
        }
        for (const std::vector<CellPlace>& group : groups) {
            if (maker.faults.size() < kMaxPlacingFaults)
                maker.makeMover(static_cast<int>(map), group);
        }
    }
    if (maker.faults.empty()) resetMovers(world);
    return std::move(maker.faults);
}

}  // namespace slicecast

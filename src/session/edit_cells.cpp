#include "session/edit_cells.h"

#include "base/hash.h"
#include "base/printable.h"
#include "base/sort.h"
#include "base/words.h"
#include "world/variants.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace slicecast {
namespace {

constexpr std::string_view kEmptySign = ".";

// When a scene is loaded, blocks that move, open or have portals get blueprints of their own with
// the same name.
std::string_view signOf(const World& world, const Map& map, BlueprintId id) {
    for (const LegendEntry& entry : map.legend) {
        if (entry.blueprint == id) return entry.sign;
    }
    for (const LegendEntry& entry : map.legend) {
        if (world.blueprints[entry.blueprint].name == world.blueprints[id].name) return entry.sign;
    }
    return kEmptySign;
}

// A mover has a blueprint in every place that it can reach. True if it stands there at rest.
bool isAtRest(const World& world, const CellBlueprint& part, BlueprintId id) {
    for (const Shaft& shaft : world.movers[static_cast<std::size_t>(part.mover)].shafts) {
        const int place = shaft.first + id - shaft.firstPart;
        if (place >= shaft.first && place <= shaft.last)
            return shaft.low < tileEdge(place + 1) && shaft.high > tileEdge(place);
    }
    return false;
}

// The kind of a block that cannot be edited; empty for a plain block.
const char* fixedKind(const CellBlueprint& blueprint) {
    if (blueprint.mover >= 0 || blueprint.motion >= 0) return "a block that moves";
    if (blueprint.gate >= 0) return "a gate";
    return blueprint.hasPortals ? "a block with a portal" : "";
}

std::string legendText(const Map& map) {
    std::string text = ".";
    for (const LegendEntry& entry : map.legend) add(text, {" ", entry.sign});
    return text;
}

bool isWithin(int number, int count) {
    return number >= 0 && number < count;
}

std::string outside(const char* what, int found, int count) {
    return words("found ", what, " ", found, ", expected a whole number from 0 to ", count - 1);
}

// Nothing for a sign that the legend lacks.
std::optional<BlueprintId> blueprintOf(const Map& map, std::string_view sign) {
    if (sign == kEmptySign || sign == " ") return kEmptyCell;
    for (const LegendEntry& entry : map.legend) {
        if (entry.sign == sign) return entry.blueprint;
    }
    return std::nullopt;
}

}  // namespace

std::string_view signAt(const World& world, const CellAt& at) {
    const Map& map = world.maps[static_cast<std::size_t>(at.map)];
    const BlueprintId id = map.cells[map.cellIndex(at.x, at.y, at.level)];
    const CellBlueprint& blueprint = world.blueprints[id];
    const bool isEmpty =
        id == kEmptyCell || (blueprint.mover >= 0 && !isAtRest(world, blueprint, id));
    return isEmpty ? kEmptySign : signOf(world, map, id);
}

std::string cellRow(const World& world, int mapIndex, int level, int y) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    std::string row;
    BlueprintId last = kEmptyCell;
    std::string_view sign = kEmptySign;
    for (int x = 0; x < map.width; ++x) {
        const BlueprintId id = map.cells[map.cellIndex(x, y, level)];
        if (id != last) sign = signAt(world, {mapIndex, level, x, y});
        last = id;
        row += sign;
    }
    return row;
}

std::string CellEdits::set(World& world, int mapIndex, std::span<const CellChange> changes) {
    const int maps = static_cast<int>(world.maps.size());
    if (!isWithin(mapIndex, maps)) return outside("map", mapIndex, maps);
    Map& map = world.maps[static_cast<std::size_t>(mapIndex)];

    std::vector<BlueprintId> blueprints;
    blueprints.reserve(changes.size());
    std::optional<BlueprintId> known;  // of the sign before
    std::string_view last;
    for (const auto& [level, x, y, sign] : changes) {
        if (!isWithin(level, map.levels)) return outside("level", level, map.levels);
        if (!isWithin(x, map.width)) return outside("x", x, map.width);
        if (!isWithin(y, map.depth)) return outside("y", y, map.depth);
        if (!known || sign != last) known = blueprintOf(map, sign);
        last = sign;
        if (!known) {
            return words("found \"", printable(sign), "\", expected one of ", legendText(map),
                         ", as in the map's legend");
        }
        const BlueprintId blueprint = variantAt(*known, world.blueprints[*known], x, y, level);
        const BlueprintId current = map.cells[map.cellIndex(x, y, level)];
        for (const BlueprintId id : {current, blueprint}) {
            const char* const kind = fixedKind(world.blueprints[id]);
            if (*kind == '\0') continue;
            return words("found ", kind, ", \"", world.blueprints[id].name,
                         id == current ? "\", in that cell" : "\", for that cell",
                         ", expected a block that stands still, without portals: the others are "
                         "set up when the scene is loaded");
        }
        blueprints.push_back(blueprint);
    }

    std::vector<Edit> made;
    made.reserve(changes.size());
    for (std::size_t i = 0; i < changes.size(); ++i) {
        const CellAt at = {mapIndex, changes[i].level, changes[i].x, changes[i].y};
        const std::size_t cell = map.cellIndex(at.x, at.y, at.level);
        made.push_back({mapIndex, cell, at, map.cells[cell]});
        map.setCell(at.x, at.y, at.level, blueprints[i]);
    }

    // Of several edits of a cell the first one knows the scene's block.
    const auto isBefore = [](const Edit& one, const Edit& other) { return one.isBefore(other); };
    std::vector<Edit> all;
    mergeSort(made, all, isBefore);
    all.clear();
    all.reserve(edits_.size() + made.size());
    std::merge(edits_.begin(), edits_.end(), made.begin(), made.end(), std::back_inserter(all),
               isBefore);
    all.erase(std::unique(all.begin(), all.end(),
                          [](const Edit& one, const Edit& other) { return one.isOf(other); }),
              all.end());
    std::erase_if(all, [&](const Edit& edit) {
        return edit.map == mapIndex && map.cells[edit.cell] == edit.before;
    });
    edits_ = std::move(all);
    return {};
}

void CellEdits::undo(World& world) {
    for (const Edit& edit : edits_) {
        world.maps[static_cast<std::size_t>(edit.map)].setCell(edit.at.x, edit.at.y, edit.at.level,
                                                               edit.before);
    }
    edits_.clear();
}

std::vector<EditedCell> CellEdits::list(const World& world) const {
    std::vector<EditedCell> cells;
    cells.reserve(edits_.size());
    for (const Edit& edit : edits_)
        cells.push_back({edit.at, world.maps[static_cast<std::size_t>(edit.map)].cells[edit.cell]});
    return cells;
}

// Nothing changes where nothing differs: what is known of the maps' light stays known.
void CellEdits::restore(World& world, std::span<const EditedCell> cells) {
    const std::vector<EditedCell> present = list(world);
    if (std::equal(cells.begin(), cells.end(), present.begin(), present.end())) return;
    undo(world);
    for (const EditedCell& cell : cells) {
        const CellAt& at = cell.at;
        Map& map = world.maps[static_cast<std::size_t>(at.map)];
        const std::size_t index = map.cellIndex(at.x, at.y, at.level);
        edits_.push_back({at.map, index, at, map.cells[index]});
        map.setCell(at.x, at.y, at.level, cell.now);
    }
}

void CellEdits::addTo(Hash& hash, const World& world) const {
    for (const Edit& edit : edits_) {
        hash.add(std::int64_t{edit.map});
        hash.add(static_cast<std::int64_t>(edit.cell));
        hash.add(std::int64_t{world.maps[static_cast<std::size_t>(edit.map)].cells[edit.cell]});
    }
}

}  // namespace slicecast

#include "world/moving_cells.h"

#include "base/name_index.h"
#include "base/sort.h"

#include <bit>
#include <functional>

namespace slicecast {
namespace {

constexpr CellPlace kNeighbours[] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                     {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};

}  // namespace

std::vector<BlueprintId> kindsOf(const World& world, int CellBlueprint::*index) {
    std::vector<BlueprintId> kinds(world.blueprints.size(), kEmptyCell);
    NameIndex firstOf;
    for (std::size_t id = 1; id < kinds.size(); ++id) {
        if (world.blueprints[id].*index >= 0)
            kinds[id] = static_cast<BlueprintId>(
                firstOf.add(world.blueprints[id].name, static_cast<std::uint32_t>(id)));
    }
    return kinds;
}

bool groupCells(const Map& map, const std::vector<BlueprintId>& kinds, std::size_t& limit,
                std::vector<std::vector<CellPlace>>& groups) {
    std::vector<bool> seen(map.cells.size());
    for (int x = 0; x < map.width; ++x) {
        for (int y = 0; y < map.depth; ++y) {
            for (std::uint32_t levels = map.occupied[map.tileIndex(x, y)]; levels != 0;
                 levels &= levels - 1) {
                const int level = std::countr_zero(levels);
                const BlueprintId kind = kinds[map.cell(x, y, level)];
                if (kind == kEmptyCell || seen[map.cellIndex(x, y, level)]) continue;
                std::vector<CellPlace> group = {{x, y, level}};
                seen[map.cellIndex(x, y, level)] = true;
                for (std::size_t i = 0; i < group.size(); ++i) {
                    if (group.size() > limit) return false;
                    const CellPlace at = group[i];
                    for (const CellPlace& step : kNeighbours) {
                        const CellPlace next = {at.x + step.x, at.y + step.y,
                                                at.level + step.level};
                        if (kinds[map.cell(next.x, next.y, next.level)] != kind) continue;
                        const std::size_t index = map.cellIndex(next.x, next.y, next.level);
                        if (seen[index]) continue;
                        seen[index] = true;
                        group.push_back(next);
                    }
                }
                limit -= group.size();
                mergeSort(group, std::less<>());
                groups.push_back(std::move(group));
            }
        }
    }
    return true;
}

}  // namespace slicecast

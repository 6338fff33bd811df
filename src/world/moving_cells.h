// Finds the cells that belong together as one mover or one gate.
#pragma once

#include "world/world.h"

#include <vector>

namespace slicecast {

struct CellPlace {
    int x = 0;
    int y = 0;
    int level = 0;

    friend auto operator<=>(const CellPlace&, const CellPlace&) = default;
};

// For each blueprint the first one of its name, since a blueprint may have got instances: what
// touches of one name belongs together. 0 where `CellBlueprint::*index` names nothing.
std::vector<BlueprintId> kindsOf(const World& world, int CellBlueprint::*index);

// The cells of a map in groups of one kind that touch along the axes, in the order of each group's
// first cell by x, y and level; so are those of a group. `kinds` is by blueprint, 0 for those that
// belong to no group. Nothing, and false, if they are more than `limit`, which is lowered by their
// number.
bool groupCells(const Map& map, const std::vector<BlueprintId>& kinds, std::size_t& limit,
                std::vector<std::vector<CellPlace>>& groups);

}  // namespace slicecast

// Finds the cells that form one mover or one gate.
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

// The place of a cell along an axis.
inline int& placeAlong(CellPlace& cell, Axis axis) {
    return axis == Axis::x ? cell.x : axis == Axis::y ? cell.y : cell.level;
}

// The ends of a block along an axis, within its cell.
inline Coordinate& lowEdge(CellBlueprint& block, Axis axis) {
    return axis == Axis::x ? block.plan.west : axis == Axis::y ? block.plan.north : block.bottom;
}
inline Coordinate& highEdge(CellBlueprint& block, Axis axis) {
    return axis == Axis::x ? block.plan.east : axis == Axis::y ? block.plan.south : block.top;
}

// For each blueprint the first one of its name, because instances share names and cells of one name
// belong together. 0 for blueprints whose `CellBlueprint::*index` is negative.
std::vector<BlueprintId> kindsOf(const World& world, int CellBlueprint::*index);

// The cells of a map in groups of one kind that touch along the axes. Groups are ordered by their
// first cell by x, y and level; so are the cells of a group. `kinds` maps blueprints to kinds, 0
// for no group. Lowers `limit` by the number of cells; returns false if they exceed it.
bool groupCells(const Map& map, const std::vector<BlueprintId>& kinds, std::size_t& limit,
                std::vector<std::vector<CellPlace>>& groups);

}  // namespace slicecast

// The cells of a running world as the characters of its scene, and what changes them.
//
//     cellRow(world, map, level, y)                       "#..s#"; a cell that is empty is '.'
//     edits.set(world, {map, level, x, y}, U'#');         "" on success, else what was wrong
//     edits.undo(world);                                  every cell is again as the scene has it
//
// Characters are those of the map's legend; where two stand for the same block the first is given.
// What moves is told where it stands at rest.
#pragma once

#include "world/world.h"

#include <cstddef>
#include <string>
#include <vector>

namespace slicecast {

class Hash;

struct CellAt {
    int map = 0;  // index into World::maps
    int level = 0;
    int x = 0;
    int y = 0;
};

// The map and the level exist, and the row. UTF-8.
std::string cellRow(const World& world, int map, int level, int y);

class CellEdits {
public:
    // Puts the block that a character stands for into a cell, or nothing for '.' and the space.
    // Refused, with nothing changed: a place outside the map, a character that its legend lacks,
    // and whatever was made when the scene was loaded: blocks that move, gates, and blocks with
    // portals, where they are or where they would come.
    std::string set(World& world, const CellAt& at, char32_t character);
    void undo(World& world);

    // Mixes in which cells differ from the scene's, and how.
    void addTo(Hash& hash, const World& world) const;

private:
    struct Edit {
        int map;
        std::size_t cell;  // Map::cellIndex
        CellAt at;
        BlueprintId before;  // the scene's
    };
    std::vector<Edit> edits_;  // by map and cell
};

}  // namespace slicecast

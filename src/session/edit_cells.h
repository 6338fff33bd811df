// Reads and changes the cells of a running world as the signs of its scene (scene/source_text.h).
//
//     cellRow(world, map, level, y)                       "#..s#"; '.' is an empty cell
//     signAt(world, {map, level, x, y})                   "#"
//     edits.set(world, {map, level, x, y}, "#");          "" on success, else a message
//     edits.set(world, map, changes);                     many cells: all of them or none
//     edits.undo(world);                                  restores the scene's cells
//
// Signs are those of the map's legend; if two stand for the same block, the first is given.
// Moving blocks appear where they stand at rest.
#pragma once

#include "slicecast/cell_change.h"
#include "world/world.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

class Hash;

struct CellAt {
    int map = 0;  // index into World::maps
    int level = 0;
    int x = 0;
    int y = 0;

    friend bool operator==(const CellAt&, const CellAt&) = default;
};

struct EditedCell {
    CellAt at;
    BlueprintId now = kEmptyCell;

    friend bool operator==(const EditedCell&, const EditedCell&) = default;
};

// Map, level and row must exist. UTF-8.
std::string cellRow(const World& world, int map, int level, int y);
// The cell must exist.
std::string_view signAt(const World& world, const CellAt& at);

class CellEdits {
public:
    // Puts the blocks of signs into cells, one after another; '.' and the space empty a cell.
    // Returns an empty text on success, else a message, and changes nothing: for a place outside
    // the map, for a sign that its legend lacks, and for blocks that are set up when the scene is
    // loaded. Those are blocks that move, gates, and blocks with portals, both in the cell and as
    // its new content. Takes the time of sorting the changes and of passing over all edits.
    std::string set(World& world, int map, std::span<const CellChange> changes);
    std::string set(World& world, const CellAt& at, std::string_view sign) {
        const CellChange change = {at.level, at.x, at.y, sign};
        return set(world, at.map, {&change, 1});
    }
    void undo(World& world);

    // The cells that differ from the scene's, with their blocks, and the same again.
    std::vector<EditedCell> list(const World& world) const;
    void restore(World& world, std::span<const EditedCell> cells);

    // Hashes which cells differ from the scene's, and how.
    void addTo(Hash& hash, const World& world) const;

private:
    struct Edit {
        int map;
        std::size_t cell;  // Map::cellIndex
        CellAt at;
        BlueprintId before;  // the scene's

        bool isOf(const Edit& other) const { return map == other.map && cell == other.cell; }
        bool isBefore(const Edit& other) const {
            return map != other.map ? map < other.map : cell < other.cell;
        }
    };
    std::vector<Edit> edits_;  // by map and cell
};

}  // namespace slicecast

#include "scene/limits.h"
#include "scene/readers.h"

#include <algorithm>
#include <vector>

namespace slicecast {
namespace {

// Counts how often each size occurs. The most frequent one wins; of equals, the first. All sizes
// beyond the limit count as one.
class Votes {
public:
    explicit Votes(int most) : votes_(static_cast<std::size_t>(most) + 2) {}
    void add(std::size_t size) {
        Vote& vote = votes_[std::min(size, votes_.size() - 1)];
        if (vote.count++ > 0) return;
        vote.size = size;
        vote.place = ++sizes_;
    }
    std::size_t winner() const {
        Vote best;
        for (const Vote& vote : votes_) {
            if (vote.count > best.count || (vote.count == best.count && vote.place < best.place))
                best = vote;
        }
        return best.size;
    }

private:
    struct Vote {
        std::size_t size = 0;
        int count = 0;
        int place = 0;  // among the sizes, as they came
    };
    std::vector<Vote> votes_;
    int sizes_ = 0;
};

// Checks that levels are arrays of arrays of texts, and finds the size that most of them have.
// Nothing if there is no row.
std::optional<GridSize> measure(Checker& checker, JsonValue value) {
    Votes widths(kMaxMapWidth);
    Votes depths(kMaxMapDepth);
    for (const JsonValue level : value) {
        if (!level.isArray()) {
            checker.refuse(level, "a level: an array of rows, or [] for an empty level");
            continue;
        }
        if (level.count() > 0) depths.add(level.count());
        for (const JsonValue row : level) {
            if (row.isText()) {
                widths.add(countSigns(row.text()));
            } else {
                checker.refuse(row, "a row: a text with one character for each tile");
            }
        }
    }
    const std::size_t width = widths.winner();
    const std::size_t depth = depths.winner();
    if (width == 0 || depth == 0) {
        checker.add(value, "no tiles", "at least one level with rows of characters");
        return std::nullopt;
    }
    if (width > static_cast<std::size_t>(kMaxMapWidth) ||
        depth > static_cast<std::size_t>(kMaxMapDepth)) {
        checker.add(value, {"a map of ", width, " x ", depth, " tiles"},
                    {"at most ", kMaxMapWidth, " x ", kMaxMapDepth});
        return std::nullopt;
    }
    return GridSize{static_cast<int>(width), static_cast<int>(depth)};
}

}  // namespace

void readLevels(Reading& reading, JsonValue value, const Legend& legend, Map& map) {
    Checker& checker = reading.checker;
    if (!value.isArray()) {
        checker.refuse(value, "an array of levels, each of them an array of rows");
        return;
    }
    bool isFlat = value.count() > 0;
    for (const JsonValue level : value) isFlat = isFlat && level.isText();
    if (isFlat) {
        checker.add(value, "an array of rows",
                    "an array of levels, each of them an array of rows: [[\"###\", \"#.#\"]]");
        return;
    }
    if (value.count() > static_cast<std::size_t>(kMaxLevels)) {
        checker.add(value, Counted{static_cast<std::int64_t>(value.count()), "level"},
                    {"at most ", kMaxLevels});
        return;
    }
    const std::optional<GridSize> size = measure(checker, value);
    if (!size) return;

    // Allocates only for a map within the limits.
    const int levels = static_cast<int>(value.count());
    const std::int64_t cells = std::int64_t{size->width} * size->depth * levels;
    reading.cells += cells;
    if (reading.cells > kMaxSceneCells) {
        checker.add(
            value,
            {"a map of ", Counted{cells, "cell"}, ", ", reading.cells, " with the maps before it"},
            {"at most ", kMaxSceneCells, " in all maps together"});
        reading.cells -= cells;
        return;
    }
    Map grid = makeMap(map.name, size->width, size->depth, levels, 0);
    map.width = grid.width;
    map.depth = grid.depth;
    map.levels = grid.levels;
    map.cells = std::move(grid.cells);
    map.occupied = std::move(grid.occupied);
    map.floor.tiles = std::move(grid.floor.tiles);

    // The cells, row by row.
    std::vector<std::uint16_t> ids;
    int level = -1;
    for (const JsonValue rows : value) {
        ++level;
        if (!rows.isArray() || rows.count() == 0) continue;
        if (rows.count() != static_cast<std::size_t>(size->depth)) {
            checker.add(rows,
                        {"a level of ", Counted{static_cast<std::int64_t>(rows.count()), "row"}},
                        {Counted{size->depth, "row"}, ", as in the other levels"});
        }
        int y = -1;
        for (const JsonValue row : rows) {
            ++y;
            if (!row.isText()) continue;
            ids.assign(static_cast<std::size_t>(size->width), kEmptyCell);
            readRow(checker, row, y, size->width, legend, ids);
            if (y >= size->depth) continue;
            for (int x = 0; x < size->width; ++x) {
                if (ids[static_cast<std::size_t>(x)] != kEmptyCell)
                    map.setCell(x, y, level, ids[static_cast<std::size_t>(x)]);
            }
        }
    }
}

}  // namespace slicecast

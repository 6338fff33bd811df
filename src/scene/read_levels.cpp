#include "base/later_text.h"
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

constexpr NumberRange kTimes = {1.0, kMaxLevels, false, "a whole number from 1 to 32"};
static_assert(kMaxLevels == 32, "as the words say");

constexpr const char* kLevels = "an array of levels";
constexpr const char* kLevel = "a level: an array of rows, or an object with \"fill\"";

// A rectangle of tiles that a level fills with one block; all tiles if it is not wide.
struct Filled {
    JsonValue value;
    int x = 0;
    int y = 0;
    int width = 0;
    int depth = 0;
    BlueprintId id = kEmptyCell;
};

struct Level {
    JsonValue value;
    int like;              // the level of which it is a copy, or itself
    FoundValue rows = {};  // over what fills it
    std::vector<Filled> filled = {};
};

// Reads what stands in "levels", and sets the cells. What is not inlined is needed by no scene
// whose levels are all rows.
class LevelReader {
public:
    LevelReader(Reading& reading, const Legend& legend)
        : reading_(reading), checker_(reading.checker), legend_(legend) {}

    void read(JsonValue value, FoundValue size, Map& map);

private:
    void addLevels(JsonValue list, bool mayRepeat);
    __attribute__((noinline)) void addRepeated(JsonValue value);
    void addLevel(JsonValue value);
    __attribute__((noinline)) void addFilled(Level& level);
    __attribute__((noinline)) void addRectangle(Level& level, JsonValue value);
    void measureRows(JsonValue rows, Votes& widths, Votes& depths);
    __attribute__((noinline)) std::optional<GridSize> readSize(JsonValue value);
    std::optional<GridSize> measure(JsonValue value, FoundValue size);
    std::int64_t filledCells(GridSize size);
    bool hasRoom(JsonValue value, std::int64_t cells, const char* noun, std::int64_t& sum,
                 std::int64_t most);
    __attribute__((noinline)) void fill(const Level& level, int number, Map& map);
    void setRows(const Level& level, int number, Map& map);
    __attribute__((noinline)) static void copy(int from, int to, Map& map);

    Reading& reading_;
    Checker& checker_;
    const Legend& legend_;
    std::vector<Level> levels_;  // at most kMaxLevels
    std::size_t count_ = 0;      // of all
};

// ---- The stack

void LevelReader::addLevels(JsonValue list, bool mayRepeat) {
    for (const JsonValue entry : list) {
        const bool isRepeated = entry.isObject() && (entry.find("repeat") || entry.find("levels"));
        if (!isRepeated) {
            addLevel(entry);
        } else if (mayRepeat) {
            addRepeated(entry);
        } else {
            checker_.add(entry, "levels that are repeated within others"_later, kLevel);
        }
    }
}

// { "repeat", "levels" }
void LevelReader::addRepeated(JsonValue value) {
    const auto fields = checker_.fields(value, {"repeat", "levels"}, "levels to repeat"_onFault);
    fields->require("repeat", kTimes.words);
    const int times = fields->wholeNumber("repeat", kTimes, 1);
    const auto list = fields->require("levels", kLevels);
    if (!list) return;
    if (!list->isArray() || list->count() == 0) return checker_.refuse(*list, kLevels);
    const std::size_t first = levels_.size();
    const std::size_t before = count_;
    addLevels(*list, false);
    const std::size_t end = levels_.size();
    count_ += (count_ - before) * static_cast<std::size_t>(times - 1);
    if (count_ > static_cast<std::size_t>(kMaxLevels)) return;
    for (int time = 1; time < times; ++time)
        for (std::size_t i = first; i < end; ++i)
            levels_.push_back({levels_[i].value, levels_[i].like});
}

void LevelReader::addLevel(JsonValue value) {
    if (++count_ > static_cast<std::size_t>(kMaxLevels)) return;
    levels_.push_back({value, static_cast<int>(levels_.size())});
    Level& level = levels_.back();
    if (value.isArray()) {
        level.rows = value;
    } else {
        addFilled(level);
    }
}

// { "fill", "rows" }
void LevelReader::addFilled(Level& level) {
    const auto fields =
        checker_.fields(level.value, {"fill", "rows"},
                        "a level: an array of rows, or an object with \"fill\""_onFault);
    if (!fields) return;
    level.rows = fields->find("rows");
    if (level.rows && !level.rows->isArray()) {
        checker_.refuse(*level.rows, "an array of rows");
        level.rows = {};
    }
    const auto filling = fields->require("fill", "a character, or an array of rectangles");
    if (!filling) return;
    if (!filling->isArray()) {
        level.filled.push_back({*filling});
        level.filled.back().id = readSign(checker_, *filling, legend_);
        return;
    }
    for (const JsonValue rectangle : *filling) addRectangle(level, rectangle);
}

// { "character", "x", "y", "width", "depth" }
void LevelReader::addRectangle(Level& level, JsonValue value) {
    const auto fields = checker_.fields(value, {"character", "x", "y", "width", "depth"},
                                        "a rectangle: an object with \"character\", \"x\" "
                                        "and \"y\""_onFault);
    if (!fields) return;
    Filled filled = {value};
    if (const auto sign = fields->require("character", "a character of the legend"))
        filled.id = readSign(checker_, *sign, legend_);
    for (const char* key : {"x", "y"}) fields->require(key, kTile.words);
    filled.x = fields->wholeNumber("x", kTile, 0);
    filled.y = fields->wholeNumber("y", kTile, 0);
    filled.width = fields->wholeNumber("width", kTiles, 1);
    filled.depth = fields->wholeNumber("depth", kTiles, 1);
    level.filled.push_back(filled);
}

// ---- Its size

void LevelReader::measureRows(JsonValue rows, Votes& widths, Votes& depths) {
    if (rows.count() > 0) depths.add(rows.count());
    for (const JsonValue row : rows) {
        if (row.isText()) {
            widths.add(countSigns(row.text()));
        } else {
            checker_.refuse(row, "a row: a text with one character for each tile"_later);
        }
    }
}

// [width, depth]
std::optional<GridSize> LevelReader::readSize(JsonValue value) {
    if (!value.isArray() || value.count() != 2) {
        checker_.refuse(value, "the map's [width, depth]"_later);
        return std::nullopt;
    }
    auto side = value.begin();
    const auto width = checker_.wholeNumber(*side, kTiles);
    const auto depth = checker_.wholeNumber(*++side, kTiles);
    if (!width || !depth) return std::nullopt;
    return GridSize{*width, *depth};
}

// The size that is given, or that most levels have. Nothing if there is no row.
std::optional<GridSize> LevelReader::measure(JsonValue value, FoundValue size) {
    Votes widths(kMaxMapWidth);
    Votes depths(kMaxMapDepth);
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        if (levels_[i].rows) measureRows(*levels_[i].rows, widths, depths);
    }
    const std::size_t width = widths.winner();
    const std::size_t depth = depths.winner();
    std::optional<GridSize> given;
    if (size) given = readSize(*size);
    if (width == 0 || depth == 0) {
        if (!size)
            checker_.add(value, "no tiles",
                         "at least one level with rows of characters, or the map's \"size\""_later);
        return given;
    }
    if (width > static_cast<std::size_t>(kMaxMapWidth) ||
        depth > static_cast<std::size_t>(kMaxMapDepth)) {
        checker_.add(value, {"a map of ", width, " x ", depth, " tiles"},
                     {"at most ", kMaxMapWidth, " x ", kMaxMapDepth});
        return std::nullopt;
    }
    const GridSize found = {static_cast<int>(width), static_cast<int>(depth)};
    if (given && (given->width != found.width || given->depth != found.depth))
        checker_.add(*size, {"a map of ", given->width, " x ", given->depth, " tiles"},
                     {width, " x ", depth, ", as in the rows"});
    return found;
}

// How many cells the levels set, one that is set twice counted twice; at least those of one level.
std::int64_t LevelReader::filledCells(GridSize size) {
    const std::int64_t tiles = std::int64_t{size.width} * size.depth;
    std::int64_t sum = 0;
    for (const Level& each : levels_) {
        const Level& level = levels_[static_cast<std::size_t>(each.like)];
        if (level.rows && level.rows->count() > 0) sum += tiles;
        for (const Filled& filled : level.filled) {
            sum += filled.width > 0 ? std::int64_t{filled.width} * filled.depth : tiles;
            if (&each == &level &&
                (filled.x + filled.width > size.width || filled.y + filled.depth > size.depth))
                checker_.add(filled.value, "a rectangle beyond the edge of the map"_later,
                             {"x below ", size.width, " and y below ", size.depth});
        }
    }
    return std::max(sum, tiles);
}

bool LevelReader::hasRoom(JsonValue value, std::int64_t cells, const char* noun, std::int64_t& sum,
                          std::int64_t most) {
    sum += cells;
    if (sum <= most) return true;
    checker_.add(value,
                 {"a map of ", Counted{cells, noun}, ", ", sum, " with the maps before it"_later},
                 {"at most ", most, " in all maps together"_later});
    sum -= cells;
    return false;
}

// ---- The cells

void LevelReader::fill(const Level& level, int number, Map& map) {
    for (const Filled& filled : level.filled) {
        const bool isWhole = filled.width == 0;
        const int east = isWhole ? map.width : std::min(map.width, filled.x + filled.width);
        const int south = isWhole ? map.depth : std::min(map.depth, filled.y + filled.depth);
        for (int y = filled.y; y < south; ++y)
            for (int x = filled.x; x < east; ++x) map.setCell(x, y, number, filled.id);
    }
}

void LevelReader::setRows(const Level& level, int number, Map& map) {
    if (!level.rows || level.rows->count() == 0) return;
    const JsonValue rows = *level.rows;
    if (rows.count() != static_cast<std::size_t>(map.depth)) {
        checker_.add(rows, {"a level of ", Counted{static_cast<std::int64_t>(rows.count()), "row"}},
                     {Counted{map.depth, "row"}, ", as in the other levels"_later});
    }
    const bool isFilled = !level.filled.empty();
    std::vector<std::uint16_t> ids;
    int y = -1;
    for (const JsonValue row : rows) {
        ++y;
        if (!row.isText()) continue;
        ids.assign(static_cast<std::size_t>(map.width), kEmptyCell);
        if (isFilled && y < map.depth) {
            for (int x = 0; x < map.width; ++x)
                ids[static_cast<std::size_t>(x)] = map.cell(x, y, number);
        }
        readRow(checker_, row, y, map.width, legend_, ids, isFilled);
        if (y >= map.depth) continue;
        for (int x = 0; x < map.width; ++x) {
            if (isFilled || ids[static_cast<std::size_t>(x)] != kEmptyCell)
                map.setCell(x, y, number, ids[static_cast<std::size_t>(x)]);
        }
    }
}

void LevelReader::copy(int from, int to, Map& map) {
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const BlueprintId id = map.cell(x, y, from);
            if (id != kEmptyCell) map.setCell(x, y, to, id);
        }
    }
}

void LevelReader::read(JsonValue value, FoundValue size, Map& map) {
    addLevels(value, true);
    if (count_ > static_cast<std::size_t>(kMaxLevels)) {
        checker_.add(value, Counted{static_cast<std::int64_t>(count_), "level"},
                     {"at most ", kMaxLevels});
        return;
    }
    const std::optional<GridSize> tiles = measure(value, size);
    if (!tiles) return;
    if (levels_.empty()) return checker_.refuse(value, kLevels);

    // Allocates only for a map within the limits.
    const int levels = static_cast<int>(levels_.size());
    const std::int64_t cells = std::int64_t{tiles->width} * tiles->depth * levels;
    const auto bytes = static_cast<std::int64_t>(checker_.source().text().size());
    if (!hasRoom(value, cells, "cell", reading_.cells, kMaxSceneCells) ||
        !hasRoom(value, filledCells(*tiles), "filled cell", reading_.filledCells,
                 std::max(kMaxFilledCells, bytes)))
        return;
    Map grid = makeMap(map.name, tiles->width, tiles->depth, levels, 0);
    map.width = grid.width;
    map.depth = grid.depth;
    map.levels = grid.levels;
    map.cells = std::move(grid.cells);
    map.occupied = std::move(grid.occupied);
    map.floor.tiles = std::move(grid.floor.tiles);

    const std::size_t index = reading_.description.world.maps.size();
    reading_.levels.resize(index + 1);
    for (int number = 0; number < levels; ++number) {
        const Level& level = levels_[static_cast<std::size_t>(number)];
        reading_.levels[index].push_back(level.value);
        if (level.like != number) {
            copy(level.like, number, map);
            continue;
        }
        fill(level, number, map);
        setRows(level, number, map);
    }
}

}  // namespace

void readLevels(Reading& reading, JsonValue value, FoundValue size, const Legend& legend,
                Map& map) {
    Checker& checker = reading.checker;
    if (!value.isArray()) {
        checker.refuse(value, "an array of levels, each of them an array of rows"_later);
        return;
    }
    bool isFlat = value.count() > 0;
    for (const JsonValue level : value) isFlat = isFlat && level.isText();
    if (isFlat) {
        checker.add(
            value, "an array of rows",
            "an array of levels, each of them an array of rows: [[\"###\", \"#.#\"]]"_later);
        return;
    }
    LevelReader(reading, legend).read(value, size, map);
}

}  // namespace slicecast

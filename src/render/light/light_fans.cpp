#include "render/light/light_fans.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace slicecast {
namespace {

constexpr std::int32_t kHalfUnit = 32768;
constexpr std::int32_t kLift = 16;  // of samples off their face, 1/65536 units
constexpr std::size_t kMostKinds = 128;
constexpr std::size_t kMetPlaces = 4096;  // a power of two
// Of all fans together: 2 MB. A fan to a low sun has as many cells as the map is wide.
constexpr std::size_t kMostSets = 131'072;

std::int32_t& along(LightVector& v, int axis) {
    return v[static_cast<std::size_t>(axis)];
}

}  // namespace

// ---- Samples and their ways

LightVector skyWay(const LitArea& area, std::size_t way, int turns) {
    std::int32_t a = kSkyWays[way][0];
    std::int32_t b = kSkyWays[way][1];
    for (int i = 0; i < turns; ++i) {
        const std::int32_t before = a;
        a = -b;
        b = before;
    }
    LightVector step{};
    along(step, area.a) = a;
    along(step, area.b) = b;
    along(step, area.normal) = area.sign * kSkyWays[way][2] + area.liftOf(a, b);
    return step;
}

bool findSample(const LitArea& area, std::size_t quarter, LightVector& at) {
    const std::array place = {static_cast<std::int32_t>(quarter % 4),
                              static_cast<std::int32_t>(quarter / 4)};
    std::array<std::int32_t, 2> found{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::int32_t begin = area.tile[i] + place[i] / 2 * kHalfUnit;
        const std::int32_t low = std::max(area.low[i], begin);
        const std::int32_t high = std::min(area.high[i], begin + kHalfUnit);
        if (low >= high) return false;
        found[i] = low + (high - low) * (place[i] % 2 == 0 ? 1 : 3) / 4;
    }
    along(at, area.a) = found[0];
    along(at, area.b) = found[1];
    along(at, area.normal) = area.planeAt(found[0], found[1]) + area.sign * kLift;
    return true;
}

std::int32_t sunShareOf(const LitArea& area, const LightVector& sun) {
    return static_cast<std::int32_t>(256.0 * std::max(0.0, area.cosine(sun)) + 0.5);
}

// ---- Fans

// A fan while it is made. Each of its columns has room for the same levels.
class LightFans::Maker {
public:
    Maker(std::int32_t lowest, std::int32_t highest)
        : lowest_(lowest), levels_(static_cast<std::size_t>(highest - lowest + 1)) {}

    void add(const LightVector& cell, std::size_t way) {
        if (columns_.empty() || columns_[last_].x != cell[0] || columns_[last_].y != cell[1])
            last_ = columnOf(cell[0], cell[1]);
        sets_[last_ * levels_ + static_cast<std::size_t>(cell[2] - lowest_)].add(way);
    }

    // Without the room that is not needed.
    Fan made() const {
        Fan fan;
        fan.columns = columns_;
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const WaySet* const sets = sets_.data() + i * levels_;
            std::size_t low = 0;
            std::size_t end = levels_;
            while (!sets[low].any()) ++low;
            while (!sets[end - 1].any()) --end;
            Column& column = fan.columns[i];
            column.low = lowest_ + static_cast<std::int32_t>(low);
            column.count = static_cast<std::uint32_t>(end - low);
            column.firstSet = static_cast<std::uint32_t>(fan.sets.size());
            fan.sets.insert(fan.sets.end(), sets + low, sets + end);
        }
        return fan;
    }

private:
    std::size_t columnOf(std::int32_t x, std::int32_t y) {
        const std::uint32_t known = index_.find(hashOf(x, y), [&](std::uint32_t i) {
            return columns_[i].x == x && columns_[i].y == y;
        });
        if (known != HashIndex::kNone) return known;
        index_.add(hashOf(x, y));
        columns_.push_back({x, y, 0, 0, 0});
        sets_.resize(columns_.size() * levels_);
        return columns_.size() - 1;
    }
    static std::uint32_t hashOf(std::int32_t x, std::int32_t y) {
        return scattered(static_cast<std::uint64_t>(x * 65536 + y));
    }

    std::int32_t lowest_;
    std::size_t levels_;
    std::vector<Column> columns_;
    std::vector<WaySet> sets_;  // levels_ of each column
    std::size_t last_ = 0;      // index of the column that was added to last
    HashIndex index_{128};      // of the columns, by tile
};

void LightFans::makeKind(LightScene& scene, Kind& kind) {
    const Map& map = scene.map();
    constexpr std::int32_t kSkyReach = 7;  // levels; a way rises or falls by less than 6 units
    Maker sky(-kSkyReach, kSkyReach);
    // A slope that has moved meets the beginning of its tile up to a level below its cell.
    const std::int32_t highest = map.levels + 1;
    Maker sun(-1, highest + 1);
    for (std::size_t quarter = 0; quarter < kQuarters; ++quarter) {
        LightVector at{};
        if (!findSample(kind.area, quarter, at)) continue;
        for (std::size_t way = 0; way < 8; ++way) {
            const LightWay toSky(at, skyWay(kind.area, way, turnsOf(quarter)), false);
            toSky.eachCell([&](const LightVector& cell, LightMoment, std::size_t) {
                sky.add(cell, 8 * quarter + way);
                return true;
            });
        }
        if (kind.sunShare == 0) continue;
        const LightWay toSun(at, scene.sun(), true);
        toSun.eachCell([&](const LightVector& cell, LightMoment, std::size_t) {
            sun.add(cell, quarter);
            return cell[2] <= highest && std::abs(cell[0]) <= map.width &&
                   std::abs(cell[1]) <= map.depth;
        });
    }
    kind.sky = sky.made();
    kind.sun = sun.made();
    const std::size_t sets = kind.sky.sets.size() + kind.sun.sets.size();
    sets_ += sets;
    constexpr LightWork kWorkOfSet = 4;
    scene.addWork(kWorkOfSet * static_cast<LightWork>(sets));
}

LightFans::LightFans(std::size_t sharing) : met_(kMetPlaces / sharing) {}

void LightFans::forget() {
    kinds_.clear();
    index_.clear();
    sets_ = 0;
    std::fill(met_.begin(), met_.end(), Met{});
}

std::size_t LightFans::kindOf(LightScene& scene, const LitArea& area) {
    std::uint64_t key = static_cast<std::uint64_t>(area.normal * 2 + area.sign);
    for (const std::int32_t part : {area.plane, area.at[0], area.at[1], area.rise[0], area.rise[1],
                                    area.low[0], area.low[1], area.high[0], area.high[1]})
        key = (key ^ static_cast<std::uint32_t>(part)) * 0x100000001b3u;  // as FNV-1a
    if (kinds_.size() == kMostKinds || sets_ > kMostSets) forget();
    const std::uint32_t hash = scattered(key);
    const std::uint32_t known =
        index_.find(hash, [&](std::uint32_t i) { return kinds_[i].area == area; });
    if (known != HashIndex::kNone) return known;
    index_.add(hash);
    Kind& kind = kinds_.emplace_back();
    kind.area = area;
    kind.sunShare = scene.hasSun() ? sunShareOf(area, scene.sun()) : 0;
    makeKind(scene, kind);
    return kinds_.size() - 1;
}

// ---- Faces

struct LightFans::Place {
    std::size_t kind;
    LightVector cell;  // of the face's plane: tile and level
    LightVector own;   // of the face's block
    bool isOfBlock;
};

LightFans::Face LightFans::look(LightScene& scene, const LitFaceAt& face, const LitArea& area) {
    Place place = {0, {}, {face.x, face.y, face.level}, face.face < LitFace::floor};
    along(place.cell, area.a) = area.tile[0] >> 16;
    along(place.cell, area.b) = area.tile[1] >> 16;
    along(place.cell, area.normal) = area.planeAt(area.tile[0], area.tile[1]) >> 16;
    LitArea relative = area;
    relative.plane -= along(place.cell, area.normal) * 65536;
    for (std::size_t i = 0; i < 2; ++i) {
        relative.at[i] -= area.tile[i];
        relative.tile[i] = 0;
        relative.low[i] -= area.tile[i];
        relative.high[i] -= area.tile[i];
    }
    place.kind = kindOf(scene, relative);
    Face found;
    found.sunShare = kinds_[place.kind].sunShare;
    if (scene.hasSky()) found.sky = lookAround(scene, place, false);
    // The fan to the sun ends above the blocks
    const bool isUnderAll = (scene.map().ceiling.height.raw >> 16) <= scene.map().levels;
    if (found.sunShare != 0) found.sun = isUnderAll ? lookAround(scene, place, true) : kNotSeen;
    return found;
}

WaysSeen LightFans::lookAround(LightScene& scene, const Place& place, bool toSun) {
    const Map& map = scene.map();
    const Fan& fan = toSun ? kinds_[place.kind].sun : kinds_[place.kind].sky;
    WaysSeen seen;
    scene.addWork(static_cast<LightWork>(fan.columns.size()));
    for (const Column& column : fan.columns) {
        const int x = place.cell[0] + column.x;
        const int y = place.cell[1] + column.y;
        const int low = place.cell[2] + column.low;
        const WaySet* const sets = fan.sets.data() + column.firstSet;
        for (int below = 0; low + below < 0 && below < static_cast<int>(column.count); ++below)
            seen.dark |= sets[below];
        if (!map.contains(x, y)) continue;
        const std::size_t tile = map.tileIndex(x, y);
        // Bit 0 of them is the lowest cell of the column
        const auto inColumn = [&](std::uint32_t levels) {
            const std::uint64_t wide = low < map.levels ? levels : 0;
            return (low < 0 ? wide << -low : wide >> (low & 31)) &
                   ((std::uint64_t{1} << column.count) - 1);
        };
        if (!map.changing.empty() && inColumn(map.changing[tile]) != 0)
            scene.addTouched(LightScene::placeBit(x, y));
        std::uint64_t blocks = inColumn(map.occupied[tile]);
        if (!map.ceiling.tiles.empty() && map.ceiling.tiles[tile] != kNoTexture) {
            const int level = map.ceiling.height.raw >> 16;
            const auto waysAt = [&](int at) {
                const int above = at - low;
                return above >= 0 && above < static_cast<int>(column.count) ? sets[above]
                                                                            : WaySet{};
            };
            const bool isBorder = (map.ceiling.height.raw & 0xffff) == 0;
            const bool isOpaque = !scene.world().textures[map.ceiling.tiles[tile]].seeThrough;
            (isBorder && isOpaque ? seen.dark : seen.dim) |=
                isBorder ? waysAt(level) & waysAt(level - 1) : waysAt(level);
        }
        for (; blocks != 0; blocks &= blocks - 1) {
            const int above = std::countr_zero(blocks);
            const LightVector cell = {x, y, low + above};
            // No way meets the block from whose face it goes out
            if (place.isOfBlock && cell == place.own) continue;
            const LightScene::Look look = scene.lookOf(map.cells[map.cellIndex(x, y, low + above)]);
            if (look.isWhole) {
                (look.isClear ? seen.dim : seen.dark) |= sets[above];
            } else {
                parts_.push_back(
                    {cell, static_cast<std::uint32_t>(column.firstSet + above), look.isClear});
            }
        }
    }
    // What fills only a part of its cell is looked at closely, if that may matter
    for (const bool isClear : {false, true}) {
        for (const Part& part : parts_) {
            if (part.isClear != isClear) continue;
            WaySet ways = fan.sets[part.set] - seen.dark;
            if (isClear) ways = ways - seen.dim;
            if (ways.any())
                (isClear ? seen.dim : seen.dark) |= meeting(scene, place, toSun, part, ways);
        }
    }
    parts_.clear();
    return seen;
}

// Those of some ways through a cell that meet the block in it.
WaySet LightFans::meeting(LightScene& scene, const Place& place, bool toSun, const Part& part,
                          const WaySet& ways) {
    scene.addWork(2);
    const Kind& kind = kinds_[place.kind];
    const BlueprintId id = scene.map().cell(part.cell[0], part.cell[1], part.cell[2]);
    const std::uint64_t key = std::uint64_t{1} << 63 | std::uint64_t{place.kind} << 48 |
                              std::uint64_t{toSun} << 47 | std::uint64_t{part.set} << 16 | id;
    Met& met = met_[scattered(key) & (met_.size() - 1)];
    if (met.key != key || scene.world().blueprints[id].mover >= 0) met = {key, {}, {}};
    const WaySet unknown = ways - met.known;
    met.known |= unknown;
    for (std::size_t quarter = 0; unknown.any() && quarter < kQuarters; ++quarter) {
        LightVector at{};
        std::uint32_t those = toSun ? unknown.has(quarter) : unknown.skyOf(quarter);
        if (those == 0 || !findSample(kind.area, quarter, at)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis)
            at[axis] += (place.cell[axis] - part.cell[axis]) * 65536;
        scene.addWork(4 * std::popcount(those));
        for (; those != 0; those &= those - 1) {
            const auto way = static_cast<std::size_t>(std::countr_zero(those));
            const LightVector step = toSun ? scene.sun() : skyWay(kind.area, way, turnsOf(quarter));
            if (scene.meets({at, step, toSun}, id))
                met.ways.add(toSun ? quarter : 8 * quarter + way);
        }
    }
    return met.ways & ways;
}

}  // namespace slicecast

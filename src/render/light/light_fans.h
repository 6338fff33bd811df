// The ways of light from a face to the sky and the sun, by the cells that they pass.
//
//       \    |    /  /            Most faces lie in their cells as many others do, so their ways
//     +--\--+|---/+-/---+         pass the same cells around. A fan lists these, each with the set
//     |   \ ||  / |/    |         of the ways through it. One look at each cell around then says
//     +----\||-/--/-----+         which ways of a face are dark, instead of a walk for each of its
//     |     \|/ /#|     |         144 ways.
//     +======*======----+
#pragma once

#include "base/hash_index.h"
#include "render/light/light_scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

// The ways to the sky from a sample, along its face's axes a and b and outward, 1/65536 units. They
// lie at equal shares of the light that falls on a face from all of the sky.
inline constexpr std::int32_t kSkyWays[8][3] = {
    {49152, 0, 190365},      {-62775, 57507, 177220},   {9609, -109486, 163019},
    {79124, 103203, 147456}, {-145202, -25684, 130044}, {137548, -87497, 109907},
    {-46007, 171144, 85134}, {-87741, -168939, 49152}};

// The way on the map's axes, turned by quarter turns.
LightVector skyWay(const LitArea& area, std::size_t way, int turns);

// A face's quarters are numbered row by row: 4 * row + column.
inline constexpr std::size_t kQuarters = 16;
constexpr int turnsOf(std::size_t quarter) {
    constexpr int kTurns[2][2] = {{0, 3}, {1, 2}};
    return kTurns[quarter % 2][quarter / 4 % 2];
}

// Where the sample of a quarter is. False if the face has no part of it.
bool findSample(const LitArea& area, std::size_t quarter, LightVector& at);

// 256 times the cosine between the face's outward direction and the sun's, rounded.
std::int32_t sunShareOf(const LitArea& area, const LightVector& sun);

// A set of ways: to the sky number 8 * quarter + way, to the sun number quarter.
struct WaySet {
    std::array<std::uint64_t, 2> bits{};

    void add(std::size_t way) { bits[way / 64] |= std::uint64_t{1} << way % 64; }
    bool has(std::size_t way) const { return (bits[way / 64] >> way % 64 & 1) != 0; }
    // The ways of a quarter to the sky.
    std::uint32_t skyOf(std::size_t quarter) const {
        return static_cast<std::uint32_t>(bits[quarter / 8] >> quarter % 8 * 8) & 255;
    }
    bool any() const { return (bits[0] | bits[1]) != 0; }
    WaySet& operator|=(const WaySet& other) {
        bits[0] |= other.bits[0];
        bits[1] |= other.bits[1];
        return *this;
    }
    friend WaySet operator&(const WaySet& a, const WaySet& b) {
        return {{a.bits[0] & b.bits[0], a.bits[1] & b.bits[1]}};
    }
    friend WaySet operator-(const WaySet& a, const WaySet& b) {
        return {{a.bits[0] & ~b.bits[0], a.bits[1] & ~b.bits[1]}};
    }
};

// What the cells say of ways. The others are free.
struct WaysSeen {
    WaySet dark;
    WaySet dim;  // they may meet something see-through: each must be followed, if it is not dark
};
inline constexpr WaysSeen kNotSeen = {{}, {{~std::uint64_t{0}, ~std::uint64_t{0}}}};

class LightFans {
public:
    // `sharing`: see LitMap.
    explicit LightFans(std::size_t sharing = 1);

    // What a face's ways are like.
    struct Face {
        WaysSeen sky;
        WaysSeen sun;
        std::int32_t sunShare = 0;
    };

    // What is kept, bytes.
    std::size_t bytes() const { return sets_ * sizeof(WaySet) + met_.size() * sizeof(Met); }

    // Forgets everything: for another map, or if a block of it that does not move has changed.
    void forget();

    // Looks at the blocks around a face. Tells the scene which changeable cells matter: see
    // LightScene::touched.
    Face look(LightScene& scene, const LitFaceAt& face, const LitArea& area);

private:
    // The cells of a tile that ways pass, from level `low` up. Places are relative to the cell of
    // the face's plane.
    struct Column {
        std::int32_t x;
        std::int32_t y;
        std::int32_t low;
        std::uint32_t count;
        std::uint32_t firstSet;
    };
    struct Fan {
        std::vector<Column> columns;
        std::vector<WaySet> sets;  // of each column's cells
    };
    // Of all faces that lie alike in their cells.
    struct Kind {
        LitArea area;  // relative to the cell of its plane
        std::int32_t sunShare = 0;
        Fan sky;
        Fan sun;
    };
    // A block near a face that fills only a part of its cell.
    struct Part {
        LightVector cell;
        std::uint32_t set;  // index of the fan's ways through that cell
        bool isClear;       // see-through
    };
    // Which of the ways through a cell meet a block of a shape, as far as known.
    struct Met {
        std::uint64_t key = 0;
        WaySet known;
        WaySet ways;
    };
    class Maker;
    struct Place;

    std::size_t kindOf(LightScene& scene, const LitArea& area);
    void makeKind(LightScene& scene, Kind& kind);
    WaysSeen lookAround(LightScene& scene, const Place& place, bool toSun);
    WaySet meeting(LightScene& scene, const Place& place, bool toSun, const Part& part,
                   const WaySet& ways);

    std::vector<Kind> kinds_;
    HashIndex index_;          // of these, by area
    std::size_t sets_ = 0;     // in all kinds
    std::vector<Met> met_;     // keys share places, and the last one stays
    std::vector<Part> parts_;  // of the face that is looked at
};

}  // namespace slicecast

// A map as light sees it: boxes, cuts and planes that stop or tint light rays, and the lamps.
// Everything is in whole numbers, so that each ray has one answer. See "Baked light" in
// web/docs/picture.md.
#pragma once

#include "render/light_cuts.h"
#include "world/world.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace slicecast {

using LightTint = std::array<std::uint8_t, 3>;  // red, green, blue

// What light falls on: a face of a block, or of a tile's floor or ceiling.
enum class LitFace : std::uint8_t {
    north,
    east,
    south,
    west,
    top,
    bottom,
    floor,
    ceilingBelow,
    ceilingAbove,
    outside  // of the floor beyond the grid, all of it
};
struct LitFaceAt {
    int x = 0;
    int y = 0;
    int level = 0;  // 0 for floor and ceiling
    LitFace face = LitFace::floor;

    std::uint64_t key() const {
        return std::uint64_t{static_cast<std::uint16_t>(x)} << 24 |
               std::uint64_t{static_cast<std::uint16_t>(y)} << 40 |
               static_cast<std::uint64_t>(level) << 8 | static_cast<std::uint64_t>(face);
    }
};
inline constexpr LitFaceAt kOutside = {0, 0, 0, LitFace::outside};

// Where a face lies, 1/65536 units. Its own axes are 0, 1, 2 for x, y, z. A slope, and the cut of a
// half, rises along them.
struct LitArea {
    int normal = 2;  // axis
    int sign = 1;    // of the outward direction on it
    int a = 0;
    int b = 1;
    std::int32_t plane = 0;              // on the normal, where the tile, or the cell, begins
    std::array<std::int32_t, 2> rise{};  // of it along a and b, per unit
    std::array<std::int32_t, 2> tile{};  // where that is, along a and b
    std::array<std::int32_t, 2> low{};   // the face's ends
    std::array<std::int32_t, 2> high{};

    // The plane at a place along a and b, rounded down.
    std::int32_t planeAt(std::int32_t atA, std::int32_t atB) const {
        return plane + liftOf(atA - tile[0], atB - tile[1]);
    }
    // By how much a way along a and b rises with the plane, rounded down.
    std::int32_t liftOf(std::int32_t wayA, std::int32_t wayB) const {
        return static_cast<std::int32_t>(
            (std::int64_t{rise[0]} * wayA + std::int64_t{rise[1]} * wayB) >> 16);
    }
    // Outwards of the plane, on the three axes; 65536 along its own axis.
    std::array<std::int64_t, 3> outward() const {
        std::array<std::int64_t, 3> out{};
        out[static_cast<std::size_t>(a)] = -std::int64_t{sign} * rise[0];
        out[static_cast<std::size_t>(b)] = -std::int64_t{sign} * rise[1];
        out[static_cast<std::size_t>(normal)] = std::int64_t{sign} * 65536;
        return out;
    }
    // How far a point is in front of the plane, in 1/2^32 units along the normal.
    std::int64_t inFront(const LightVector& point) const {
        const auto at = [&](int axis) {
            return std::int64_t{point[static_cast<std::size_t>(axis)]};
        };
        return sign * ((at(normal) - plane) * 65536 - rise[0] * (at(a) - tile[0]) -
                       rise[1] * (at(b) - tile[1]));
    }
};

// A lamp as rays look for it.
struct HungLamp {
    LightVector at{};
    LampKind kind;
    double square = 0.0;  // of the radius, 1/65536 units squared
    bool ofFace = false;
    LitArea face;  // before which it hangs
};

class LightScene {
public:
    // Looks at a map that has baked light. Returns whether all that was known of its light is
    // void; if not, changedTiles() says where something has changed since the last time. Both must
    // outlive the scene's use.
    bool begin(const World& world, const Map& map);

    // A bit for each place where something has changed; see placeBit.
    std::uint64_t changed() const { return changed_; }

    // Tiles share 64 bits: of a square of 8 x 8 tiles each has its own.
    static std::uint64_t placeBit(int x, int y) {
        return std::uint64_t{1} << ((x & 7) | (y & 7) << 3);
    }

    // The place bits of the tiles that hold something changeable on the ways since clearTouched().
    std::uint64_t touched() const { return touched_; }
    void clearTouched() { touched_ = 0; }
    void addTouched(std::uint64_t bits) { touched_ |= bits; }
    // The tile's bit if something over it may change, else none.
    std::uint64_t changeableBit(int x, int y) const {
        return !map_->changing.empty() && map_->changing[map_->tileIndex(x, y)] != 0
                   ? placeBit(x, y)
                   : 0;
    }

    // False if there is no such face.
    bool findArea(const LitFaceAt& at, LitArea& area) const;

    // The place where a face would go on beyond its tile: a step of -1, 0 or 1 along a and b each.
    static LitFaceAt beside(LitFaceAt at, const LitArea& area, int stepA, int stepB);

    bool isInOpaque(const LightVector& point);

    // What comes through on the way from a point by a vector, 255 for all of it. An endless way
    // goes on until it meets nothing more; it must not fall.
    LightTint through(const LightVector& from, const LightVector& way, bool endless = false);

    std::span<const HungLamp> lampsNear(const LightVector& point) const;

    const BakedLight& light() const { return map_->baked; }
    const LightVector& sun() const { return sun_; }
    const Map& map() const { return *map_; }
    const World& world() const { return *world_; }

private:
    // A block's box within its cell: its ends along x, y and z.
    struct Extent {
        LightVector low;
        LightVector high;
    };
    // A moment of a way: num / den of its vector. Of equal ones the one with less `late` is
    // earlier: samples count as moved by an infinitely small step.
    struct Moment {
        std::int64_t num;
        std::int64_t den;  // 0: never
        int late;
    };
    struct Way;

    static bool isBefore(const Moment& a, const Moment& b) {
        const std::int64_t left = a.num * b.den;
        const std::int64_t right = b.num * a.den;
        return left != right ? left < right : a.late < b.late;
    }
    static bool isSame(const Moment& a, const Moment& b) {
        return a.num * b.den == b.num * a.den && a.late == b.late;
    }
    static Moment crossing(std::int32_t from, std::int32_t way, std::int32_t at, int axis) {
        return way > 0 ? Moment{std::int64_t{at} - from, way, axis - 3}
                       : Moment{std::int64_t{from} - at, -std::int64_t{way}, 3 - axis};
    }
    static CutMoment cutMoment(const Moment& moment);
    Extent extentOf(const CellBlueprint& block) const;
    static bool isCut(const CellBlueprint& block) {
        return block.plan.half != Half::none || block.slopes.any();
    }

    void hangLamps();
    void hang(const Lamp& lamp, const LitArea* face);
    void sortLamps();
    void findChangingTiles();
    std::uint64_t stateOf(int x, int y) const;
    const LightTint& tintOf(TextureId texture);
    struct Stretch;
    bool meetTile(Way& way, int x, int y, const Stretch& over);
    bool meetBlock(Way& way, const CellBlueprint& block, int x, int y, int level,
                   const Moment& enter, const Moment& leave);
    struct Passage;
    static bool cutPassage(const Way& way, const CellBlueprint& block, const LightVector& tile,
                           const Moment& leave, Passage& passage);
    void leaveBlock(Way& way);

    const World* world_ = nullptr;
    const Map* map_ = nullptr;
    std::uint64_t edition_ = 0;  // of the map that is known
    BakedLight known_;
    LightVector sun_{};
    std::int32_t highest_ = 0;  // nothing is above

    struct ChangingTile {
        int x;
        int y;
        std::uint64_t state;
    };
    std::vector<ChangingTile> changing_;
    std::uint64_t changed_ = 0;
    std::uint64_t touched_ = 0;

    struct Tint {
        bool known = false;
        LightTint tint{};
    };
    std::vector<Tint> tints_;  // by TextureId

    // The lamps, in lists by squares of kLampSquare tiles.
    static constexpr int kLampSquare = 4;
    std::vector<HungLamp> hung_;
    std::vector<HungLamp> lamps_;
    std::vector<std::uint32_t> firstLamps_;  // of each square; one more at the end
    int lampColumns_ = 0;
};

}  // namespace slicecast

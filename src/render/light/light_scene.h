// A map as light sees it: boxes, cuts and planes that stop or tint light rays, and the lamps.
// Everything is in whole numbers, so that each ray has one answer. See "Baked light" in
// web/docs/picture.md.
#pragma once

#include "render/light/light_way.h"
#include "render/options.h"
#include "world/baked_light.h"
#include "world/world.h"

#include <algorithm>
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
    std::int32_t plane = 0;              // on the normal, at the place `at`
    std::array<std::int32_t, 2> at{};    // along a and b: as `tile`, but for slopes that move
    std::array<std::int32_t, 2> rise{};  // of the plane along a and b, per unit
    std::array<std::int32_t, 2> tile{};  // where the tile, or the cell, begins along a and b
    std::array<std::int32_t, 2> low{};   // the face's ends
    std::array<std::int32_t, 2> high{};

    // The plane at a place along a and b, rounded down.
    std::int32_t planeAt(std::int32_t atA, std::int32_t atB) const {
        return plane + liftOf(atA - at[0], atB - at[1]);
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
    bool isLevel() const { return rise[0] == 0 && rise[1] == 0; }
    // How far a point is in front of the plane, in 1/2^32 units along the normal.
    std::int64_t inFront(const LightVector& point) const {
        const auto along = [&](int axis) {
            return std::int64_t{point[static_cast<std::size_t>(axis)]};
        };
        return sign * ((along(normal) - plane) * 65536 - rise[0] * (along(a) - at[0]) -
                       rise[1] * (along(b) - at[1]));
    }
    bool isInPlaneOf(const LitArea& other) const {
        return normal == other.normal && sign == other.sign && rise == other.rise &&
               inFront({}) == other.inFront({});
    }
    // Between the outward direction and a way that is not 0.
    double cosine(const LightVector& way) const;

    friend bool operator==(const LitArea&, const LitArea&) = default;
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
    // `sharing`: see LitMap.
    explicit LightScene(std::size_t sharing = 1) : cubes_(kCubes / sharing) {}

    // What is kept, bytes.
    std::size_t bytes() const {
        return cubes_.size() * sizeof(CubeLamps) + lamps_.size() * sizeof(HungLamp) +
               changing_.size() * sizeof(ChangingTile);
    }

    // How a block looks to light.
    struct Look {
        bool isWhole;  // it fills its cell, and stays so
        bool isClear;  // see-through
    };

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
    // The tile's bit if what is in that cell may change, else none.
    std::uint64_t changeableBit(int x, int y, int level) const {
        return !map_->changing.empty() && level >= 0 && level < map_->levels &&
                       (map_->changing[map_->tileIndex(x, y)] >> level & 1) != 0
                   ? placeBit(x, y)
                   : 0;
    }

    // False if there is no such face.
    bool findArea(const LitFaceAt& at, LitArea& area) const;

    // The place where a face would go on beyond its tile: a step of -1, 0 or 1 along a and b each.
    // A slope may go on in the level above or below instead.
    static LitFaceAt beside(LitFaceAt at, const LitArea& area, int stepA, int stepB);

    bool isInOpaque(const LightVector& point);

    // Whether the cell of a point holds no block but that of a face before which it is.
    bool isOpen(const LightVector& point, const LitFaceAt& before) const {
        const int x = point[0] >> 16;
        const int y = point[1] >> 16;
        const int level = point[2] >> 16;
        return !map_->isOccupied(x, y, level) || (before.face < LitFace::floor && x == before.x &&
                                                  y == before.y && level == before.level);
    }
    static bool areInOneCell(const LightVector& a, const LightVector& b) {
        return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) >> 16 == 0;
    }
    // Whether a tile's ceiling may be between two heights.
    bool isCeilingBetween(std::int32_t a, std::int32_t b) const {
        const std::int32_t height = map_->ceiling.height.raw;
        return !map_->ceiling.tiles.empty() && std::min(a, b) <= height && height <= std::max(a, b);
    }

    // What comes through on the way from a point by a vector, 255 for all of it. An endless way
    // goes on until it meets nothing more; it must not fall.
    LightTint through(const LightVector& from, const LightVector& way, bool endless = false);

    // Whether a way meets the block of that blueprint in the cell at 0, 0, 0.
    bool meets(const LightWay& way, BlueprintId id) const;

    // The numbers of the lamps that light what lies in the cube around a point. Valid until the
    // next call.
    std::span<const std::uint16_t> lampsNear(const LightVector& point);
    const HungLamp& lamp(std::uint16_t number) const { return lamps_[number]; }

    // What has been done since the scene was made, see LightWork.
    LightWork work() const { return work_; }
    void addWork(LightWork work) { work_ += work; }

    Look lookOf(BlueprintId id) const { return looks_[id]; }
    bool hasSky() const { return isBright(map_->baked.ambient); }
    bool hasSun() const { return isBright(map_->baked.sun); }

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
    struct Travel;

    static bool isBright(const Colour& colour) { return (colour.r | colour.g | colour.b) != 0; }
    Extent extentOf(const CellBlueprint& block) const;
    static bool isCut(const CellBlueprint& block) {
        return block.plan.half != Half::none || block.slopes.any();
    }

    void hangLamps();
    void hang(const Lamp& lamp, const LitArea* face);
    void sortLamps();
    void chooseLamps(const LightVector& cube);
    void findChangingTiles();
    std::uint64_t stateOf(int x, int y) const;
    const LightTint& tintOf(TextureId texture);
    struct Passage;
    bool meetCell(Travel& travel, const LightVector& cell, LightMoment enter, LightMoment leave,
                  std::size_t axis);
    bool meetCeiling(Travel& travel, std::size_t tile, LightMoment enter, LightMoment leave) const;
    bool findBox(const LightWay& way, const CellBlueprint& block, const LightVector& corner,
                 Passage& passage) const;
    bool findPassage(const LightWay& way, const CellBlueprint& block, const LightVector& corner,
                     Passage& passage) const;
    static bool cutPassage(const LightWay& way, const CellBlueprint& block,
                           const LightVector& corner, Passage& passage);
    void leaveBlock(Travel& travel);

    const World* world_ = nullptr;
    const Map* map_ = nullptr;
    std::uint64_t edition_ = 0;  // of the map that is known
    BakedLight known_;
    LightVector sun_{};

    struct ChangingTile {
        int x;
        int y;
        std::uint64_t state;
    };
    std::vector<ChangingTile> changing_;
    std::uint64_t changed_ = 0;
    std::uint64_t touched_ = 0;
    LightWork work_ = 0;

    struct Tint {
        bool known = false;
        LightTint tint{};
    };
    std::vector<Tint> tints_;  // by TextureId
    std::vector<Look> looks_;  // by BlueprintId

    // The lamps, and their numbers in lists by squares of kFarthestLamp a side.
    std::vector<HungLamp> lamps_;
    std::vector<std::uint16_t> inSquares_;
    std::vector<std::uint32_t> firstInSquare_;  // of each square; one more at the end
    int lampColumns_ = 0;
    int lampRows_ = 0;
    // Those of cubes that have been asked for; cubes share places, and the last one stays.
    struct CubeLamps {
        LightVector cube{};
        bool known = false;
        std::uint8_t count = 0;
        std::array<std::uint16_t, kMaxLampsOfCube> numbers{};
    };
    static constexpr std::size_t kCubes = 1024;  // a power of two
    std::vector<CubeLamps> cubes_;
    struct NearLamp {
        std::int64_t square;  // of its distance from the middle of the cube
        std::uint16_t number;
    };
    std::vector<NearLamp> near_;
    std::vector<NearLamp> nearRoom_;
};

}  // namespace slicecast

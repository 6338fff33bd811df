#include "world/object_sowing.h"

#include "world/collision.h"
#include "world/player.h"

#include <algorithm>
#include <bit>

namespace slicecast {
namespace {

// Border of a tile that holds no middle of an object: the widest body fits into the rest.
constexpr int kMargin = 65536 / 5;

// The ground of a tile on one level. The floor is the ground below level 0.
struct Ground {
    Coordinate height;
    TextureId texture = kNoTexture;
};

// The numbers of a list.
class NumberSet {
public:
    explicit NumberSet(const std::vector<std::uint16_t>& list) {
        for (const std::uint16_t number : list) {
            if (number >= has_.size()) has_.resize(std::size_t{number} + 1);
            has_[number] = true;
        }
    }
    bool has(std::uint16_t number) const { return number < has_.size() && has_[number]; }

private:
    std::vector<bool> has_;
};

// Something to sow, made ready to look at every tile.
struct Sower {
    const Sowing& sowing;
    NumberSet on;
    NumberSet textures;
    std::uint64_t seed;
};

std::optional<Ground> floorAt(const Map& map, const Sowing& sowing, std::size_t tile) {
    if (!sowing.onFloor) return std::nullopt;
    return Ground{{}, map.floor.tiles.empty() ? map.floor.texture : map.floor.tiles[tile]};
}

std::optional<Ground> roofAt(const World& world, const Map& map, const Sower& sower, int x, int y,
                             int level) {
    const BlueprintId id = map.cell(x, y, level);
    if (id == kEmptyCell || !sower.on.has(id)) return std::nullopt;
    const CellBlueprint& block = world.blueprints[id];
    const FaceBlueprint& roof = block.face(Face::top);
    if (roof.portal != kNoPortal || block.mover >= 0 || !block.isBox()) return std::nullopt;
    return Ground{tileEdge(level) + block.top, roof.texture};
}

// True if the tile's cells between two heights are empty, except for the ground, no mover can reach
// them, and no ceiling is there.
bool isEmpty(const Map& map, int x, int y, Coordinate ground, Coordinate top) {
    const std::size_t tile = map.tileIndex(x, y);
    const Ceiling& ceiling = map.ceiling;
    if (top > kMaxBodyHeight || (!ceiling.tiles.empty() && ceiling.tiles[tile] != kNoTexture &&
                                 ceiling.height > ground && ceiling.height < top))
        return false;
    for (int level = ground.tile();
         level <= std::min(map.levels - 1, Coordinate{top.raw - 1}.tile()); ++level) {
        const bool holdsGround = tileEdge(level) < ground && map.isOccupied(x, y, level);
        if (!holdsGround && map.cells[map.cellIndex(x, y, level)] != kEmptyCell) return false;
    }
    return true;
}

// True where the player starts, or closer to the start than `clear`.
bool isNearStart(const World& world, int map, int x, int y, const Object& object,
                 Coordinate clear) {
    if (world.start.map != map) return false;
    const Box body = bodyBox(world.start.x, world.start.y, world.start.z, kStandingHeight);
    if (body.east > tileEdge(x) && body.west < tileEdge(x + 1) && body.south > tileEdge(y) &&
        body.north < tileEdge(y + 1))
        return true;
    const std::int64_t dx = (object.x - world.start.x).raw;
    const std::int64_t dy = (object.y - world.start.y).raw;
    return dx * dx + dy * dy < std::int64_t{clear.raw} * clear.raw;
}

// The random numbers of one spot.
Random randomAt(std::uint64_t seed, int x, int y, int spot) {
    const auto place = static_cast<std::uint64_t>(y) << 40 | static_cast<std::uint64_t>(x) << 20 |
                       static_cast<std::uint64_t>(spot);
    return Random(seed ^ place);
}

Coordinate within(const CoordinateRange& range, Random& random) {
    return {random.between(range.least.raw, range.greatest.raw)};
}

// True if a circling object has room all around.
bool hasRoom(const World& world, int map, const Object& object, const ObjectMotion& motion) {
    if (motion.kind != ObjectMotion::Kind::circle) return true;
    const Coordinate reach = motion.reach + kWidestBody;
    return isFree(world, map,
                  {object.x - reach, object.x + reach, object.y - reach, object.y + reach, object.z,
                   object.z + object.height});
}

void addMotion(World& world, int map, const Sowing& sowing, Random& random) {
    ObjectMotion motion = *sowing.motion;
    motion.map = map;
    motion.object = static_cast<int>(world.maps[static_cast<std::size_t>(map)].objects.size()) - 1;
    motion.random = Random(random.next());
    if (sowing.anyHeading) motion.headingDegrees = random.below(360);
    world.movingObjects.motions.push_back(motion);
}

void addFind(World& world, int map, const Find& like) {
    Find& find = world.quest.finds.emplace_back(like);
    find.map = map;
    find.object = static_cast<int>(world.maps[static_cast<std::size_t>(map)].objects.size()) - 1;
}

// Sows one spot.
void sowSpot(World& world, int mapIndex, const Sower& sower, int x, int y, int spot,
             const Ground& ground, TakenSpots& taken) {
    Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    const Sowing& sowing = sower.sowing;
    const std::size_t tile = map.tileIndex(x, y);
    if (!sowing.textures.empty() && !sower.textures.has(ground.texture)) return;
    if (taken.isTaken(tile, ground.height)) return;
    Random random = randomAt(sower.seed, x, y, spot);
    if (random.unit() >= sowing.density) return;
    Object object = sowing.object;
    object.height = within(sowing.height, random);
    // Most that have no room are known by now
    if (!isEmpty(map, x, y, ground.height, ground.height + sowing.above.least + object.height))
        return;
    object.x = tileEdge(x) + Coordinate{random.between(kMargin, 65536 - kMargin)};
    object.y = tileEdge(y) + Coordinate{random.between(kMargin, 65536 - kMargin)};
    object.z = ground.height + within(sowing.above, random);
    if (isNearStart(world, mapIndex, x, y, object, sowing.clear)) return;
    if (!isEmpty(map, x, y, ground.height, object.z + object.height)) return;
    if (sowing.motion && !hasRoom(world, mapIndex, object, *sowing.motion)) return;
    taken.take(tile, ground.height);
    map.objects.push_back(object);
    if (sowing.motion) addMotion(world, mapIndex, sowing, random);
    if (sowing.find) addFind(world, mapIndex, *sowing.find);
}

}  // namespace

TakenSpots::TakenSpots(const Map& map)
    : spots_(static_cast<std::size_t>(map.levels) + 1), taken_(map.occupied.size() * spots_) {
    for (const Object& object : map.objects) {
        if (map.contains(object.x.tile(), object.y.tile()))
            take(map.tileIndex(object.x.tile(), object.y.tile()), object.z);
    }
}

std::size_t TakenSpots::spotAt(std::size_t tile, Coordinate feet) const {
    return tile * spots_ + std::min(static_cast<std::size_t>(feet.tile()), spots_ - 1);
}

Sown sowObjects(World& world, int mapIndex, const Sowing& sowing, TakenSpots& taken, int first,
                int end) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    auto room = static_cast<std::size_t>(kMaxObjects) + map.objects.size();
    for (const Map& each : world.maps) room -= std::min(room, each.objects.size());
    const Sower sower = {sowing, NumberSet(sowing.on), NumberSet(sowing.textures),
                         Random(sowing.seed).next()};
    for (int y = first; y < end; ++y) {
        for (int x = 0; x < map.width; ++x) {
            if (map.tilePortal(x, y) != kNoPortal) continue;
            const auto sow = [&](int spot, const std::optional<Ground>& ground) {
                if (ground) sowSpot(world, mapIndex, sower, x, y, spot, *ground, taken);
            };
            const std::size_t tile = map.tileIndex(x, y);
            sow(0, floorAt(map, sowing, tile));
            for (std::uint32_t levels = sowing.on.empty() ? 0 : map.occupied[tile]; levels != 0;
                 levels &= levels - 1) {
                const int level = std::countr_zero(levels);
                sow(level + 1, roofAt(world, map, sower, x, y, level));
            }
            if (map.objects.size() > room) return Sown::tooMany;
            if (world.movingObjects.motions.size() > static_cast<std::size_t>(kMaxMovingObjects))
                return Sown::tooManyMoving;
            if (world.quest.finds.size() > kMaxFinds) return Sown::tooManyFinds;
        }
    }
    return Sown::all;
}

}  // namespace slicecast

#include "render/light/light_scene.h"

#include "base/angle.h"
#include "base/sort.h"
#include "render/light/light_cuts.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace slicecast {
namespace {

constexpr std::int32_t kQuarterUnit = 16384;
// A lamp of a face hangs so far before it: 1/16 of a unit.
constexpr std::int32_t kLampHang = 4096;

constexpr std::int32_t floored(std::int32_t raw) {
    return raw & -kQuarterUnit;
}

}  // namespace

double LitArea::cosine(const LightVector& way) const {
    const std::array<std::int64_t, 3> out = outward();
    const auto part = [&](std::size_t i) { return static_cast<double>(way[i]); };
    const auto product = static_cast<double>(out[0] * way[0] + out[1] * way[1] + out[2] * way[2]);
    const auto square = static_cast<double>(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
    return product / (std::sqrt(square) *
                      std::sqrt(part(0) * part(0) + part(1) * part(1) + part(2) * part(2)));
}

bool LightScene::begin(const World& world, const Map& map) {
    const bool isNew =
        world_ != &world || map_ != &map || edition_ != map.edition || !(known_ == map.baked);
    changed_ = 0;
    if (isNew) {
        world_ = &world;
        map_ = &map;
        edition_ = map.edition;
        known_ = map.baked;
        const double level = cosDegrees(known_.altitude);
        sun_ = {toCoordinate(level * cosDegrees(known_.azimuth)).raw,
                toCoordinate(level * sinDegrees(known_.azimuth)).raw,
                toCoordinate(sinDegrees(known_.altitude)).raw};
        tints_.assign(world.textures.size(), {});
        looks_.clear();
        for (const CellBlueprint& block : world.blueprints) {
            const bool isWhole =
                block.mover < 0 && block.isBox() && block.fillsUp() && block.fillsDown();
            looks_.push_back({isWhole, block.seeThrough});
        }
        hangLamps();
        findChangingTiles();
        return true;
    }
    for (ChangingTile& tile : changing_) {
        const std::uint64_t state = stateOf(tile.x, tile.y);
        if (state == tile.state) continue;
        tile.state = state;
        changed_ |= placeBit(tile.x, tile.y);
    }
    return false;
}

// ---- What changes

void LightScene::findChangingTiles() {
    changing_.clear();
    if (map_->changing.empty()) return;
    for (int y = 0; y < map_->depth; ++y) {
        for (int x = 0; x < map_->width; ++x) {
            if (map_->changing[map_->tileIndex(x, y)] != 0)
                changing_.push_back({x, y, stateOf(x, y)});
        }
    }
}

// A number for what light sees of the changeable blocks over a tile.
std::uint64_t LightScene::stateOf(int x, int y) const {
    constexpr std::uint64_t kPrime = 0x100000001b3u;  // of FNV-1a
    std::uint64_t state = 0xcbf29ce484222325u;
    const auto add = [&](std::uint64_t value) { state = (state ^ value) * kPrime; };
    const std::size_t tile = map_->tileIndex(x, y);
    add(map_->occupied[tile]);
    for (std::uint32_t levels = map_->changing[tile] & map_->occupied[tile]; levels != 0;
         levels &= levels - 1) {
        const BlueprintId id = map_->cell(x, y, std::countr_zero(levels));
        const CellBlueprint& block = world_->blueprints[id];
        const Extent extent = extentOf(block);
        add(id);
        for (std::size_t axis = 0; axis < 3; ++axis)
            add(static_cast<std::uint64_t>(extent.low[axis]) << 32 |
                static_cast<std::uint64_t>(extent.high[axis]));
        for (const FaceBlueprint& face : block.faces) add(face.texture);
        if (!block.slopes.any()) continue;
        const Slopes slopes = slopesInLight(block);
        for (const Slant& slant : {slopes.bottom, slopes.top}) {
            add(static_cast<std::uint32_t>(slant.from.raw));
            add(static_cast<std::uint32_t>(slant.to.raw));
            add(static_cast<std::uint32_t>(slant.shift.raw));
        }
    }
    return state;
}

// A moving block reaches to quarters of units along its motion, so that it seldom changes.
LightScene::Extent LightScene::extentOf(const CellBlueprint& block) const {
    Extent extent = {{block.plan.west.raw, block.plan.north.raw, block.bottom.raw},
                     {block.plan.east.raw, block.plan.south.raw, block.top.raw}};
    if (block.mover < 0) return extent;
    const Axis axis =
        block.motion < 0 ? Axis::z : world_->motions[static_cast<std::size_t>(block.motion)].axis;
    std::int32_t& low = extent.low[static_cast<std::size_t>(axis)];
    std::int32_t& high = extent.high[static_cast<std::size_t>(axis)];
    low = floored(low);
    high = floored(high + kQuarterUnit - 1);
    return extent;
}

// ---- Lamps

void LightScene::hangLamps() {
    lamps_.clear();
    for (const Lamp& lamp : map_->baked.lamps) hang(lamp, nullptr);
    for (const Object& object : map_->objects) {
        if (object.lamp == kNoLamp) continue;
        hang({object.x, object.y, object.z + Coordinate{object.height.raw / 5 * 4},
              world_->lampKinds[object.lamp]},
             nullptr);
    }
    std::vector<bool> hasLamp(world_->blueprints.size());
    bool any = false;
    for (std::size_t i = 1; i < hasLamp.size(); ++i) {
        const auto& faces = world_->blueprints[i].faces;
        hasLamp[i] = std::any_of(faces.begin(), faces.end(),
                                 [](const FaceBlueprint& face) { return face.lamp != kNoLamp; });
        any = any || hasLamp[i];
    }
    for (int y = 0; any && y < map_->depth; ++y) {
        for (int x = 0; x < map_->width; ++x) {
            for (std::uint32_t levels = map_->occupied[map_->tileIndex(x, y)]; levels != 0;
                 levels &= levels - 1) {
                const int level = std::countr_zero(levels);
                const BlueprintId id = map_->cell(x, y, level);
                if (!hasLamp[id]) continue;
                for (int i = 0; i < kFaces; ++i) {
                    const LampId lamp =
                        world_->blueprints[id].faces[static_cast<std::size_t>(i)].lamp;
                    LitArea area;
                    if (lamp == kNoLamp || !findArea({x, y, level, static_cast<LitFace>(i)}, area))
                        continue;
                    const std::int32_t a = (area.low[0] + area.high[0]) / 2;
                    const std::int32_t b = (area.low[1] + area.high[1]) / 2;
                    LightVector at{};
                    at[static_cast<std::size_t>(area.normal)] =
                        area.planeAt(a, b) + area.sign * kLampHang;
                    at[static_cast<std::size_t>(area.a)] = a;
                    at[static_cast<std::size_t>(area.b)] = b;
                    hang({{at[0]}, {at[1]}, {at[2]}, world_->lampKinds[lamp]}, &area);
                }
            }
        }
    }
    sortLamps();
}

void LightScene::hang(const Lamp& lamp, const LitArea* face) {
    if (lamps_.size() >= kMaxLamps) return;
    const auto radius = static_cast<double>(lamp.kind.radius.raw);
    HungLamp hung;
    hung.at = {lamp.x.raw, lamp.y.raw, lamp.z.raw};
    hung.kind = lamp.kind;
    hung.kind.strength *= map_->baked.lampStrength;
    hung.square = radius * radius;
    hung.ofFace = face != nullptr;
    if (face != nullptr) hung.face = *face;
    lamps_.push_back(hung);
}

namespace {

constexpr std::int32_t kCubeSide = kLampCube * 65536;

// Of kFarthestLamp a side: a lamp reaches the squares beside its own, and no others.
int squareOf(std::int32_t raw, int count) {
    return std::clamp(raw / kFarthestLamp.raw, 0, count - 1);
}

}  // namespace

void LightScene::sortLamps() {
    const int side = kFarthestLamp.raw >> 16;
    lampColumns_ = (map_->width + side - 1) / side;
    lampRows_ = (map_->depth + side - 1) / side;
    firstInSquare_.assign(static_cast<std::size_t>(lampColumns_ * lampRows_) + 1, 0);
    inSquares_.resize(lamps_.size());
    const auto squareNumber = [&](const HungLamp& lamp) {
        return static_cast<std::size_t>(squareOf(lamp.at[1], lampRows_) * lampColumns_ +
                                        squareOf(lamp.at[0], lampColumns_));
    };
    for (const HungLamp& lamp : lamps_) ++firstInSquare_[squareNumber(lamp) + 1];
    for (std::size_t i = 1; i < firstInSquare_.size(); ++i)
        firstInSquare_[i] += firstInSquare_[i - 1];
    std::vector<std::uint32_t> next(firstInSquare_.begin(), firstInSquare_.end() - 1);
    for (std::size_t i = 0; i < lamps_.size(); ++i)
        inSquares_[next[squareNumber(lamps_[i])]++] = static_cast<std::uint16_t>(i);
    for (CubeLamps& lamps : cubes_) lamps.known = false;
}

// Lists, in near_, the lamps that reach a cube: as many of the nearest as may light it.
void LightScene::chooseLamps(const LightVector& cube) {
    near_.clear();
    const int column = squareOf(cube[0] * kCubeSide, lampColumns_);
    const int row = squareOf(cube[1] * kCubeSide, lampRows_);
    const auto look = [&](const HungLamp& lamp, std::uint16_t number) {
        std::int64_t toCube = 0;
        std::int64_t toMiddle = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int64_t low = std::int64_t{cube[i]} * kCubeSide;
            const std::int64_t at = lamp.at[i];
            const std::int64_t outside =
                std::max({low - at, at - low - kCubeSide, std::int64_t{0}});
            const std::int64_t fromMiddle = at - low - kCubeSide / 2;
            toCube += outside * outside;
            toMiddle += fromMiddle * fromMiddle;
        }
        if (static_cast<double>(toCube) < lamp.square) near_.push_back({toMiddle, number});
    };
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, lampRows_ - 1); ++y) {
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, lampColumns_ - 1); ++x) {
            const auto square = static_cast<std::size_t>(y * lampColumns_ + x);
            const std::uint32_t end = firstInSquare_[square + 1];
            for (std::uint32_t i = firstInSquare_[square]; i < end; ++i)
                look(lamps_[inSquares_[i]], inSquares_[i]);
            work_ += (end - firstInSquare_[square]) / 4;
        }
    }
    work_ += static_cast<LightWork>(near_.size());
    if (near_.size() <= kMaxLampsOfCube) return;
    mergeSort(near_, nearRoom_, [](const NearLamp& a, const NearLamp& b) {
        return a.square != b.square ? a.square < b.square : a.number < b.number;
    });
    near_.resize(kMaxLampsOfCube);
}

std::span<const std::uint16_t> LightScene::lampsNear(const LightVector& point) {
    if (lamps_.empty()) return {};
    const LightVector cube = {point[0] >> 18, point[1] >> 18, point[2] >> 18};
    static_assert(kCubeSide == 1 << 18);
    // Those of 8 x 8 x 16 cubes have places of their own
    const auto place =
        static_cast<std::size_t>((cube[0] & 7) | (cube[1] & 7) << 3 | (cube[2] & 15) << 6);
    CubeLamps& lamps = cubes_[place & (cubes_.size() - 1)];
    if (!lamps.known || lamps.cube != cube) {
        chooseLamps(cube);
        lamps.cube = cube;
        lamps.known = true;
        lamps.count = static_cast<std::uint8_t>(near_.size());
        for (std::size_t i = 0; i < near_.size(); ++i) lamps.numbers[i] = near_[i].number;
    }
    return {lamps.numbers.data(), lamps.count};
}

// ---- Faces

bool LightScene::findArea(const LitFaceAt& at, LitArea& area) const {
    if (!map_->contains(at.x, at.y)) return false;
    const std::int32_t west = tileEdge(at.x).raw;
    const std::int32_t north = tileEdge(at.y).raw;
    if (at.face >= LitFace::floor) {
        const bool isFloor = at.face == LitFace::floor;
        const Ceiling& ceiling = map_->ceiling;
        if (!isFloor &&
            (ceiling.tiles.empty() || ceiling.tiles[map_->tileIndex(at.x, at.y)] == kNoTexture))
            return false;
        area = {.sign = at.face == LitFace::ceilingBelow ? -1 : 1,
                .plane = isFloor ? 0 : ceiling.height.raw,
                .tile = {west, north},
                .low = {west, north},
                .high = {west + 65536, north + 65536}};
        return true;
    }
    if (!map_->isOccupied(at.x, at.y, at.level)) return false;
    const CellBlueprint& block = world_->blueprints[map_->cell(at.x, at.y, at.level)];
    const Plan& plan = block.plan;
    const std::int32_t base = tileEdge(at.level).raw;
    const LightVector tile = {west, north, base};
    const Extent extent = extentOf(block);
    LightVector low = extent.low;
    LightVector high = extent.high;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] += tile[axis];
        high[axis] += tile[axis];
    }
    const auto face = static_cast<Face>(at.face);
    const bool isCutFace = plan.half != Half::none && face == cutFace(plan.half);
    if (plan.half != Half::none && at.face <= LitFace::west && !isCutFace &&
        !hasSide(plan.half, face))
        return false;
    const bool alongX = at.face == LitFace::east || at.face == LitFace::west;
    const bool isFlat = at.face == LitFace::top || at.face == LitFace::bottom;
    area.normal = isFlat ? 2 : alongX ? 0 : 1;
    area.sign =
        at.face == LitFace::top || at.face == LitFace::east || at.face == LitFace::south ? 1 : -1;
    area.a = alongX ? 1 : 0;
    area.b = isFlat ? 1 : 2;
    const auto along = [&](const LightVector& v) {
        return std::array{v[static_cast<std::size_t>(area.a)], v[static_cast<std::size_t>(area.b)]};
    };
    area.plane = (area.sign > 0 ? high : low)[static_cast<std::size_t>(area.normal)];
    area.rise = {};
    area.low = along(low);
    area.high = along(high);
    area.tile = area.at = along(tile);
    if (isCutFace) {
        const bool isFalling = isCutFalling(plan.half);
        area.plane = isFalling ? north : north + 65536;
        area.rise[0] = isFalling ? 65536 : -65536;
    } else if (isFlat && !block.slopes.of(face).isLevel()) {
        const Slopes slopes = slopesInLight(block);
        const Slant& slant = slopes.of(face);
        const std::size_t axis = slopes.alongX ? 0 : 1;
        area.plane = base + slant.from.raw;
        area.at[axis] += slant.shift.raw;
        area.rise[axis] = slant.rise();
    }
    return true;
}

LitFaceAt LightScene::beside(LitFaceAt at, const LitArea& area, int stepA, int stepB) {
    (area.a == 0 ? at.x : at.y) += stepA;
    (area.b == 2 ? at.level : at.y) += stepB;
    if (area.normal == 1 && area.rise[0] != 0) at.y += area.rise[0] > 0 ? stepA : -stepA;
    return at;
}

bool LightScene::isInOpaque(const LightVector& point) {
    if (point[2] < 0) return true;  // below the floor
    const int x = point[0] >> 16;
    const int y = point[1] >> 16;
    const int level = point[2] >> 16;
    if (map_->contains(x, y)) touched_ |= changeableBit(x, y, level);
    if (!map_->isOccupied(x, y, level)) return false;
    const CellBlueprint& block = world_->blueprints[map_->cell(x, y, level)];
    if (block.seeThrough) return false;
    const auto within = [](std::int32_t raw, std::int32_t low, std::int32_t high) {
        return (raw & 0xffff) >= low && (raw & 0xffff) < high;
    };
    const Extent extent = extentOf(block);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!within(point[axis], extent.low[axis], extent.high[axis])) return false;
    }
    return eachCut(block, {tileEdge(x).raw, tileEdge(y).raw, tileEdge(level).raw},
                   [&](const LightCut& cut) { return cut.contains(point); });
}

}  // namespace slicecast

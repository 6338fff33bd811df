// The ways of light through the air of a map.
#include "render/light/light_cuts.h"
#include "render/light/light_scene.h"

#include <algorithm>

namespace slicecast {
namespace {

Face leftFace(std::size_t axis, bool up) {
    return axis == 0   ? (up ? Face::east : Face::west)
           : axis == 1 ? (up ? Face::south : Face::north)
                       : (up ? Face::top : Face::bottom);
}

// Whether parts of a mover join where one is left through a face for the other.
bool areOneAcross(const World& world, const CellBlueprint& a, const CellBlueprint& b, Face left) {
    if (left == Face::top || left == Face::bottom) return areOneMover(a, b);
    return areOneAlong(world, a, b, left == Face::east || left == Face::west ? Axis::x : Axis::y);
}

}  // namespace

// A way through the map, as far as it has been followed.
struct LightScene::Travel {
    LightWay way;
    LightTint tint = {255, 255, 255};
    // The see-through block that the way is in, or was in last; null if it has been dealt with.
    const CellBlueprint* inside = nullptr;
    LightMoment leaves = 0;
    Face leaving = Face::top;
    bool leavesInTime = false;       // before the way ends
    bool joinsAfter = false;         // the next block may join it
    TextureId ceiling = kNoTexture;  // that it has crossed

    void dim(const LightTint& by) {
        for (std::size_t i = 0; i < 3; ++i)
            tint[i] = static_cast<std::uint8_t>((tint[i] * by[i] + 127) / 255);
    }
};

// The part of a way within a block.
struct LightScene::Passage {
    LightMoment in = 0;
    LightMoment out = kNeverMet;
    Face leaving = Face::top;
    bool leavesInTime = true;  // before the way ends
    bool joinsBefore = true;   // it may join the block that the way has just left
    bool joinsAfter = true;
};

const LightTint& LightScene::tintOf(TextureId texture) {
    Tint& tint = tints_[texture];
    if (tint.known) return tint.tint;
    tint.known = true;
    const std::vector<Pixel>& texels = world_->textures[texture].levels[0].texels;
    std::array<std::int64_t, 3> sums{};
    for (const Pixel texel : texels) {
        const Colour c = toColour(texel);
        const std::int64_t clear = 255 - c.a;
        const std::array channels = {c.r, c.g, c.b};
        for (std::size_t i = 0; i < 3; ++i) sums[i] += clear * (255 * clear + channels[i] * c.a);
    }
    const auto n = static_cast<std::int64_t>(texels.size());
    for (std::size_t i = 0; i < 3; ++i)
        tint.tint[i] = static_cast<std::uint8_t>((sums[i] + 32512 * n) / (65025 * n));
    return tint.tint;
}

LightTint LightScene::through(const LightVector& from, const LightVector& step, bool endless) {
    constexpr LightTint kDark = {0, 0, 0};
    Travel travel{{from, step, endless}};
    const LightWay& way = travel.way;
    if (step[2] < 0 && from[2] + step[2] < 0) return kDark;
    const int ceiling = map_->ceiling.tiles.empty() ? 0 : map_->ceiling.height.raw >> 16;
    const int highest = std::max(map_->levels - 1, ceiling);
    // Kept at hand: most cells hold nothing
    const int width = map_->width;
    const int depth = map_->depth;
    const bool hasCeiling = !map_->ceiling.tiles.empty();
    const std::uint32_t* const occupied = map_->occupied.data();
    const std::uint32_t* const changing = map_->changing.empty() ? occupied : map_->changing.data();
    LightMoment enter = 0;
    bool isLit = true;
    LightWork cells = 0;
    way.eachCell([&](const LightVector& cell, LightMoment leave, std::size_t axis) {
        const auto& [x, y, level] = cell;
        ++cells;
        if (step[2] >= 0 && level > highest) return false;
        if (x >= 0 && y >= 0 && x < width && y < depth) {
            const int tile = y * width + x;
            const bool isEmpty =
                !hasCeiling && (level < 0 || level > highest ||
                                ((occupied[tile] | changing[tile]) >> level & 1) == 0);
            isLit = isEmpty || meetCell(travel, cell, enter, leave, axis);
            enter = leave;
            return isLit;
        }
        enter = leave;
        const bool isGone = (step[0] <= 0 && x < 0) || (step[0] >= 0 && x >= width) ||
                            (step[1] <= 0 && y < 0) || (step[1] >= 0 && y >= depth);
        return !isGone;
    });
    work_ += cells;
    if (!isLit) return kDark;
    if (travel.inside != nullptr && travel.leavesInTime) leaveBlock(travel);
    if (travel.ceiling != kNoTexture) travel.dim(tintOf(travel.ceiling));
    return travel.tint;
}

// The way's part in a cell of the grid, which it leaves along an axis. Returns false if the way
// ends in the dark.
bool LightScene::meetCell(Travel& travel, const LightVector& cell, LightMoment enter,
                          LightMoment leave, std::size_t axis) {
    const auto& [x, y, level] = cell;
    const std::size_t tile = map_->tileIndex(x, y);
    if (!map_->ceiling.tiles.empty() && !meetCeiling(travel, tile, enter, leave)) return false;
    if (level < 0 || level >= map_->levels) return true;
    touched_ |= changeableBit(x, y, level);
    if ((map_->occupied[tile] >> level & 1) == 0) return true;
    const BlueprintId id = map_->cells[map_->cellIndex(x, y, level)];
    const Look look = looks_[id];
    if (look.isWhole && !look.isClear) return false;
    constexpr LightWork kWorkOfPart = 2;
    constexpr LightWork kWorkOfClear = 4;
    if (!look.isWhole) work_ += kWorkOfPart;
    if (look.isClear) work_ += kWorkOfClear;
    const LightWay& way = travel.way;
    const CellBlueprint& block = world_->blueprints[id];
    Passage passage = {enter, leave, leftFace(axis, way.step[axis] > 0),
                       way.isEndless || leave < way.whole};
    if (!look.isWhole &&
        !findPassage(way, block, {tileEdge(x).raw, tileEdge(y).raw, tileEdge(level).raw}, passage))
        return true;
    if (!look.isClear) return false;
    if (travel.inside != nullptr) {
        const bool joins = travel.joinsAfter && passage.joinsBefore &&
                           travel.leaves == passage.in &&
                           (areJoined(*world_, *travel.inside, block) ||
                            areOneAcross(*world_, *travel.inside, block, travel.leaving));
        if (!joins) leaveBlock(travel);
    }
    travel.inside = &block;
    travel.leaves = passage.out;
    travel.leaving = passage.leaving;
    travel.leavesInTime = passage.leavesInTime;
    travel.joinsAfter = passage.joinsAfter;
    return true;
}

// The same for the tile's ceiling.
bool LightScene::meetCeiling(Travel& travel, std::size_t tile, LightMoment enter,
                             LightMoment leave) const {
    const TextureId texture = map_->ceiling.tiles[tile];
    if (texture == kNoTexture || !travel.way.reaches(map_->ceiling.height.raw, 2)) return true;
    const LightMoment at = travel.way.at(map_->ceiling.height.raw, 2);
    if (at <= enter || at > leave || at >= travel.way.end()) return true;
    travel.ceiling = texture;
    return world_->textures[texture].seeThrough;
}

bool LightScene::meets(const LightWay& way, BlueprintId id) const {
    const CellBlueprint& block = world_->blueprints[id];
    Passage passage;
    if (!findBox(way, block, {0, 0, 0}, passage)) return false;
    if (!isCut(block)) return true;
    // In most of them it is well behind a cut all along, or well before all cuts somewhere
    const double perShare = 1.0 / static_cast<double>(way.whole);
    const auto depthAt = [&](const LightCut& cut, LightMoment moment) {
        return static_cast<double>(cut.depthOf(way.from)) +
               static_cast<double>(cut.along(way.step)) * (static_cast<double>(moment) * perShare);
    };
    constexpr double kRounding = 65536.0;
    bool isBehind = false;
    bool isIn = true;
    bool isOut = true;
    eachCut(block, {0, 0, 0}, [&](const LightCut& cut) {
        const double first = depthAt(cut, passage.in);
        const double last = depthAt(cut, passage.out);
        isBehind = isBehind || std::max(first, last) < -kRounding;
        isIn = isIn && first > kRounding;
        isOut = isOut && last > kRounding;
        return true;
    });
    if (isBehind) return false;
    return isIn || (isOut && passage.leavesInTime) || cutPassage(way, block, {0, 0, 0}, passage);
}

// The way's part within the box round a block whose cell begins there. Returns false if it does not
// meet it.
bool LightScene::findBox(const LightWay& way, const CellBlueprint& block, const LightVector& corner,
                         Passage& passage) const {
    const auto [low, high] = extentOf(block);
    LightMoment in = 0;
    LightMoment out = kNeverMet;
    std::size_t outAxis = 2;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::int32_t begin = corner[i] + low[i];
        const std::int32_t end = corner[i] + high[i];
        if (way.step[i] == 0) {
            if (way.from[i] < begin || way.from[i] >= end) return false;
            continue;
        }
        const bool isRising = way.step[i] > 0;
        in = std::max(in, way.at(isRising ? begin : end, i));
        const LightMoment exit = way.at(isRising ? end : begin, i);
        if (exit < out) {
            out = exit;
            outAxis = i;
        }
    }
    if (in >= out || in >= way.end()) return false;
    passage = {in, out, leftFace(outAxis, way.step[outAxis] > 0), way.isEndless || out < way.whole};
    return true;
}

// The same within the block itself.
bool LightScene::findPassage(const LightWay& way, const CellBlueprint& block,
                             const LightVector& corner, Passage& passage) const {
    return findBox(way, block, corner, passage) &&
           (!isCut(block) || cutPassage(way, block, corner, passage));
}

// The same of a block with cuts, within the passage through its box. Nothing joins at a cut.
bool LightScene::cutPassage(const LightWay& way, const CellBlueprint& block,
                            const LightVector& corner, Passage& passage) {
    CutMoment in(way, passage.in);
    CutMoment out(way, passage.out);
    const bool isNear = eachCut(block, corner, [&](const LightCut& cut) {
        const std::int64_t speed = cut.along(way.step);
        if (speed == 0) return cut.contains(way.from);
        const std::int64_t depth = cut.depthOf(way.from);
        const auto& n = cut.normal;
        if (speed > 0) {
            const CutMoment at(-depth, speed, {-n[0], -n[1], -n[2]});
            if (in.isBefore(at)) {
                in = at;
                passage.joinsBefore = false;
            }
        } else {
            const CutMoment at(depth, -speed, n);
            if (at.isBefore(out)) {
                out = at;
                passage.leaving = cut.face;
                passage.joinsAfter = false;
            }
        }
        return true;
    });
    const CutMoment end(1, way.isEndless ? 0 : 1);
    if (!isNear || !in.isBefore(out) || !in.isBefore(end)) return false;
    passage.leavesInTime = way.isEndless || out.isBefore(end);
    return true;
}

void LightScene::leaveBlock(Travel& travel) {
    const TextureId texture = travel.inside->face(travel.leaving).texture;
    if (texture != kNoTexture) travel.dim(tintOf(texture));
    travel.inside = nullptr;
}

}  // namespace slicecast

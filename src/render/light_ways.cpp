// The ways of light through the air of a map.
#include "render/light_scene.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace slicecast {
namespace {

Face leftFace(int axis, bool up) {
    return axis == 0   ? (up ? Face::east : Face::west)
           : axis == 1 ? (up ? Face::south : Face::north)
                       : (up ? Face::top : Face::bottom);
}

}  // namespace

// A way through the map, as far as it is known.
struct LightScene::Way {
    LightVector from;
    LightVector step;
    bool isEndless;
    Moment end;
    LightTint tint = {255, 255, 255};
    // The see-through block that the way is in, or was in last; null if it has been dealt with.
    const CellBlueprint* inside = nullptr;
    Moment leaves{};
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
    Moment in;
    Moment out;
    Face leaving;
    bool isMet;
    bool leavesInTime;
    bool joinsBefore;  // it may join the block that the way has just left
    bool joinsAfter;
};

// The part of a way over a tile. Heights are rounded.
struct LightScene::Stretch {
    Moment enter;
    Moment leave;
    double enterHeight;
    double leaveHeight;
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

LightTint LightScene::through(const LightVector& from, const LightVector& way, bool endless) {
    constexpr LightTint kDark = {0, 0, 0};
    Way here{from, way, endless, endless ? Moment{1, 0, 0} : Moment{1, 1, 0}};
    if (way[2] < 0) {
        if (isBefore(crossing(from[2], way[2], 0, 2), here.end)) return kDark;
    } else if (way[2] > 0) {
        const Moment above = crossing(from[2], way[2], std::max(highest_, from[2]), 2);
        if (isBefore(above, here.end)) here.end = above;
    }
    int x = from[0] >> 16;
    int y = from[1] >> 16;
    const auto border = [&](int axis, int tile) {
        const std::int32_t d = way[static_cast<std::size_t>(axis)];
        if (d == 0) return Moment{1, 0, 0};
        return crossing(from[static_cast<std::size_t>(axis)], d,
                        tileEdge(d > 0 ? tile + 1 : tile).raw, axis);
    };
    const auto climb = [&](std::int32_t d) {  // height for each 1/65536 of a unit along an axis
        return d == 0 ? 0.0
                      : std::fabs(static_cast<double>(way[2]) / d) * (way[2] < 0 ? -1.0 : 1.0);
    };
    const double climbX = climb(way[0]);
    const double climbY = climb(way[1]);
    const double endHeight =
        here.end.den == 0
            ? from[2]
            : from[2] + static_cast<double>(way[2]) *
                            (static_cast<double>(here.end.num) / static_cast<double>(here.end.den));
    Moment leaveX = border(0, x);
    Moment leaveY = border(1, y);
    Stretch over{{0, 1, 0}, {}, static_cast<double>(from[2]), 0.0};
    while (true) {
        const bool alongX = isBefore(leaveX, leaveY);
        over.leave = alongX ? leaveX : leaveY;
        const bool ends = !isBefore(over.leave, here.end);
        over.leaveHeight =
            ends ? endHeight
                 : from[2] + static_cast<double>(over.leave.num) * (alongX ? climbX : climbY);
        if (map_->contains(x, y)) {
            if (!meetTile(here, x, y, over)) return kDark;
        } else if ((way[0] <= 0 && x < 0) || (way[0] >= 0 && x >= map_->width) ||
                   (way[1] <= 0 && y < 0) || (way[1] >= 0 && y >= map_->depth)) {
            break;
        }
        if (ends) break;
        over.enter = over.leave;
        over.enterHeight = over.leaveHeight;
        if (alongX) {
            x += way[0] > 0 ? 1 : -1;
            leaveX = border(0, x);
        } else {
            y += way[1] > 0 ? 1 : -1;
            leaveY = border(1, y);
        }
    }
    if (here.inside != nullptr && here.leavesInTime) leaveBlock(here);
    if (here.ceiling != kNoTexture) here.dim(tintOf(here.ceiling));
    return here.tint;
}

// Returns false if the way ends in the dark.
bool LightScene::meetTile(Way& way, int x, int y, const Stretch& over) {
    const std::size_t tile = map_->tileIndex(x, y);
    touched_ |= changeableBit(x, y);
    std::uint32_t levels = map_->occupied[tile];
    const bool hasCeiling = !map_->ceiling.tiles.empty() && map_->ceiling.tiles[tile] != kNoTexture;
    if (levels == 0 && !hasCeiling) return true;

    // Rounded outwards
    const double first = over.enterHeight;
    const double second = over.leaveHeight;
    const double low = std::min(first, second) - 2.0;
    const double high = std::max(first, second) + 2.0;
    if (hasCeiling && way.step[2] != 0 && low <= map_->ceiling.height.raw &&
        high >= map_->ceiling.height.raw) {
        const Moment at = crossing(way.from[2], way.step[2], map_->ceiling.height.raw, 2);
        if (isBefore(over.enter, at) && isBefore(at, over.leave) && isBefore(at, way.end)) {
            const TextureId texture = map_->ceiling.tiles[tile];
            if (!world_->textures[texture].seeThrough) return false;
            way.ceiling = texture;
        }
    }
    const int lowest = std::max(0, static_cast<int>(low / 65536.0));
    const int highest = static_cast<int>(std::min(high / 65536.0, 31.0));
    if (highest < lowest || high < 0.0) return true;
    levels &= (0xffffffffu >> (31 - highest)) & (0xffffffffu << lowest);
    while (levels != 0) {
        const int level =
            way.step[2] >= 0 ? std::countr_zero(levels) : 31 - std::countl_zero(levels);
        levels &= ~(1u << level);
        const CellBlueprint& block = world_->blueprints[map_->cell(x, y, level)];
        if (!block.seeThrough && block.isBox()) {
            // Most are passed, or met, by more than could be rounded
            const Extent extent = extentOf(block);
            const double bottom = tileEdge(level).raw + extent.low[2];
            const double top = tileEdge(level).raw + extent.high[2];
            if (high < bottom || low > top) continue;
            if ((first > bottom + 2.0 && first < top - 2.0) ||
                (second > bottom + 2.0 && second < top - 2.0))
                return false;
        }
        if (!meetBlock(way, block, x, y, level, over.enter, over.leave)) return false;
    }
    return true;
}

// The same for one block.
bool LightScene::meetBlock(Way& way, const CellBlueprint& block, int x, int y, int level,
                           const Moment& enter, const Moment& leave) {
    const LightVector tile = {tileEdge(x).raw, tileEdge(y).raw, tileEdge(level).raw};
    const auto [low, high] = extentOf(block);
    Moment in = enter;
    Moment out = {1, 0, 0};
    int outAxis = 2;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::int32_t from = way.from[i];
        const std::int32_t step = way.step[i];
        if (step == 0) {
            if (from < tile[i] + low[i] || from >= tile[i] + high[i]) return true;
            continue;
        }
        const int axis = static_cast<int>(i);
        const Moment entry = crossing(from, step, tile[i] + (step > 0 ? low[i] : high[i]), axis);
        const Moment exit = crossing(from, step, tile[i] + (step > 0 ? high[i] : low[i]), axis);
        if (isBefore(in, entry)) in = entry;
        if (isBefore(exit, out)) {
            out = exit;
            outAxis = axis;
        }
    }
    Passage passage = {in,
                       out,
                       leftFace(outAxis, way.step[static_cast<std::size_t>(outAxis)] > 0),
                       isBefore(in, out) && isBefore(in, way.end) && isBefore(in, leave),
                       way.isEndless || isBefore(out, {1, 1, 0}),
                       true,
                       true};
    if (!passage.isMet || (isCut(block) && !cutPassage(way, block, tile, leave, passage)))
        return true;
    if (!block.seeThrough) return false;
    if (way.inside != nullptr) {
        const bool joins =
            way.joinsAfter && passage.joinsBefore && isSame(way.leaves, in) &&
            (areJoined(*world_, *way.inside, block) || areOneMover(*way.inside, block));
        if (!joins) leaveBlock(way);
    }
    way.inside = &block;
    way.leaves = out;
    way.leaving = passage.leaving;
    way.leavesInTime = passage.leavesInTime;
    way.joinsAfter = passage.joinsAfter;
    return true;
}

CutMoment LightScene::cutMoment(const Moment& moment) {
    CutMoment cut = {moment.num, moment.den};
    if (moment.late < 0) cut.late[static_cast<std::size_t>(moment.late + 3)] = -1;
    if (moment.late > 0) cut.late[static_cast<std::size_t>(3 - moment.late)] = 1;
    return cut;
}

// The same of a block with cuts, within the passage through its box. Nothing joins at a cut.
// Returns false if the way does not meet it.
bool LightScene::cutPassage(const Way& way, const CellBlueprint& block, const LightVector& tile,
                            const Moment& leave, Passage& passage) {
    CutMoment in = cutMoment(passage.in);
    CutMoment out = cutMoment(passage.out);
    const bool isNear = eachCut(block, tile, [&](const LightCut& cut) {
        const std::int64_t speed = cut.along(way.step);
        if (speed == 0) return cut.contains(way.from);
        const std::int64_t depth = cut.depthOf(way.from);
        const auto& n = cut.normal;
        if (speed > 0) {
            const CutMoment at = {-depth, speed, {-n[0], -n[1], -n[2]}};
            if (in.isBefore(at)) {
                in = at;
                passage.joinsBefore = false;
            }
        } else {
            const CutMoment at = {depth, -speed, n};
            if (at.isBefore(out)) {
                out = at;
                passage.leaving = cut.face;
                passage.joinsAfter = false;
            }
        }
        return true;
    });
    if (!isNear || !in.isBefore(out) || !in.isBefore(cutMoment(way.end)) ||
        !in.isBefore(cutMoment(leave)))
        return false;
    passage.leavesInTime = way.isEndless || out.isBefore({1, 1});
    return true;
}

void LightScene::leaveBlock(Way& way) {
    const TextureId texture = way.inside->face(way.leaving).texture;
    if (texture != kNoTexture) way.dim(tintOf(texture));
    way.inside = nullptr;
}

}  // namespace slicecast

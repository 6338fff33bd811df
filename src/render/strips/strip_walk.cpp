#include "render/strips/strip_walk.h"

#include "render/strips/open_slopes.h"

#include <algorithm>
#include <cstdlib>

namespace slicecast {
namespace {

// Whether parts begin alike, so that their columns can walk together: in one tile, wherever they
// have entered it.
bool isAlike(const Part& a, const Part& b) {
    return a.vista == b.vista && a.clip == b.clip && a.before == b.before &&
           a.portals == b.portals && a.walk.tileX == b.walk.tileX && a.walk.tileY == b.walk.tileY &&
           a.walk.hasEntered() == b.walk.hasEntered();
}

}  // namespace

template <std::size_t... index>
StripWalk::StripWalk(const Frame& frame, StripScratch& scratch, FrameReport& report,
                     SeeThrough seeThrough, std::index_sequence<index...>)
    : scratch_(scratch),
      view_(frame, seeThrough == SeeThrough::cut),
      open_(scratch.open),
      columns_{SliceColumn(view_, scratch.open.rows[index], report)...},
      tile_(view_, rays_, columns_, open_, scratch.enters, scratch.leaves, report) {}

StripWalk::StripWalk(const Frame& frame, StripScratch& scratch, FrameReport& report,
                     SeeThrough seeThrough)
    : StripWalk(frame, scratch, report, seeThrough, std::make_index_sequence<kLanes>()) {}

void StripWalk::find(int first, int count, bool withReflection) {
    first_ = first;
    count_ = count;
    const unsigned all = (1u << count) - 1;
    eachLane(all,
             [&](int i) { columns_[indexOf(i)].begin(first + i, scratch_.found[indexOf(i)]); });
    walkParts(all);
    if (!withReflection) return;
    unsigned mirrored = 0;
    eachLane(all, [&](int i) {
        if (columns_[indexOf(i)].beginReflection(scratch_.found[indexOf(i)])) mirrored |= 1u << i;
    });
    walkParts(mirrored);
}

// Walks the present parts of some columns, and those after them. Walking a part may add more parts.
void StripWalk::walkParts(unsigned bits) {
    while (bits != 0) {
        const unsigned alike = beginAlike(bits);
        walk(alike);
        eachLane(alike, [&](int i) {
            if (!columns_[indexOf(i)].endPart()) bits &= ~(1u << i);
        });
    }
}

// Begins the present parts of those of the columns that begin as the first one does, and returns
// which they are. Only one column if the directions of the strip's columns differ too much.
unsigned StripWalk::beginAlike(unsigned bits) {
    const int lead = __builtin_ctz(bits);
    const Part& part = columns_[indexOf(lead)].part();
    view_.lookAt(part);
    unsigned alike = 1u << lead;
    if (rays_.aim(*view_.vista, first_, count_)) {
        eachLane(bits, [&](int i) {
            if (isAlike(part, columns_[indexOf(i)].part())) alike |= 1u << i;
        });
    } else {
        rays_.aim(*view_.vista, first_ + lead, 1);
    }
    startU_ = rays_.alongX ? view_.startX : view_.startY;
    startV_ = rays_.alongX ? view_.startY : view_.startX;
    startsInTile_ = !part.walk.hasEntered();
    double nearest = kNever;
    eachLane(alike,
             [&](int i) { nearest = std::min(nearest, columns_[indexOf(i)].part().walk.entered); });
    eachLane(alike, [&](int i) { columns_[indexOf(i)].beginPart(nearest); });
    return alike;
}

// Walks the present parts of the columns in `bits`, which begin alike, to their ends.
void StripWalk::walk(unsigned bits) {
    open_.begin(bits);
    StripCover& cover = tile_.cover;
    cover.floor = LaneValues(inAllLanes(view_.map->floor.texture));
    cover.ceiling = LaneValues(inAllLanes(kNoTexture));
    cover.floorFromU = cover.ceilingFromU = LaneValues(inAllLanes(startU_));
    cover.floorFromV = cover.ceilingFromV = LaneValues(inAllLanes(startV_));
    cover.ceilingRow = LaneValues(inAllLanes(0));
    cover.changed = true;
    nearV_ = LaneValues(inAllLanes(std::clamp(startV_, -1, rays_.sizeV)));
    tile_.u = startU_;
    tile_.v = startV_;
    tile_.near = std::max(0.0, rays_.entersU(startU_));
    tile_.far = rays_.leavesU(startU_);
    slabIsOpen_ = true;
    noticeChange(bits);
    for (;;) {
        if (slabIsOpen_) {
            while (passOpenLand()) {
            }
        }
        slabIsOpen_ = true;
        findFarTiles();
        walkSlab();
        if (open_.live() == 0) return;
        const int next = tile_.u + rays_.stepU;
        const bool isOut = rays_.stepU > 0 ? next >= rays_.sizeU : next < 0;
        if (isOut || isBeyond(tile_.far * rays_.alongPerU)) return endBeyond(open_.live(), isOut);
        tile_.u = next;
        tile_.near = tile_.far;
        tile_.far += 1.0;
        nearV_ = farV_;
    }
}

void StripWalk::walkSlab() {
    const int one = __builtin_ctz(open_.live());
    const int other = 31 - __builtin_clz(open_.live());
    const auto [least, most] =
        std::minmax({nearV_.at[one], nearV_.at[other], farV_.at[one], farV_.at[other]});
    const int lowest = std::max<int>(least, 0);
    const int highest = std::min<int>(most, rays_.sizeV - 1);
    const bool isInGrid = tile_.u >= 0 && tile_.u < rays_.sizeU;
    const bool isWithin = isInGrid && lowest == least && highest == most;
    if (!isWithin) meetObjectsOutside();
    if (isInGrid) {
        for (int v = std::max(startV_, lowest); v <= highest; ++v) visit(v);
        for (int v = std::min(startV_ - 1, highest); v >= lowest; --v) visit(v);
    }
    if (!isWithin) endBeyond(leavingSideways(), true);
}

// Visits a tile of the slab.
void StripWalk::visit(int v) {
    const Map& map = *view_.map;
    const std::size_t tile = rays_.alongX ? map.tileIndex(tile_.u, v) : map.tileIndex(v, tile_.u);
    std::uint32_t reached = map.occupied[tile];
    const double left = tile_.far * rays_.alongPerUMost;
    if (reached != 0) {
        const OpenSlopes slopes(*view_.projection, open_.first(), open_.last(), view_.eyeHeight,
                                view_.lowest);
        reached &= slopes.levelsReached(tile_.near * rays_.alongPerU, left);
    }
    const TextureId floor = map.floor.tiles[tile];
    const TextureId ceiling = view_.ceilingTiles ? view_.ceilingTiles[tile] : kNoTexture;
    const bool isPortal = view_.hasTilePortals && map.tilePortals[tile] != kNoPortal;
    const bool hasObjects = left > nextObject_;
    if (reached == 0 && floor == tile_.cover.onlyFloor && ceiling == tile_.cover.onlyCeiling &&
        !hasObjects && !isPortal)
        return;
    const unsigned live = open_.live();
    unsigned bits = crossing(v);
    if (bits == 0) return;
    slabIsOpen_ = false;
    const bool isFirst = isFirstTile(v);
    if (isPortal && !isFirst) {
        tile_.enter(bits);
        enterPortalTile(tile_);
    } else {
        const int x = tile_.tileX();
        const int y = tile_.tileY();
        if (reached != 0 && areFull(bits)) reached = view_.withoutLayers(x, y, reached);
        std::uint32_t plans = reached == 0 ? 0 : view_.levelsWithPlans(x, y);
        plans &= reached | reached << 1 | reached >> 1;
        const unsigned divided = isFirst || plans != 0 || isAtEye(bits) ? bits
                                 : hasObjects                           ? withObjects(bits)
                                                                        : 0;
        if (divided != 0) meetStretches(divided, plans, reached, floor, ceiling);
        bits &= ~divided;
        if (bits != 0) {
            tile_.enter(bits);
            meetStretch(tile_, reached, floor, ceiling);
        }
    }
    noticeChange(live);
}

// Whether no more layers can be added to any of the columns.
bool StripWalk::areFull(unsigned bits) const {
    for (; bits != 0; bits &= bits - 1) {
        if (!columns_[indexOf(__builtin_ctz(bits))].isFull()) return false;
    }
    return true;
}

// Whether some columns enter the tile at distance 0.
bool StripWalk::isAtEye(unsigned bits) const {
    const unsigned alongU = bitsOf(tile_.enteredAlongU) & bits;
    return (alongU != 0 && tile_.near <= 0.0) || (alongU != bits && tile_.enteredV <= 0.0);
}

// Finds the columns with open rows that pass a tile of the slab, and how.
unsigned StripWalk::crossing(int v) {
    tile_.v = v;
    tile_.isDivided = tile_.isFirst = false;
    tile_.entersUpward = v > startV_;
    tile_.enteredV = rays_.entersV(v, tile_.entersUpward);
    if (tile_.isWhole) {
        tile_.enteredAlongU = tile_.leftAlongU = inAllLanes(-1);
        return open_.live();
    }
    const Lanes tile = inAllLanes(v);
    const Lanes near = nearV_.lanes();
    const Lanes far = farV_.lanes();
    tile_.enteredAlongU = near == tile;
    tile_.leftAlongU = far == tile;
    return open_.live() & ~bitsOf((tile < lesser(near, far)) | (greater(near, far) < tile));
}

// Those of the columns that pass an object in the tile.
unsigned StripWalk::withObjects(unsigned bits) {
    unsigned found = 0;
    eachLane(bits, [&](int i) {
        ObjectCursor& objects = columns_[indexOf(i)].objects;
        const double leave = tile_.crossingOf(i, Border::leave).along;
        if (!(leave > objects.nextAlong())) return;
        // Rows may have been closed since
        if (leave > objects.knownTo())
            objects.find(tile_.crossingOf(i, Border::enter).along, leave);
        objects.skip(open_.firstOf(i), open_.lastOf(i));
        tile_.cover.changed = true;
        if (leave > objects.nextAlong()) found |= 1u << i;
    });
    return found;
}

// Updates the state after a tile; `live` were the columns with open rows before.
void StripWalk::noticeChange(unsigned live) {
    open_.findEnds();
    eachLane(live & ~open_.live(), [&](int i) {
        countTiles(i, tile_.v);
        open_.write(i);
    });
    StripCover& cover = tile_.cover;
    cover.changed |= live != open_.live();
    live = open_.live();
    if (!cover.changed || live == 0) return;
    cover.changed = false;
    const int one = __builtin_ctz(live);
    const auto only = [&](const LaneValues& textures) {
        const Lanes same = textures.lanes() == inAllLanes(textures.at[one]);
        return (bitsOf(same) & live) == live ? static_cast<TextureId>(textures.at[one]) : -1;
    };
    cover.onlyFloor = only(cover.floor);
    cover.onlyCeiling = only(cover.ceiling);
    nextObject_ = kNever;
    if (!view_.vista->objects.none())
        eachLane(live, [&](int i) {
            nextObject_ = std::min(nextObject_, columns_[indexOf(i)].objects.nextAlong());
        });
}

// Counts a column's tiles, which follow from its position.
void StripWalk::countTiles(int i, int v) {
    columns_[indexOf(i)].countTiles(std::abs(tile_.u - startU_) + std::abs(v - startV_) + 1);
}

}  // namespace slicecast

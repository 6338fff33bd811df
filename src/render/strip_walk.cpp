#include "render/strip_walk.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace slicecast {

template <std::size_t... index>
StripWalk::StripWalk(const Frame& frame, StripScratch& scratch, FrameReport& report,
                     std::index_sequence<index...>)
    : frame_(frame),
      scratch_(scratch),
      report_(report),
      open_(scratch.open),
      lanes_{SliceWalk(frame, scratch.open.rows[index], report, SliceWalk::SeeThrough::cut)...} {}

StripWalk::StripWalk(const Frame& frame, StripScratch& scratch, FrameReport& report)
    : StripWalk(frame, scratch, report, std::make_index_sequence<kLanes>()) {}

void StripWalk::find(int first, int count) {
    const unsigned all = (1u << count) - 1;
    if (!aim(first, count)) {
        eachLane(all, [&](int i) { lane(i).find(first + i, scratch_.found[indexOf(i)]); });
        return;
    }
    eachLane(all, [&](int i) {
        lane(i).beginColumn(first + i, scratch_.found[indexOf(i)]);
        lane(i).begin();
    });
    walk(all);
    unsigned waiting = 0;
    eachLane(all, [&](int i) {
        SliceWalk& column = lane(i);
        if (column.nextPart()) column.walkParts();
        if (column.beginReflection(scratch_.found[indexOf(i)])) waiting |= 1u << i;
    });
    while (waiting != 0) waiting = walkMirrored(waiting);
}

// Walks the present mirrored part of some of the columns: of those that look into one mirror
// together. Returns which columns have another one.
unsigned StripWalk::walkMirrored(unsigned bits) {
    const Vista* mirrored = nullptr;
    unsigned walked = 0;
    unsigned together = 0;
    eachLane(bits, [&](int i) {
        SliceWalk& column = lane(i);
        const Part& part = column.part();
        const bool alone = part.portals > 0;
        if (alone) {
            walked |= 1u << i;
        } else if (mirrored == nullptr || part.vista == mirrored) {
            mirrored = part.vista;
            together |= 1u << i;
        } else {
            return;
        }
        column.begin();
        if (alone) column.goOn(false);
    });
    if (together != 0) walk(together);
    eachLane(walked | together, [&](int i) {
        if (!lane(i).nextPart()) bits &= ~(1u << i);
    });
    return bits;
}

// Finds how the columns cross the map. False if their directions differ too much (few and wide
// columns), or the eye is outside the grid; then they cannot walk together.
bool StripWalk::aim(int first, int count) {
    const Vista& vista = frame_.vistas.ofEye();
    const Viewpoint& eye = vista.viewpoint;
    map_ = vista.map;
    if (!map_->contains(eye.tileX(), eye.tileY())) return false;
    const GroundDirection middle = vista.ray(first + count / 2);
    alongX_ = std::fabs(middle.x) >= std::fabs(middle.y);
    stepU_ = (alongX_ ? middle.x : middle.y) > 0.0 ? 1 : -1;
    alongPerU_ = kNever;
    alongPerUMost_ = 0.0;
    LaneValues steps;
    for (int i = 0; i < kLanes; ++i) {
        const GroundDirection ray = vista.ray(first + std::min(i, count - 1));
        const double u = (alongX_ ? ray.x : ray.y) * stepU_;
        const double v = alongX_ ? ray.y : ray.x;
        if (u <= 0.0 || std::fabs(v) > 2.0 * u) return false;
        speedU_[indexOf(i)] = u;
        speedV_[indexOf(i)] = v == 0.0 ? 1.0 : std::fabs(v);  // as in GridWalk
        rayV_[indexOf(i)] = v;
        slope_[indexOf(i)] = v / u;
        stepV_[indexOf(i)] = v > 0.0 ? 1 : v < 0.0 ? -1 : 0;
        steps.at[i] = inLane(stepV_[indexOf(i)]);
        alongPerU_ = std::min(alongPerU_, 1.0 / u);
        alongPerUMost_ = std::max(alongPerUMost_, 1.0 / u);
    }
    stepsV_ = steps.lanes();
    sizeU_ = alongX_ ? map_->width : map_->depth;
    sizeV_ = alongX_ ? map_->depth : map_->width;
    eyeU_ = alongX_ ? eye.tileX() : eye.tileY();
    eyeV_ = alongX_ ? eye.tileY() : eye.tileX();
    fractionU_ = alongX_ ? eye.fractionX() : eye.fractionY();
    fractionV_ = alongX_ ? eye.fractionY() : eye.fractionX();
    return true;
}

// Walks the columns in `bits` from the eye's tile, all in one vista, to the ends of their parts.
void StripWalk::walk(unsigned bits) {
    any_ = __builtin_ctz(bits);
    projection_ = any().projection_;
    open_.begin(bits);
    floor_ = LaneValues(inAllLanes(map_->floor.texture));
    ceiling_ = LaneValues(inAllLanes(kNoTexture));
    floorFromU_ = ceilingFromU_ = LaneValues(inAllLanes(eyeU_));
    floorFromV_ = ceilingFromV_ = nearV_ = LaneValues(inAllLanes(eyeV_));
    ceilingRow_ = LaneValues(inAllLanes(0));
    u_ = eyeU_;
    near_ = 0.0;
    far_ = stepU_ > 0 ? 1.0 - fractionU_ : fractionU_;
    slabIsOpen_ = true;
    coverChanged_ = true;
    noticeChange(open_.live());
    for (;;) {
        if (slabIsOpen_) {
            while (passOpenLand()) {
            }
        }
        slabIsOpen_ = true;
        walkSlab();
        const int next = u_ + stepU_;
        if (open_.live() == 0) return;
        if (next < 0 || next >= sizeU_ || isBeyond(far_ * alongPerU_)) return goAlone(open_.live());
        u_ = next;
        near_ = far_;
        far_ += 1.0;
        nearV_ = farV_;
    }
}

void StripWalk::walkSlab() {
    findFarTiles();
    constexpr int kLast = kLanes - 1;
    const auto [least, most] =
        std::minmax({nearV_.at[0], nearV_.at[kLast], farV_.at[0], farV_.at[kLast]});
    const int lowest = std::max<int>(least, 0);
    const int highest = std::min<int>(most, sizeV_ - 1);
    for (int v = std::max(eyeV_, lowest); v <= highest; ++v) visit(v);
    for (int v = std::min(eyeV_ - 1, highest); v >= lowest; --v) visit(v);
    if (lowest != least || highest != most) leaveGridSideways();
}

// Columns that leave the grid within the slab: their last tile is the outermost one of the grid.
void StripWalk::leaveGridSideways() {
    unsigned bits = 0;
    eachLane(open_.live(), [&](int i) {
        const int last = std::clamp<int>(farV_.at[i], 0, sizeV_ - 1);
        if (last == farV_.at[i]) return;
        farV_.at[i] = inLane(last);
        bits |= 1u << i;
    });
    goAlone(bits);
}

// Whether only the floor and the sky can be met from there on: see SliceWalk::whereToStop.
bool StripWalk::isBeyond(double along) const {
    return along > any().whereToStop(open_.first(), open_.last());
}

// Walks the rest of some columns one by one, from where they leave the slab.
void StripWalk::goAlone(unsigned bits) {
    eachLane(bits, [&](int i) {
        comeTo(i, farV_.at[i]);
        lane(i).goOn(true);
    });
    open_.close(bits);
    open_.findEnds();
}

// Visits a tile of the slab.
void StripWalk::visit(int v) {
    const SliceWalk& any = this->any();
    const std::size_t tile = map_->tileIndex(tileX(v), tileY(v));
    std::uint32_t reached = map_->occupied[tile];
    const double left = far_ * alongPerUMost_;
    if (reached != 0) {
        const OpenSlopes slopes(*projection_, open_.first(), open_.last(), any.eyeHeight_,
                                any.lowest_);
        reached &= slopes.levelsReached(near_ * alongPerU_, left);
    }
    const TextureId floor = map_->floor.tiles[tile];
    const TextureId ceiling = any.ceilingTiles_ ? any.ceilingTiles_[tile] : kNoTexture;
    const bool isPortal = any.hasTilePortals_ && map_->tilePortals[tile] != kNoPortal;
    const bool hasObjects = left > nextObject_;
    if (reached == 0 && floor == onlyFloor_ && ceiling == onlyCeiling_ && !hasObjects && !isPortal)
        return;
    slabIsOpen_ = false;
    const unsigned live = open_.live();
    unsigned bits = crossing(v);
    if (bits == 0) return;
    if (u_ == eyeU_ && v == eyeV_) {
        meetAlone(bits);
    } else if (isPortal) {
        eachLane(bits, [&](int i) {
            comeTo(i, v);
            lane(i).endWay(Pass::portal);
        });
        open_.close(bits);
    } else {
        const unsigned alone = hasObjects ? withObjects(bits) : 0;
        if (alone != 0) meetAlone(alone);
        bits &= ~alone;
        if (bits == 0) {
        } else if (isAtEye(bits) || !findBlocks(reached)) {
            meetAlone(bits);
        } else {
            meet(bits, floor, ceiling);
        }
    }
    noticeChange(live);
}

// Whether some columns enter the tile at distance 0.
bool StripWalk::isAtEye(unsigned bits) const {
    const unsigned alongU = bitsOf(enteredAlongU_) & bits;
    return (alongU != 0 && near_ <= 0.0) || (alongU != bits && enteredV_ <= 0.0);
}

// Finds the columns with open rows that pass a tile of the slab, and how.
unsigned StripWalk::crossing(int v) {
    v_ = v;
    enteredV_ = v > eyeV_ ? v - eyeV_ - fractionV_ : fractionV_ + (eyeV_ - v - 1);
    if (isWhole_) {
        enteredAlongU_ = leftAlongU_ = inAllLanes(-1);
        return open_.live();
    }
    const Lanes tile = inAllLanes(v);
    const Lanes near = nearV_.lanes();
    const Lanes far = farV_.lanes();
    enteredAlongU_ = near == tile;
    leftAlongU_ = far == tile;
    return open_.live() & ~bitsOf((tile < lesser(near, far)) | (greater(near, far) < tile));
}

// Those of the columns that pass an object in the tile.
unsigned StripWalk::withObjects(unsigned bits) {
    unsigned found = 0;
    eachLane(bits, [&](int i) {
        SliceWalk& walk = lane(i);
        const double leave = crossingOf(i, Border::leave).along;
        if (!(leave > walk.nextObjectAlong())) return;
        // Rows may have been closed since
        comeTo(i, v_);
        if (leave > walk.objectsTo_) walk.findObjects(leave);
        walk.skipHiddenObjects();
        coverChanged_ = true;
        if (leave > walk.nextObjectAlong()) found |= 1u << i;
    });
    return found;
}

// Meets the contents of the current tile, column by column.
void StripWalk::meetAlone(unsigned bits) {
    coverChanged_ = true;
    const std::uint32_t plans = any().levelsWithPlans(tileX(v_), tileY(v_));
    eachLane(bits, [&](int i) {
        SliceWalk& walk = lane(i);
        comeTo(i, v_);
        walk.meetCurrent(plans);
        open_.read(i);
        floor_.at[i] = inLane(walk.floor_.texture);
        floorFromU_.at[i] = inLane(alongX_ ? walk.floor_.fromX : walk.floor_.fromY);
        floorFromV_.at[i] = inLane(alongX_ ? walk.floor_.fromY : walk.floor_.fromX);
        ceiling_.at[i] = inLane(walk.ceiling_.texture);
        ceilingFromU_.at[i] = inLane(alongX_ ? walk.ceiling_.fromX : walk.ceiling_.fromY);
        ceilingFromV_.at[i] = inLane(alongX_ ? walk.ceiling_.fromY : walk.ceiling_.fromX);
        ceilingRow_.at[i] = inLane(walk.ceiling_.row);
    });
}

// Brings a column's own walk to a tile of the slab, with its runs of floor and ceiling.
void StripWalk::comeTo(int i, int v) {
    SliceWalk& walk = lane(i);
    open_.write(i);
    if (u_ != eyeU_ || v != eyeV_)
        walk.walk_.comeTo(tileX(v), tileY(v), (u_ != eyeU_ && v == nearV_.at[i]) == alongX_);
    countTiles(i, v);
    const auto place = [&](int u, int w) { return alongX_ ? std::pair{u, w} : std::pair{w, u}; };
    walk.floor_.texture = static_cast<TextureId>(floor_.at[i]);
    std::tie(walk.floor_.fromX, walk.floor_.fromY) = place(floorFromU_.at[i], floorFromV_.at[i]);
    walk.ceiling_.texture = static_cast<TextureId>(ceiling_.at[i]);
    std::tie(walk.ceiling_.fromX, walk.ceiling_.fromY) =
        place(ceilingFromU_.at[i], ceilingFromV_.at[i]);
    walk.ceiling_.row = ceilingRow_.at[i];
}

// Counts a column's tiles, which follow from its position.
void StripWalk::countTiles(int i, int v) {
    SliceWalk& walk = lane(i);
    const int tiles = std::abs(u_ - eyeU_) + std::abs(v - eyeV_) + 1;
    report_.tilesWalked += tiles - walk.tiles_;
    walk.tiles_ = tiles;
}

// Updates the state after a tile; `live` were the columns with open rows before.
void StripWalk::noticeChange(unsigned live) {
    open_.findEnds();
    eachLane(live & ~open_.live(), [&](int i) {
        countTiles(i, v_);
        open_.write(i);
    });
    live = open_.live();
    if (!coverChanged_ || live == 0) return;
    coverChanged_ = false;
    const int one = __builtin_ctz(live);
    const auto only = [&](const LaneValues& textures) {
        const Lanes same = textures.lanes() == inAllLanes(textures.at[one]);
        return (bitsOf(same) & live) == live ? static_cast<TextureId>(textures.at[one]) : -1;
    };
    onlyFloor_ = only(floor_);
    onlyCeiling_ = only(ceiling_);
    nextObject_ = kNever;
    if (!any().vista_->objects.none())
        eachLane(live,
                 [&](int i) { nextObject_ = std::min(nextObject_, lane(i).nextObjectAlong()); });
}

}  // namespace slicecast

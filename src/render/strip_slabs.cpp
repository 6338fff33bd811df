// Finds which tiles of a slab the columns of a strip pass, and how many slabs they can skip.
#include "render/strip_walk.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace slicecast {
namespace {

// A point nearer than this to a border may be rounded to the wrong side of it; units.
constexpr double kNearBorder = 1e-7;

}  // namespace

// Finds the tiles in which the columns leave the slab. The inner columns are between the two outer
// ones.
void StripWalk::findFarTiles() {
    constexpr int kLast = kLanes - 1;
    const auto at = [&](int i) { return fractionV_ + far_ * slope_[indexOf(i)]; };
    const auto isClear = [](double v) { return std::fabs(v - std::floor(v + 0.5)) > kNearBorder; };
    const double first = at(0);
    const double last = at(kLast);
    if (isClear(first) && isClear(last) && std::floor(first) == std::floor(last)) {
        farV_ = LaneValues(inAllLanes(eyeV_ + static_cast<int>(std::floor(first))));
        isWhole_ = nearV_.at[0] == farV_.at[0] && nearV_.at[kLast] == farV_.at[0];
        return;
    }
    isWhole_ = false;
    for (int i = 0; i < kLanes; ++i) {
        const double v = at(i);
        farV_.at[i] =
            inLane(eyeV_ + (isClear(v) ? static_cast<int>(std::floor(v)) : farTile(i, v)));
    }
}

// The tile in which a column leaves the slab close to a border along v; the order of the crossings
// decides, as in GridWalk. `v` is at or near that border. It and the result are relative to the
// eye's tile.
int StripWalk::farTile(int lane, double v) const {
    const auto border = static_cast<int>(std::floor(v + 0.5));
    const int step = stepV_[indexOf(lane)];
    if (step == 0 || (step > 0 ? border < 1 : border > 0)) return 0;
    const double distance = step > 0 ? border - fractionV_ : fractionV_ - border;
    const double along = distance / speedV_[indexOf(lane)];
    const double alongU = far_ / speedU_[indexOf(lane)];
    const bool isFirstOfTwo = alongX_ ? stepU_ < 0 : step > 0;
    const bool isCrossed = along < alongU || (along == alongU && isFirstOfTwo);
    return step > 0 ? border - !isCrossed : border - isCrossed;
}

// Leaps over slabs in which no column meets anything; false if that would save nothing. The leap
// ends at the edge of the map, at the next object, or where the rays must stop. It also ends where
// one of the two outer columns leaves the open land around the middle.
bool StripWalk::passOpenLand() {
    if (map_->openLand.empty() || onlyFloor_ != map_->floor.texture || onlyCeiling_ != kNoTexture)
        return false;
    const unsigned live = open_.live();
    const int outer[] = {__builtin_ctz(live), 31 - __builtin_clz(live)};
    const int v = (nearV_.at[outer[0]] + nearV_.at[outer[1]]) / 2;
    const int open = map_->openLand[map_->tileIndex(tileX(v), tileY(v))];
    double slabs = stepU_ > 0 ? sizeU_ - 1 - u_ : u_;
    slabs = std::min({slabs, nextObject_ / alongPerUMost_ - far_,
                      any().whereToStop(open_.first(), open_.last()) / alongPerU_ - far_});
    for (const int i : outer) {
        const int toEdge = slope_[indexOf(i)] > 0.0 ? sizeV_ - 1 - nearV_.at[i] : nearV_.at[i];
        const int aside = std::min(open - 1 - std::abs(nearV_.at[i] - v), toEdge) - 1;
        slabs = std::min(slabs, aside / std::max(std::fabs(slope_[indexOf(i)]), 1.0));
    }
    if (slabs < 2.0) return false;
    const int passed = static_cast<int>(slabs);
    u_ += passed * stepU_;
    far_ += passed - 1;
    findFarTiles();
    near_ = far_;
    far_ += 1.0;
    nearV_ = farV_;
    return true;
}

}  // namespace slicecast

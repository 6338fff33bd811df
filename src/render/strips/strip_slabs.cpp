// Finds which tiles of a slab the columns of a strip pass, and how many slabs they can skip.
#include "render/strips/strip_walk.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace slicecast {
namespace {

// A point nearer than this to a border may be rounded to the wrong side of it; units.
constexpr double kNearBorder = 1e-7;

}  // namespace

// Finds the tiles in which the columns leave the slab; those before and behind the grid count as
// one. The inner columns are between the two outer ones.
void StripWalk::findFarTiles() {
    constexpr int kLast = kLanes - 1;
    const auto at = [&](int i) { return rays_.fractionV + tile_.far * rays_.slope[indexOf(i)]; };
    const auto isClear = [](double v) { return std::fabs(v - std::floor(v + 0.5)) > kNearBorder; };
    const auto inGrid = [&](double v) {
        return inLane(static_cast<int>(
            std::clamp<double>(rays_.eyeV + v, -1.0, static_cast<double>(rays_.sizeV))));
    };
    const double first = at(0);
    const double last = at(kLast);
    const bool isFirst = tile_.u == startU_;
    if (isClear(first) && isClear(last) && std::floor(first) == std::floor(last)) {
        farV_ = LaneValues(inAllLanes(inGrid(std::floor(first))));
        tile_.isWhole = !isFirst && nearV_.at[0] == farV_.at[0] && nearV_.at[kLast] == farV_.at[0];
        return;
    }
    tile_.isWhole = false;
    for (int i = 0; i < kLanes; ++i) {
        const double v = at(i);
        farV_.at[i] = inGrid(isClear(v) ? std::floor(v) : farTile(i, v));
    }
}

// The tile in which a column leaves the slab close to a border along v; the order of the crossings
// decides, as in GridWalk. `v` is at or near that border. It and the result are relative to the
// eye's tile.
int StripWalk::farTile(int lane, double v) const {
    const auto border = static_cast<int>(std::floor(v + 0.5));
    const int step = rays_.stepV[indexOf(lane)];
    // Behind a portal that turns, a part may begin beside the eye's own tile although the eye is on
    // the border
    const int begin = startV_ - rays_.eyeV;
    if (step == 0 || (step > 0 ? border <= begin : border > begin)) return begin;
    const double distance = step > 0 ? border - rays_.fractionV : rays_.fractionV - border;
    const double along = distance / rays_.speedV[indexOf(lane)];
    const double alongU = tile_.far / rays_.speedU[indexOf(lane)];
    const bool isFirstOfTwo = columns_[indexOf(lane)].walk.tieIsAlongX() != rays_.alongX;
    const bool isCrossed = along < alongU || (along == alongU && isFirstOfTwo);
    return step > 0 ? border - !isCrossed : border - isCrossed;
}

// Leaps over slabs in which no column meets anything; false if that would save nothing. The leap
// ends at the edge of the map, at the next object, or where the rays must stop. It also ends where
// one of the two outer columns leaves the open land around the middle.
bool StripWalk::passOpenLand() {
    const Map& map = *view_.map;
    if (map.openLand.empty() || tile_.cover.onlyFloor != map.floor.texture ||
        tile_.cover.onlyCeiling != kNoTexture || tile_.u < 0 || tile_.u >= rays_.sizeU)
        return false;
    const unsigned live = open_.live();
    const int outer[] = {__builtin_ctz(live), 31 - __builtin_clz(live)};
    const int v = (nearV_.at[outer[0]] + nearV_.at[outer[1]]) / 2;
    if (v < 0 || v >= rays_.sizeV) return false;
    const int open =
        map.openLand[rays_.alongX ? map.tileIndex(tile_.u, v) : map.tileIndex(v, tile_.u)];
    double slabs = rays_.stepU > 0 ? rays_.sizeU - 1 - tile_.u : tile_.u;
    slabs =
        std::min({slabs, nextObject_ / rays_.alongPerUMost - tile_.far,
                  view_.whereToStop(open_.first(), open_.last()) / rays_.alongPerU - tile_.far});
    for (const int i : outer) {
        const double slope = rays_.slope[indexOf(i)];
        const int toEdge = slope > 0.0 ? rays_.sizeV - 1 - nearV_.at[i] : nearV_.at[i];
        const int aside = std::min(open - 1 - std::abs(nearV_.at[i] - v), toEdge) - 1;
        slabs = std::min(slabs, aside / std::max(std::fabs(slope), 1.0));
    }
    if (slabs < 2.0) return false;
    const int passed = static_cast<int>(slabs);
    tile_.u += passed * rays_.stepU;
    tile_.far += passed - 1;
    findFarTiles();
    tile_.near = tile_.far;
    tile_.far += 1.0;
    nearV_ = farV_;
    return true;
}

}  // namespace slicecast

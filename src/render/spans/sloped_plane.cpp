#include "render/spans/sloped_plane.h"

#include <algorithm>
#include <cmath>

namespace slicecast {

SlopedPlane::SlopedPlane(const Slopes& slopes, const Slant& slant, int x, int y, std::int32_t base,
                         const Viewpoint& eye, GroundDirection ray, const Projection& projection)
    : rise(Coordinate{slant.rise()}.value()), alongX(slopes.alongX) {
    // #region own-horizon
    const std::int64_t from = alongX ? eye.x - tileEdge(x).raw : eye.y - tileEdge(y).raw;
    const std::int64_t above = slant.heightAt(from) + std::int64_t{base} * 65536;
    height = static_cast<double>(above) / 4294967296.0;
    horizon = projection.horizon - rise * (alongX ? ray.x : ray.y);
    // #endregion
    climb = rise * (alongX ? ray.x : ray.y);
    // East and south in the eye's own map lead there, after the turns of portals
    isMajor = (eye.turn % 2 == 0) == alongX;
    const bool isAgainst = alongX ? eye.turn == 1 || eye.turn == 2 : eye.turn >= 2;
    isLifted = (rise > 0.0) != isAgainst;
}

int firstRowBelowHeight(const Projection& projection, double height, const Crossing& border) {
    if (height == 0.0) return projection.firstFallingRow;
    if (border.distance <= 0.0) return height > 0.0 ? 0 : projection.height;
    return projection.firstRowBelowRow(projection.horizon - height * border.speed / border.distance,
                                       (height > 0.0) == border.early);
}

// The plane is at that height along a level line, which one row's ray meets.
void keepRowsAt(const Projection& projection, const SlopedPlane& plane, double height,
                bool keepsBelow, bool isDownwards, int& first, int& last) {
    const double over = height - plane.height;
    if (plane.climb == 0.0 || over == 0.0 || (over > 0.0) != (plane.climb > 0.0)) {
        // The line is not ahead: the whole plane there is on one side
        const bool isBelow = plane.climb != 0.0 ? plane.climb < 0.0 : over > 0.0;
        if (isBelow != keepsBelow) last = first;
        return;
    }
    const int row =
        projection.firstRowBelowRow(projection.horizon - height * (plane.climb / over), false);
    const bool keepsNear = (plane.climb > 0.0) == keepsBelow;
    if (keepsNear == isDownwards) {
        first = std::max(first, row);
    } else {
        last = std::min(last, row);
    }
}

// Across its rise, the plane's edges are level. Elsewhere ties are decided by the eye's greatest
// step: it lifts or lowers a plane that rises along it, and otherwise moves the border.
int firstRowBelow(const Projection& projection, const SlopedPlane& plane, const Crossing& at) {
    const bool isCut = at.cut != Cut::none;
    if (at.hasSides() && !isCut && at.alongX == plane.alongX) {
        const double ahead = at.nearing ? at.distance : -at.distance;
        return firstRowBelowHeight(projection, plane.height + plane.rise * ahead, at);
    }
    if (plane.height == 0.0) return projection.firstRowBelowRow(plane.horizon, plane.isLifted);
    const bool isAbove = plane.height > 0.0;
    if (at.distance <= 0.0) return isAbove ? 0 : projection.height;
    const auto tieAtCut = [&] {
        const double lift = plane.isMajor ? std::fabs(plane.rise) : 0.0;
        const double sooner = plane.height / at.distance;
        return (plane.isLifted ? lift : -lift) + (at.early ? sooner : -sooner) > 0.0;
    };
    const bool tieIsBelow = isCut                            ? tieAtCut()
                            : at.hasSides() && plane.isMajor ? plane.isLifted
                                                             : isAbove == at.early;
    const int row = projection.firstRowBelowRow(
        plane.horizon - plane.height * at.speed / at.distance, tieIsBelow);
    // Rays along the plane never cross it
    const int along = projection.firstRowBelowRow(plane.horizon, isAbove);
    return isAbove ? std::min(row, along) : std::max(row, along);
}

}  // namespace slicecast

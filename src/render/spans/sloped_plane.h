// A sloped top or underside as the rays of one column see it.
//
//                     . .-'             Over the ray's ground line the plane rises by g r for each
//       horizon   . .-'                 multiple of the ray's direction r. Seen from the eye that is
//       -------.o-'----------           a level plane under a horizon of its own, moved by g r rows:
//           .-'  eye
//        .-'   ) height < 0                 row = (horizon - g r) - height * speed / distance
//
// So a sloped face is met in the rows between those of its two ends, as a level one is, but on
// either side of the true horizon.
#pragma once

#include "render/spans/grid_walk.h"
#include "render/view/projection.h"
#include "render/view/viewpoint.h"
#include "world/slope.h"

#include <cstdint>

namespace slicecast {

struct SlopedPlane {
    double height = 0.0;   // of the extended plane above the eye, units; exact
    double horizon = 0.0;  // its own: the row of rays that run along it
    double rise = 0.0;     // per unit along its axis, exact
    double climb = 0.0;    // for each multiple of the ray's direction, rows
    bool alongX = true;    // its axis
    bool isMajor = true;   // the eye's greater step, east in its own map, is along that axis
    bool isLifted = true;  // that step, or the smaller one, lifts the plane over the eye

    SlopedPlane() = default;
    // Of the slant of a block in tile (x, y), whose level's base is `base` 1/65536 units above the
    // eye. `ray` is the column's; all in the coordinates of the vista's map.
    SlopedPlane(const Slopes& slopes, const Slant& slant, int x, int y, std::int32_t base,
                const Viewpoint& eye, GroundDirection ray, const Projection& projection);
};

// The first row whose ray passes below a height above the eye, in units, at a border.
int firstRowBelowHeight(const Projection& projection, double height, const Crossing& border);

// Of the rows [first, last), whose rays pass the plane downwards or upwards, leaves those that pass
// it where it lies below a height above the eye, in units, or not below it.
void keepRowsAt(const Projection& projection, const SlopedPlane& plane, double height,
                bool keepsBelow, bool isDownwards, int& first, int& last);

// The first row whose ray passes below the plane where it crosses a border, an edge or an object's
// depth, or at the eye.
int firstRowBelow(const Projection& projection, const SlopedPlane& plane, const Crossing& at);

}  // namespace slicecast

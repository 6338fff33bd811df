// The objects of a frame: which of a map's objects may be seen, at which depth, and in which
// columns; worked out once for all slices.
#pragma once

#include "render/detail.h"
#include "render/projection.h"
#include "render/shading.h"
#include "render/viewpoint.h"
#include "world/world.h"

#include <cstdint>
#include <vector>

namespace slicecast {

struct FrameObject {
    double depth = 0.0;  // t, units, a multiple of 1/65536, > 0
    double along =
        0.0;  // the same as a Crossing counts it: the one number that is compared with borders
    double left = 0.0;        // of its left edge, units to the right of the eye
    double width = 0.0;       // units
    std::int32_t bottom = 0;  // 1/65536 units above the eye
    std::int32_t top = 0;
    int firstRow = 0;  // where it appears: the rows [firstRow, lastRow)
    int lastRow = 0;
    const SpriteLevel* level = nullptr;
    int detail = 0;  // which level of the sprite it is
    std::uint32_t factor = 256;
    std::uint32_t fog = 0;
    int index = 0;  // in the map
};

class FrameObjects {
public:
    // Those of the viewpoint's map, in that map's light.
    void beginFrame(const World& world, const Viewpoint& from, const Projection& projection,
                    const Detail& detail, const Lighting& lighting);

    // The objects that may cover a column, nearest first; those of one depth in the map's order.
    const std::vector<int>& inColumn(int column) const {
        return groups_[static_cast<std::size_t>(column / kGroup)];
    }
    const FrameObject& operator[](int i) const { return objects_[static_cast<std::size_t>(i)]; }

    bool none() const { return objects_.empty(); }
    double highest() const {
        return highest_;
    }  // of their upper edges above the map's floor, units; 0 if there are none

    // The first row below a height, `rise` 1/65536 units above the eye, at a depth; a row right
    // through it counts as below if `tieIsBelow`.
    static int firstRowBelow(const Projection& projection, std::int32_t rise, double depth,
                             bool tieIsBelow = false) {
        return projection.firstRowBelowRow(
            projection.horizon - rise / 65536.0 * projection.distance / depth, tieIsBelow);
    }

private:
    static constexpr int kGroup = 16;  // columns that share a list

    // One that is in the field of view.
    struct Seen {
        double depth;
        double left;
        int index;
    };

    void findSeen(const Map& map, const Viewpoint& from, const Projection& projection);
    void putIntoGroups(const Projection& projection);

    std::vector<Seen> seen_;
    std::vector<Seen> room_;  // while they are sorted
    std::vector<FrameObject> objects_;
    std::vector<std::vector<int>> groups_;
    double highest_ = 0.0;
};

}  // namespace slicecast

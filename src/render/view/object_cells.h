// A map's objects by place, so that a view need not look at all of them.
//
// The ground is divided into square cells; each cell lists the objects whose centres are in it.
#pragma once

#include "render/view/projection.h"
#include "world/map.h"

#include <cstdint>
#include <span>
#include <vector>

namespace slicecast {

// A wedge of ground in front of a point, between two depths and two limits to the side.
struct GroundWedge {
    std::int64_t x = 0;  // of the point, 1/65536 units
    std::int64_t y = 0;
    GroundDirection forward;  // unit vectors
    GroundDirection right;
    double left = 0.0;  // limits to the right of the point, per unit of depth
    double end = 0.0;
    double nearest = 0.0;  // units
    double farthest = 0.0;
};

class ObjectCells {
public:
    // Reuses its memory. The map must outlive this.
    void fill(const Map& map);

    const Map& map() const { return *map_; }
    double highest() const {
        return highest_;
    }  // greatest height of upper edges, units; 0 without objects

    // Appends the indices of the objects that may reach into a wedge, possibly some more, in no
    // particular order.
    void find(const GroundWedge& wedge, std::vector<int>& found) const;

private:
    static constexpr int kMost = 64;  // cells along x, and along y

    int columnOf(const Object& object) const {
        return static_cast<int>((object.x.raw - west_) >> shift_);
    }
    int rowOf(const Object& object) const {
        return static_cast<int>((object.y.raw - north_) >> shift_);
    }

    const Map* map_ = nullptr;
    std::int64_t west_ = 0;  // 1/65536 units
    std::int64_t north_ = 0;
    int shift_ = 0;  // a cell is 1 << shift_ wide, 1/65536 units
    int columns_ = 0;
    int rows_ = 0;
    double halfWidest_ = 0.0;  // half of the widest object, units
    double highest_ = 0.0;
    std::vector<int> starts_;  // start of each cell in order_, row by row; then the end
    std::vector<int> order_;   // the objects, cell by cell
};

}  // namespace slicecast

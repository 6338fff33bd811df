// A map's objects by where they are, so that who looks one way need not look at all of them.
//
// The objects' ground is cut into square cells; each cell lists the objects whose middles are in
// it.
#pragma once

#include "render/projection.h"
#include "world/map.h"

#include <cstdint>
#include <span>
#include <vector>

namespace slicecast {

// A wedge of ground: what is ahead of a point and at most so far aside, for each unit of depth.
struct GroundWedge {
    std::int64_t x = 0;  // of the point, 1/65536 units
    std::int64_t y = 0;
    GroundDirection forward;  // unit vectors
    GroundDirection right;
    double left = 0.0;  // where it begins and ends to the right of the point, per unit of depth
    double end = 0.0;
};

class ObjectCells {
public:
    // Keeps its memory. The map must outlive this.
    void fill(const Map& map);

    const Map& map() const { return *map_; }
    double highest() const { return highest_; }  // of the upper edges, units; 0 without objects

    // Appends the objects, as indices into the map's, that may reach into a wedge, and maybe some
    // more; in no order that means anything.
    void find(const GroundWedge& wedge, std::vector<int>& found) const;

private:
    static constexpr int kMost = 32;  // cells along x, and along y

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
    std::vector<int> starts_;  // of each cell, row by row, in order_; then the end
    std::vector<int> order_;   // the objects, cell by cell
};

}  // namespace slicecast

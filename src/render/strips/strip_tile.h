// A tile as some columns of a strip see it that pass it together, or a stretch of it: edges of
// blocks and objects within a tile divide it. What is in it is met by the functions of
// strip_meet.h.
#pragma once

#include "render/column/slice_column.h"
#include "render/strips/open_lanes.h"
#include "render/strips/strip_rays.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace slicecast {

// What is at an end of a stretch. Blocks have sides at borders and edges.
enum class End : std::uint8_t { nothing, border, edge, object };

// A stretch of a tile, the same for all columns that are there together. The plain one is the whole
// tile.
struct Stretch {
    End enters = End::border;
    End leaves = End::border;
    bool entersAhead = true;  // not at depth 0
    bool leavesAhead = true;
    bool isAtEye = false;  // the tile is entered at depth 0
    // Levels whose blocks are not in the stretch, began before it, end after it, began at an edge
    // within the tile
    std::uint32_t absent = 0;
    std::uint32_t within = 0;
    std::uint32_t staying = 0;
    std::uint32_t late = 0;

    friend bool operator==(const Stretch&, const Stretch&) = default;
};

// Columns that cross a border in one way.
struct CrossingLanes {
    Lanes lanes;
    bool alongX;
    bool nearing;

    Crossing crossing() const { return {.alongX = alongX, .nearing = nearing}; }
};

// The runs of floor and ceiling under and above the columns. A run begins at a tile and ends where
// the texture changes.
struct StripCover {
    LaneValues floor;  // texture
    LaneValues floorFromU;
    LaneValues floorFromV;
    LaneValues ceiling;  // texture
    LaneValues ceilingRow;
    LaneValues ceilingFromU;
    LaneValues ceilingFromV;
    bool changed = false;  // since the two following were found
    int onlyFloor = 0;     // texture of all columns, or -1
    int onlyCeiling = 0;
};

class StripTile {
public:
    using SideViews = std::array<SideView, kLanes>;
    using Columns = std::array<SliceColumn, kLanes>;
    using Ends = std::vector<Crossing>;  // by lane

    // All must outlive the tile.
    StripTile(const PartView& part, const StripRays& stripRays, Columns& stripColumns,
              OpenLanes& openLanes, Ends& entered, Ends& left, FrameReport& frameReport)
        : view(part),
          rays(stripRays),
          columns(stripColumns),
          open(openLanes),
          enters(entered),
          leaves(left),
          report(frameReport) {}

    SliceColumn& column(int lane) { return columns[indexOf(lane)]; }
    int tileX() const { return rays.alongX ? u : v; }
    int tileY() const { return rays.alongX ? v : u; }
    TileRange here() const { return {tileX(), tileY(), tileX(), tileY(), false}; }
    bool isArrival() const { return view.isArrival(tileX(), tileY()); }
    // The tile on the other side of a border; of an edge or an object within the tile, this one.
    std::pair<int, int> beyond(const CrossingLanes& crossing, Border border) const;

    // Columns enter the tile, all or some.
    void enter(unsigned bits);
    // Brings a column's own walk to the tile.
    void place(int lane);
    // The same for a stretch: `enters` and `leaves` hold how they cross its ends.
    void enterStretch(unsigned bits, const Stretch& part);

    bool isAtEye(int level) const { return stretch.isAtEye && (stretch.late >> level & 1) == 0; }
    bool entersAt(int level) const {
        return stretch.enters == End::border ||
               (stretch.enters == End::edge && (stretch.within >> level & 1) == 0);
    }
    bool leavesAt(int level) const {
        return stretch.leaves == End::border ||
               (stretch.leaves == End::edge && (stretch.staying >> level & 1) == 0);
    }
    bool isAbsent(int level) const {
        return stretch.absent != 0 && (stretch.absent >> (level & 31) & 1) != 0;
    }
    End at(Border border) const {
        return border == Border::enter ? stretch.enters : stretch.leaves;
    }

    // The first rows whose rays pass below a height, `rise` 1/65536 units above the eye, at a
    // border: see firstRowBelow.
    __attribute__((noinline)) Lanes rowsBelow(std::int32_t rise, Border at) const;
    Crossing crossingOf(int lane, Border at) const;
    // How the columns cross a border, at most four ways.
    std::span<const CrossingLanes> crossings(Border at);
    __attribute__((noinline)) const SideViews& viewsAt(Border at);
    // The columns that may have open rows within [first, last).
    Lanes seen(Lanes first, Lanes last) const {
        return mask & (first < last) & open.reachBelow(first) & open.reachAbove(last);
    }

    const PartView& view;
    const StripRays& rays;
    Columns& columns;
    OpenLanes& open;
    Ends& enters;  // see enterStretch()
    Ends& leaves;
    FrameReport& report;

    // Of the slab
    int u = 0;
    double near = 0.0;  // distances of its borders from the eye, units
    double far = 0.0;

    // Of the tile
    int v = 0;
    bool entersUpward = false;  // columns that enter along v come from a lesser v
    double enteredV = 0.0;      // distance of the border through which they do, units
    bool isWhole = false;       // all columns enter and leave along u
    Lanes enteredAlongU;        // which columns enter along u
    Lanes leftAlongU;           // and which leave along u
    Lanes mask;                 // columns that pass it
    Stretch stretch;
    bool isDivided = false;  // `enters` and `leaves` are valid
    bool isFirst = false;    // the eye's own tile: not entered through a border
    StripCover cover;

private:
    void findRowsPerRaw();
    __attribute__((noinline)) Lanes exactRows(Lanes rows, unsigned bits, std::int32_t rise,
                                              Border at) const;

    LaneDoubles entered_;  // rows per 1/65536 unit of height at the borders
    LaneDoubles left_;
    SideViews enteredViews_;  // of the sides there, valid if known
    SideViews leftViews_;
    bool enteredViewsKnown_ = false;
    bool leftViewsKnown_ = false;
    std::array<CrossingLanes, 4> crossings_;
};

}  // namespace slicecast

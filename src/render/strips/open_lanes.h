// The open rows of all columns of a strip at once: for each column the first, one past the last,
// and one gap between them. A column with more gaps keeps its rows in a list while it has them.
#pragma once

#include "render/pixels/lanes.h"
#include "render/spans/open_rows.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace slicecast {

// A run of open rows in a lane.
struct LaneRows {
    int lane;
    int first;
    int last;
};

class OpenLanes {
public:
    // Memory to reuse.
    struct Scratch {
        std::array<OpenRows, kLanes> rows;  // the columns' lists
        std::vector<LaneRows> taken = std::vector<LaneRows>(2 * kLanes);
    };

    // The memory must outlive this.
    explicit OpenLanes(Scratch& scratch) : rows_(scratch.rows), taken_(scratch.taken) {}

    // Reads the lists of the lanes in `bits`; all others have no open rows.
    void begin(unsigned bits);

    unsigned live() const { return live_; }    // lanes with open rows
    int first() const { return leastFirst_; }  // of all lanes
    int last() const { return greatestLast_; }
    int firstOf(int lane) const { return first_.at[lane]; }
    int lastOf(int lane) const { return last_.at[lane]; }
    // Lanes in which rows at or below `row`, or above it, may be open.
    Lanes reachBelow(Lanes row) const { return row < last_.lanes(); }
    Lanes reachAbove(Lanes row) const { return first_.lanes() < row; }

    // Closes the rows [first, last) of the lanes in `mask`. Returns the runs of them that were
    // open, valid until the next call. Call findEnds() afterwards.
    std::span<const LaneRows> take(Lanes mask, Lanes first, Lanes last);
    void close(unsigned bits);  // all rows of some lanes
    void findEnds();

    // Writes a lane's open rows into its list, for a walk of its own, and reads them back.
    void write(int lane);
    void read(int lane);

private:
    static constexpr int kNoGap = 32767;  // below all rows

    std::size_t takeListed(unsigned bits, Lanes from, Lanes to);
    void close(Lanes here, Lanes from, Lanes to);
    void makeLists(unsigned bits, Lanes from, Lanes to);

    std::array<OpenRows, kLanes>& rows_;
    LaneValues first_;
    LaneValues last_;
    LaneValues gapFirst_;
    LaneValues gapLast_;
    std::vector<LaneRows>& taken_;
    unsigned listed_ = 0;  // lanes whose rows are in their list
    unsigned live_ = 0;
    int leastFirst_ = 0;
    int greatestLast_ = 0;
};

}  // namespace slicecast

// The parts that a slice falls into where rays go through portals and off mirrors. A part is some
// rows of the slice and the walk on which they go on; parts wait in a queue, and lists keep their
// memory from slice to slice.
#pragma once

#include "render/grid_walk.h"
#include "render/open_rows.h"
#include "render/vista.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace slicecast {

// Heights between which a part's rays run, 1/65536 units above its vista's viewpoint. What comes
// through a portal in a roof, or off a mirror, has begun at a height; nothing on the other side of
// it is met.
struct HeightClip {
    std::int32_t low = std::numeric_limits<std::int32_t>::min();
    std::int32_t high = std::numeric_limits<std::int32_t>::max();
    bool isMirror = false;  // then nothing at the height itself is met either

    bool any() const {
        return low != std::numeric_limits<std::int32_t>::min() ||
               high != std::numeric_limits<std::int32_t>::max();
    }
    friend bool operator==(const HeightClip&, const HeightClip&) = default;
};

// Where rays were before they came through a portal: the tile before the portal, or its own if they
// came through a roof or an underside.
struct Before {
    const Map* map = nullptr;
    int x = 0;
    int y = 0;
    int levels = 0;  // the portal's

    friend bool operator==(const Before&, const Before&) = default;
};

struct Part {
    Vista* vista = nullptr;
    GridWalk walk{{}, {}, {}};  // in the tile in which the part begins
    HeightClip clip;
    Before before;
    int portals = 0;  // passed so far
    std::vector<OpenRows::Run> rows;
    int tiles = 0;              // that the walk has come through, the first among them
    bool endsInPortal = false;  // the last of them is a portal, and nothing else was met in it
};

class Parts {
public:
    void clear() { used_ = 0; }
    std::size_t count() const { return used_; }
    Part& operator[](std::size_t i) { return parts_[i]; }
    const Part& operator[](std::size_t i) const { return parts_[i]; }

    // Rows that go the same way share a part, if that has not begun: `begun` of them have.
    Part& find(Vista& vista, const GridWalk& walk, const HeightClip& clip, const Before& before,
               int portals, std::size_t begun) {
        for (std::size_t i = used_; i-- > begun;) {
            Part& part = parts_[i];
            if (part.vista == &vista && part.clip == clip && part.before == before &&
                part.portals == portals && part.walk.tileX == walk.tileX &&
                part.walk.tileY == walk.tileY && part.walk.entered == walk.entered) {
                return part;
            }
        }
        if (used_ == parts_.size()) parts_.emplace_back();
        Part& part = parts_[used_++];
        part.vista = &vista;
        part.walk = walk;
        part.clip = clip;
        part.before = before;
        part.portals = portals;
        part.rows.clear();
        part.tiles = 0;
        part.endsInPortal = false;
        return part;
    }

    // Rows are kept in order.
    static void addRows(Part& part, int first, int last) {
        auto place = part.rows.end();
        while (place != part.rows.begin() && (place - 1)->first > first) --place;
        part.rows.insert(place, {first, last});
    }

private:
    std::vector<Part> parts_;
    std::size_t used_ = 0;
};

}  // namespace slicecast

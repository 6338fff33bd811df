// The parts of a slice, one for each way that its rays take through portals and off mirrors. A part
// is some rows of the slice and the walk on which they continue. Parts wait in a queue; lists keep
// their memory from slice to slice.
#pragma once

#include "render/spans/grid_walk.h"
#include "render/spans/open_rows.h"
#include "render/view/vista.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace slicecast {

// The heights between which a part's rays run, 1/65536 units above its vista's viewpoint. Rays
// through a portal in a roof, or off a mirror, start at a height and meet nothing on its other
// side.
struct HeightClip {
    std::int32_t low = std::numeric_limits<std::int32_t>::min();
    std::int32_t high = std::numeric_limits<std::int32_t>::max();
    bool isMirror = false;  // then planes at the height itself are not met either

    bool any() const {
        return low != std::numeric_limits<std::int32_t>::min() ||
               high != std::numeric_limits<std::int32_t>::max();
    }
    friend bool operator==(const HeightClip&, const HeightClip&) = default;
};

// Where rays were before they went through a portal: the tile before the portal, or the portal's
// own tile if they came through a roof or an underside.
struct Before {
    const Map* map = nullptr;
    int x = 0;
    int y = 0;
    int levels = 0;  // of the portal

    friend bool operator==(const Before&, const Before&) = default;
};

struct Part {
    Vista* vista = nullptr;
    GridWalk walk{{}, {}, {}};  // in the part's first tile
    HeightClip clip;
    Before before;
    int portals = 0;  // passed before this part
    std::vector<OpenRows::Run> rows;
    int tiles = 0;              // tiles of the walk, including the first
    bool endsInPortal = false;  // the last tile is a portal, and nothing else was met in it
};

class Parts {
public:
    void clear() { used_ = 0; }
    std::size_t count() const { return used_; }
    Part& operator[](std::size_t i) { return parts_[i]; }
    const Part& operator[](std::size_t i) const { return parts_[i]; }

    // Finds or makes a part. Rows that continue alike share one, unless it has begun: the first
    // `begun` parts have.
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

    // Keeps rows sorted, and rows that touch in one run: a lake is a mirror in each of its tiles.
    static void addRows(Part& part, int first, int last) {
        auto place = part.rows.end();
        while (place != part.rows.begin() && (place - 1)->first > first) --place;
        if (place != part.rows.end() && place->first == last) {
            place->first = first;
        } else {
            place = part.rows.insert(place, {first, last});
        }
        if (place != part.rows.begin() && (place - 1)->last == first) {
            (place - 1)->last = place->last;
            part.rows.erase(place);
        }
    }

private:
    std::vector<Part> parts_;
    std::size_t used_ = 0;
};

}  // namespace slicecast

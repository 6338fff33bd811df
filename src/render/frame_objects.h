// The objects of a frame: which of a map's objects may be visible, at which depth and in which
// columns. A group of columns looks for its objects when a slice first asks, because behind a
// portal only a few columns do. When many ask, all groups are searched at once.
#pragma once

#include "render/detail.h"
#include "render/object_cells.h"
#include "render/projection.h"
#include "render/shading.h"
#include "render/viewpoint.h"
#include "world/world.h"

#include <cstdint>
#include <vector>

namespace slicecast {

struct FrameObject {
    double depth = 0.0;       // t, units, a multiple of 1/65536, > 0
    double along = 0.0;       // the same as in Crossing, to be compared with borders
    double left = 0.0;        // of its left edge, units right of the eye
    double width = 0.0;       // units
    std::int32_t bottom = 0;  // 1/65536 units above the eye
    std::int32_t top = 0;
    int firstRow = 0;  // it covers the rows [firstRow, lastRow)
    int lastRow = 0;
    const SpriteLevel* level = nullptr;
    int detail = 0;  // index of that level
    std::uint32_t factor = 256;
    std::uint32_t fog = 0;
    int index = 0;  // index into the map's objects
};

// Memory for the objects of all views of a frame: behind portals there may be hundreds of views.
struct FrameObjectRoom {
    // An object that may cover some of the columns.
    struct Seen {
        double depth;
        double left;
        int index;
    };

    std::vector<FrameObject> objects;
    std::vector<int> near;  // used during one search only, as are the next two
    std::vector<Seen> seen;
    std::vector<Seen> sorting;
};

class FrameObjects {
public:
    // Takes the objects of the viewpoint's map, whose cells are given, in that map's light. All but
    // `from` must outlive the frame.
    void beginFrame(const World& world, const ObjectCells& cells, const Viewpoint& from,
                    const Projection& projection, const Detail& detail, const Lighting& lighting,
                    FrameObjectRoom& room);

    // The objects that may cover a column, nearest first; at equal depth in the map's order.
    const std::vector<int>& inColumn(int column) {
        const int group = column / kGroup;
        if (!isKnown(group)) ask(group);
        return groups_[static_cast<std::size_t>(group)];
    }
    // Finds those of all columns at once: faster if most of them will ask.
    void findAll();
    // Valid until a group of any view is searched.
    const FrameObject& operator[](int i) const {
        return room_->objects[static_cast<std::size_t>(i)];
    }

    bool none() const { return map_->objects.empty(); }

    // The first row below a height, `rise` 1/65536 units above the eye, at a depth. `tieIsBelow`: a
    // row exactly through the height counts as below.
    static int firstRowBelow(const Projection& projection, std::int32_t rise, double depth,
                             bool tieIsBelow = false) {
        return projection.firstRowBelowRow(
            projection.horizon - rise / 65536.0 * projection.distance / depth, tieIsBelow);
    }

private:
    static constexpr int kGroup = 16;  // columns that share a list

    // Not inlined: a copy at each call would only enlarge the page's program.
    __attribute__((noinline)) void ask(int group);
    __attribute__((noinline)) void find(int first, int last);
    bool isKnown(int group) const { return known_[static_cast<std::size_t>(group)] != 0; }
    void findSeen(int first, int end);
    void add(const FrameObjectRoom::Seen& seen, int firstGroup, int lastGroup);

    const World* world_ = nullptr;
    const Map* map_ = nullptr;
    const ObjectCells* cells_ = nullptr;
    const Projection* projection_ = nullptr;
    const Lighting* lighting_ = nullptr;
    Viewpoint from_;
    Detail detail_;
    GroundDirection forward_;
    GroundDirection right_;
    FrameObjectRoom* room_ = nullptr;
    std::vector<std::vector<int>> groups_;  // indices into the room's objects
    std::vector<std::uint8_t> known_;       // 1 for each group whose list is known
    int asked_ = 0;                         // groups that have asked, one after another
};

}  // namespace slicecast

// The objects of a frame: which of a map's objects may be visible, at which depth and in which
// columns. They are looked for when a slice asks, only in its column, and only so far as it walks,
// because behind portals there may be thousands of views, each of few columns. When many columns
// of a view have asked, groups of them are searched together.
#pragma once

#include "base/keyed_pool.h"
#include "render/view/detail.h"
#include "render/view/object_cells.h"
#include "render/view/projection.h"
#include "render/view/shading.h"
#include "render/view/viewpoint.h"
#include "world/world.h"

#include <cstdint>
#include <span>
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

// Objects that may cover some columns.
struct ColumnObjects {
    std::vector<int> objects;  // nearest first; at equal depth in the map's order
    double from = 0.0;         // those at depths of [from, to) have been found, units
    double to = 0.0;
};

class FrameObjects;

// Memory for the objects of all views of a frame: behind portals there may be thousands of views.
struct FrameObjectRoom {
    // A column of a view that few columns see.
    struct Place {
        const FrameObjects* view;
        int column;

        friend bool operator==(const Place&, const Place&) = default;
    };
    // An object that may cover some of the columns.
    struct Seen {
        double depth;
        double left;
        int index;
    };

    void forgetAll() {
        objects.clear();
        lists.forgetAll();
    }

    std::vector<FrameObject> objects;
    KeyedPool<Place, ColumnObjects> lists;
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

    // The objects that may cover a column, with all at depths of [from, to); `to` may be infinite.
    // Stays where it is during the frame. Later calls add farther objects; one from nearer begins
    // the list anew.
    const ColumnObjects& inColumn(int column, double from, double to);
    // Searches for groups of columns from now on: faster if most columns will ask.
    void askTogether();
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
    ColumnObjects* listOf(int column);
    void find(std::span<ColumnObjects> lists, int first, int columns, double from, double to);
    void findSeen(int first, int end, double from, double to);
    bool look(const FrameObjectRoom::Seen& seen, FrameObject& shown) const;

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
    int asked_ = 0;          // searches for one column
    bool together_ = false;  // then groups of columns have lists
    std::vector<ColumnObjects> groups_;
};

}  // namespace slicecast

// One column of the picture: what its rows show, and by which way round. A column has parts: what
// is seen of the eye's map, and of what lies behind a portal or shows in a mirror.
#pragma once

#include "render/classic/colouring.h"
#include "render/classic/surfaces.h"

#include <memory>
#include <optional>
#include <vector>

namespace slicecast::classic {

// A map as the column sees it.
struct Part {
    int map = 0;
    int portals = 0;  // that the ray had passed before
    View view;
    ColumnRay ray;
    std::optional<Colouring> colouring;
    TileStart start;
    std::vector<TileSpan> spans;
    std::vector<BlockMet> blocks;
    std::vector<Surface> surfaces;
    std::vector<int> overdrawn;  // by row, the surface that is a portal drawn over what is before
                                 // it; -1 for none

    // Where the rays of a row begin: at the eye, behind a portal, at a mirror.
    const Part* before = nullptr;
    const Surface* door = nullptr;  // of `before`; null where it is a mirror
    double mirrorHeight = 0.0;
    double beginsAt(double y) const {
        if (before == nullptr) return -1.0;
        return door != nullptr ? door->depthAt(before->view, before->ray, y)
                               : before->view.depthOfPlane(mirrorHeight, y);
    }
    bool isMirrored() const { return view.up < 0.0; }
};

// What a row shows, one thing before the other.
struct Mark {
    const Part* part = nullptr;
    const Surface* surface = nullptr;  // null for the floor, the sky and what is seen beyond `far`
    Shown shown;
};

class Column {
public:
    // What is given here must outlive it.
    Column(const World& world, const Eye& eye, const RenderOptions& options,
           const ClassicOptions& classic, int width, int height);

    // The colours of the rows, where x is the middle of the column.
    const std::vector<Pixel>& draw(double x);

    // What was drawn.
    const RowGrid& rows() const { return rows_; }
    const std::vector<Mark>& marks(int row) const { return marks_[static_cast<std::size_t>(row)]; }
    const std::vector<std::unique_ptr<Part>>& parts() const { return parts_; }
    std::size_t partsUsed() const { return used_; }
    // What all the columns took.
    const FrameReport& report() const { return report_; }

private:
    // Where a ray meets a surface; nothing is before the first one. At equal depth the order is
    // that of Passing, then that of the gathering.
    struct Place {
        const Surface* surface = nullptr;
        double depth = -1.0;

        bool isBefore(const Place& other) const;
    };

    Part& nextPart();
    void gather(Part& part);
    Part& beyond(const Part& from, const Surface& door);
    Part& mirrored(const Part& from, double height);

    // The next place of a row's ray; with `over`, objects and that surface are all that there is.
    Place nextBehind(const Part& part, const Place& last, int row, const Surface* over) const;
    void findOverdrawn(Part& part);
    bool isMasked(const Part& part, const Surface& portal, int row) const;

    // Each tells where the ray goes on: in the same part, in another one, or, null, nowhere.
    Part* meet(Part& part, const Surface& surface, int row);
    Part* meetBackground(Part& part, int row);
    void follow(Part* part, int row);

    void paintNearest(Part& part);
    void paintFarToNear(Part& part);
    void colourRows();
    void count();

    const World& world_;
    const RenderOptions& options_;
    const ClassicOptions& classic_;
    const int map_;
    RowGrid rows_;
    View view_;  // of the eye
    FrameReport report_;
    std::vector<std::unique_ptr<Part>> parts_;  // kept from column to column
    std::size_t used_ = 0;
    std::vector<std::vector<Mark>> marks_;  // by row
    std::vector<Pixel> colours_;
};

}  // namespace slicecast::classic

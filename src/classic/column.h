// One column of the picture: what its rows show. A column has parts: the eye's map, and maps behind
// portals or in mirrors.
#pragma once

#include "classic/colouring.h"
#include "classic/surfaces.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace slicecast::classic {

// A map as the column sees it: the eye's, one behind a portal, or one in a mirror.
struct Part {
    int map = 0;
    int portals = 0;  // passed by the ray before it
    View view;
    ColumnRay ray;
    std::optional<Colouring> colouring;
    TileStart start;
    std::vector<TileSpan> spans;
    std::vector<BlockMet> blocks;
    std::vector<Surface> surfaces;
    std::size_t objects = 0;     // of the surfaces, the first ones
    std::vector<int> overdrawn;  // by row: index in `surfaces` of a portal that is drawn over
                                 // what stands before it, or -1; empty if no row has one

    // Where rays come from.
    const Part* before = nullptr;   // null for the eye's own part
    const Surface* door = nullptr;  // the portal, one of the surfaces of `before`; null in a mirror
    double mirrorHeight = 0.0;      // of the mirror, units

    // The depth at which the ray of screen row y enters this part; -1 if it starts at the eye.
    double beginsAt(double y) const {
        if (before == nullptr) return -1.0;
        return door != nullptr ? door->depthAt(before->view, before->ray, y)
                               : before->view.depthOfPlane(mirrorHeight, y);
    }
    bool isMirrored() const { return view.up < 0.0; }
};

// One of the things that a row shows, front to back.
struct Mark {
    const Part* part = nullptr;
    const Surface* surface = nullptr;  // null for the floor, the sky and the haze beyond `far`
    Shown shown;
};

// The most that a row shows, one thing behind the other; farther ones are left out, which bounds
// the time of a picture before a field of glass. The fast renderer has such a limit for a column.
inline constexpr std::size_t kMostMarks = 128;

class Column {
public:
    // All arguments must outlive it. The light's frame must have begun.
    Column(const World& world, const Eye& eye, const RenderOptions& options,
           const ClassicOptions& classic, LitMaps& lit, int width, int height);

    // The colours of the rows; x is the middle of the column.
    const std::vector<Pixel>& draw(double x);

    // The results of the last drawing.
    const RowGrid& rows() const { return rows_; }
    const std::vector<Mark>& marks(int row) const { return marks_[static_cast<std::size_t>(row)]; }
    const std::vector<std::unique_ptr<Part>>& parts() const { return parts_; }
    std::size_t partsUsed() const { return used_; }
    // What all columns so far took.
    const FrameReport& report() const { return report_; }

private:
    // Where a ray meets a surface; without a surface, where it begins. Nearer places come first; at
    // equal depth the order is that of Passing, then that in which surfaces were gathered.
    struct Place {
        const Surface* surface = nullptr;
        double depth = -1.0;

        bool isBefore(const Place& second) const;
    };

    Part& nextPart();
    void gather(Part& part);
    Part& beyond(const Part& from, const Surface& door);
    Part& mirrored(const Part& from, double height);

    // The next place on a row's ray; with `over`, only objects and that surface count.
    Place nextBehind(const Part& part, const Place& last, int row, const Surface* over) const;
    void findOverdrawn(Part& part);
    bool isMasked(const Part& part, const Surface& portal, int row) const;

    // Each returns the part where the ray continues: the same, another one, or null if it ends.
    Part* meet(Part& part, const Surface& surface, int row);
    Part* meetBackground(Part& part, int row);
    void follow(Part* part, int row);

    void paintNearest(Part& part);
    void paintFarToNear(Part& part);
    int mirrorIn(int row) const;
    int rippledRow(int row) const;
    void colourRows();
    void count();

    const World& world_;
    const ClassicOptions& classic_;
    const int map_;
    RowGrid rows_;
    View view_;  // of the eye
    SkyColumns skies_;
    const Palette palette_;
    FrameReport report_;
    std::vector<std::unique_ptr<Part>> parts_;  // kept from column to column
    std::size_t used_ = 0;
    std::vector<std::vector<Mark>> marks_;  // by row
    std::vector<Pixel> colours_;
};

}  // namespace slicecast::classic

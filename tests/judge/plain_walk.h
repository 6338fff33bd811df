// The walk of one screen column over the grid in its simplest form. It finds the same as
// `StripWalk` without any optimisation: read this one first. A test compares the two.
//
// A column has a ray for each of its rows. Seen from the side, these rays pass a tile like this:
//
//                  enter             leave
//           .- '     |                 |
//   eye  o ----------|-----------------|---      rising and falling
//           ' - .    |                 |
//                '-  +------ roof -----+
//                    |                 |
//            entered |                 | left
//               side |      block      | side
//                    |                 |
//                    +--- underside ---+
//                    |                 |
//          ==========+====== floor ====+====
//
// Where the rays enter the tile, a height lies between two rows; where they leave it, between two
// others. `firstRowBelow` finds them. Rays between a block's top and bottom at the entry meet its
// side. Rays above a height at the entry and below it at the exit (or the reverse) have crossed it
// inside the tile, and meet a plane that lies there. On each ray three kinds of things follow one
// another, so a tile is drawn in three steps:
//
//   1. the sides of its blocks that rays enter
//   2. the horizontal planes, from the eye's height outwards: roofs, undersides, ceiling, floor
//   3. the sides that rays leave, seen from inside
//
// All rows are open at first. Opaque things close the rows in which they show, so nothing behind
// them is drawn there: a face inside or behind a block needs no special case. See-through things
// close none, and become layers. The walk continues from tile to tile until no row is open or it
// has left the grid; rows that are still open then show floor, sky or haze.
//
// Two things send rows elsewhere. Rows that enter a portal are closed here and continue in a walk
// of their own (a `Part`, which waits in a list) behind the portal. Rows that meet a mirror show
// the mirror, and continue in a second picture of the column, which is upside down.
//
// plain_walk.cpp      from tile to tile, and within a tile: the algorithm
// plain_texels.cpp    objects, and the texels of sides and objects
// plain_passages.cpp  blocks that join; portals and mirrors
//
// It handles everything that a scene may hold, but counts nothing for a `FrameReport`.
#pragma once

#include "render/spans/grid_walk.h"
#include "render/spans/open_rows.h"
#include "render/spans/plan_walk.h"
#include "render/spans/slice_spans.h"
#include "render/spans/sloped_plane.h"
#include "render/view/frame.h"
#include "world/portal.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace slicecast {

class PlainWalk {
public:
    // Both must outlive the walk.
    PlainWalk(const Frame& frame, OpenRows& open) : frame_(frame), open_(open) {}

    // Finds what all rows of a column show.
    void find(int column, SliceSpans& found);

private:
    using What = FilledRows::What;

    struct Rows {
        int first;
        int last;  // one past the end
    };

    // A block of the current tile. Heights are in 1/65536 units above the eye; of a block with
    // slopes, those of its lowest and its highest point.
    struct Block {
        const CellBlueprint* blueprint;
        int level;
        std::int32_t bottom;
        std::int32_t top;
        bool cut;  // extends beyond the heights of the part's rays, which start inside it
    };

    // Where the ray enters or leaves a block within a tile.
    struct Edge {
        Crossing at;
        std::uint32_t level;  // its bit
    };
    static constexpr std::uint32_t kAllLevels = 0xffffffff;

    // A plane of the current tile, at `rise` above the eye. Of a block with slopes, faces are in
    // the list twice: as those by which rays enter the block, and by which they leave it.
    struct LevelPlane {
        What what;
        std::int32_t rise;
        Block block;            // of roofs and undersides
        bool leaving = false;   // rays leave the block through it
        std::int64_t away = 0;  // planes are sorted by it: twice the distance from the eye's height
    };

    // ---- plain_walk.cpp
    void walkParts();
    void walkPart();
    bool isGridLeft() const;
    void meetTile();
    void findEdges();
    void meetEdge(const Edge& edge);
    void meetStretch();
    void meetBackground();
    void findBlocks();
    void findPlanes();
    void enterSide(const Block& block);
    void leaveSide(const Block& block);
    void showSideBut(const Block& block, Face face, const Crossing& border, Rows rows, Rows joined);
    void meetPlane(const LevelPlane& plane);
    void meetFaceOfSlopes(const LevelPlane& plane);
    bool acts(const LevelPlane& plane) const;
    void meetFace(const LevelPlane& plane, Rows rows);
    int rowOf(const CellBlueprint& blueprint, Face face, GridTile tile, int level,
              const Crossing& at) const;
    int endRow(const CellBlueprint& blueprint, Face face, GridTile tile, int level,
               const Crossing& at) const;
    Rows rowsOf(const Block& block, const Crossing& border) const;
    Rows rowsOfPart(const LevelPlane& plane, Rows rows) const;
    int firstRowNotReflected(const Crossing& at) const;
    SlopedPlane slopedPlane(const CellBlueprint& blueprint, Face face, GridTile tile,
                            int level) const;
    void meetFloor(Rows rows, bool endless);
    void meetCeiling(Rows rows);
    Span spanOf(What what) const;
    using Finish = std::function<void(Span&)>;
    void show(const Span& look, Rows rows, const Finish& finish = {});
    void showPlane(const Span& look, Rows rows, int mirror, int ripples);

    // ---- plain_texels.cpp
    void findObjects();
    Crossing crossingAt(const FrameObject& object) const;
    void meetObject(const FrameObject& object);
    void showSide(const Block& block, Face face, const Crossing& border, Rows rows);
    std::uint32_t alongSide(const Block& block, const Crossing& border) const;
    TexelColumn sideColumn(const Block& block, Face face, const Crossing& border, Rows rows) const;
    void splitWhereTextureEnds(Span& seen);

    // ---- plain_passages.cpp
    Rows joinedRows(const Block& block, const CellBlueprint& other, GridTile tile,
                    const Crossing& border) const;
    Rows joinedNear(const Block& block, const Crossing& border, bool isAhead) const;
    Rows joinedBeyond(const Block& block, const CellBlueprint& other, const Crossing& border) const;
    Rows joinedBefore(const Block& block) const;
    Rows joinedBehind(const Block& block) const;
    bool joinsLevel(const Block& block, int up, bool leaving) const;
    const CellBlueprint& exitCell(PortalId portal, int level) const;
    const CellBlueprint& cellBeforePortal(int level) const;
    bool isArrival() const;
    bool isWhereItCameOut(const Block& block, int up) const;
    bool mayPass() const { return part_.portals < frame_.world->portalLimit; }
    void sendThrough(PortalId id, Rows rows, const HeightClip& clip);
    void reflect(SliceSpans& found);
    int mirrorStrength(std::uint8_t strength) const;

    const Map& map() const { return *part_.vista->map; }
    const Projection& projection() const { return *part_.vista->projection; }
    const CellBlueprint& cell(const Map& of, GridTile tile, int level) const {
        return frame_.world->blueprints[of.cell(tile.x, tile.y, level)];
    }
    PlaneLook& lookOf(const Plane& plane) const {
        return part_.vista->planeLooks.find(plane, frame_.textures[plane.texture], frame_.detail);
    }
    PlanWalk plansHere() const {
        return {walk_, part_.vista->viewpoint, part_.vista->ray(column_)};
    }
    std::int32_t riseOf(std::int32_t height) const { return height - part_.vista->viewpoint.z; }
    int rowBelow(std::int32_t rise, const Crossing& border) const {
        return firstRowBelow(projection(), rise, border);
    }
    // The tile before a border of the current one (`steps` is -1), or behind it (1).
    GridTile here() const { return {walk_.tileX, walk_.tileY}; }
    GridTile tileAcross(const Crossing& border, int steps) const {
        return {walk_.tileX + (border.alongX ? steps * walk_.stepX : 0),
                walk_.tileY + (border.alongX ? 0 : steps * walk_.stepY)};
    }

    const Frame& frame_;
    OpenRows& open_;
    int column_ = 0;
    ColumnSpans* found_ = nullptr;

    Part part_;  // the part being walked
    int number_ = 0;
    std::vector<const FrameObject*> objects_;  // in this column, nearest first

    GridWalk walk_{{}, {}, {}};  // at the current tile
    Crossing enter_;             // how the tile was entered, or the last object or edge met in it
    Crossing leave_;             // how it will be left, or the next object or edge in it
    std::vector<Edge> edges_;    // within the tile, still to come
    std::uint32_t there_ = 0;    // levels whose blocks are there between `enter_` and `leave_`
    std::uint32_t begins_ = 0;   // levels whose blocks have a side at `enter_`
    std::uint32_t ends_ = 0;     // or at `leave_`
    std::vector<Block> blocks_;  // of the tile, from below
    std::vector<LevelPlane> planes_;
};

}  // namespace slicecast

// The walk of one screen column over the grid: what its rays meet, front to back, as spans.
//
//      rows
//       |    .--------.  back
//       |   /  roof  /|
//       |  .--------. |
//       |  |  side  | '
//       v  '--------'  front
//
// The side of a block fills the rows between its top and bottom edge where the walk enters the
// tile. Its roof fills those up to where the top edge appears at the tile's far border; the
// underside is alike. Floor and ceiling fill the rows between the two borders. A filled row is
// closed, so each pixel has one opaque span, and the walk ends when no row is open.
//
// slice_walk.cpp      over tiles in which nothing changes, and what lies beyond
// slice_cover.cpp     floor and ceiling
// slice_blocks.cpp    the blocks of a tile, their roofs and undersides
// slice_sides.cpp     their sides
// slice_slopes.cpp    blocks with slopes
// slice_plans.cpp     tiles whose blocks fill only parts of them
// slice_layers.cpp    see-through blocks
// slice_objects.cpp   objects
// slice_passages.cpp  portals and mirrors, where the walk goes on elsewhere
#pragma once

#include "render/frame.h"
#include "render/grid_walk.h"
#include "render/open_rows.h"
#include "render/plan_walk.h"
#include "render/slice_spans.h"
#include "render/sloped_plane.h"
#include "render/texel_cut.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace slicecast {

// A height that no block reaches, 1/65536 units above the eye.
inline constexpr std::int32_t kHighest = std::numeric_limits<std::int32_t>::max();

class SliceWalk {
public:
    // `cut` examines the texels of see-through sides and objects: it leaves out rows of holes, and
    // opaque rows are closed, so that nothing behind them is found. `whole` takes them as they are.
    enum class SeeThrough { whole, cut };

    // All three must outlive the walk; `open` and the argument of `find` keep their memory from
    // slice to slice.
    __attribute__((noinline))
    SliceWalk(const Frame& frame, OpenRows& open, FrameReport& report, SeeThrough seeThrough);

    // Finds what all rows of a column show.
    void find(int column, SliceSpans& found, bool withReflection = true);

private:
    friend class StripWalk;

    using What = FilledRows::What;

    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    // Why a walk over tiles stopped: something changes in a tile, the tile is a portal, nothing
    // more can be met, or the walk has left the grid.
    enum class Pass { tile, portal, stopped, left };

    // One of the current tile's two borders.
    enum class Border { enter, leave };

    // A block in the current tile. Heights are in 1/65536 units, relative to the eye.
    struct Block {
        const CellBlueprint* blueprint;
        int level;
        std::int32_t bottom;
        std::int32_t top;
        bool cut = false;  // by the part's height clip, or at a border of levels within a mover: no
                           // face at that end, and rays that start there are inside
    };

    // The top or the underside of a block with slopes.
    struct FaceOfSlopes {
        Face face = Face::top;
        bool isSloped = false;  // else level
        SlopedPlane plane;
        int atEnter = 0;  // the first row below it there
        int atLeave = 0;
    };

    struct MetSlopes {
        FaceOfSlopes top;
        FaceOfSlopes bottom;
    };

    // Values shared by all sides at one border.
    struct SideView {
        std::uint32_t fraction;  // of a tile, from its northern or western end, in 1/2^32
        double along;            // see Crossing
        double depth;            // units
        double brightness;       // see Lighting
        std::uint32_t fog;
    };

    // A side of a block, for any column. Positions are along the texture, as in TexelColumn.
    struct Side {
        const FaceBlueprint* look;
        const FrameTexture* texture;
        int level;
        Face face;
        bool layer;
        bool reversed;       // its texture's columns run northward or westward
        double upperEdge;    // of the level, above the eye, units
        std::int64_t start;  // the block's part of the level
        std::int64_t end;
        std::int64_t rise;
        std::uint32_t least = 0;  // what the block covers of its tile, in 1/2^32: both included
        std::uint32_t most = 0xffffffff;
        Coordinate slide = {};  // of its texture, eastward or southward

        // Where a column sees it.
        std::uint32_t shown(const SideView& view) const {
            return std::clamp(view.fraction, least, most);
        }
    };

    // Floor or ceiling of one texture, from a border on.
    struct Cover {
        TextureId texture = kNoTexture;
        int row = 0;    // the first row below the plane at that border
        int fromX = 0;  // the tile behind that border
        int fromY = 0;
    };

    // ---- slice_walk.cpp
    void beginColumn(int column, SliceSpans& found);
    void walkParts();
    bool nextPart();
    Part& part() const { return found_->parts[static_cast<std::size_t>(part_)]; }
    void begin();
    void lookInto(Vista& vista);
    void goOn(bool leaveFirst);
    void meetHere(std::uint32_t plans);
    void meetCurrent(std::uint32_t plans);
    bool hasObject() const { return objects_ != nullptr && object_ < objects_->objects.size(); }
    const FrameObject& object() const { return vista_->objects[objects_->objects[object_]]; }
    // The next place along the ray where an object is, or where one has to be looked for.
    double nextObjectAlong() const { return hasObject() ? object().along : objectsTo_; }
    void endWay(Pass pass);
    double whereToStop(int first, int last) const;
    Pass passTiles(bool leaveFirst);
    void meetTile(std::uint32_t plans);
    void meetStretch();
    void takeBackground();
    void takeHaze(int firstRow);
    Span& add(What what, int first, int last);
    Span& addPlane(What what, PlaneLook& look, int first, int last, const TileRange& tiles);
    __attribute__((noinline)) void addFace(What what, PlaneLook& look, int first, int last,
                                           const TileRange& tiles, int level);
    PlaneLook& lookOf(const Plane& plane) {
        return vista_->planeLooks.find(plane, frame_.textures[plane.texture], frame_.detail);
    }
    bool isFull() const { return found_->isFull(); }
    bool countLayer();  // false if the column is full
    bool mayAddLayer(int firstRow, int lastRow) const {
        return !isFull() && open_.mayHold(firstRow, lastRow);
    }
    __attribute__((noinline)) std::uint32_t withoutLayers(int x, int y, std::uint32_t levels) const;

    // ---- slice_cover.cpp
    void takeFloor(Border upTo);
    void takeFloorBeyond(int row);
    void takeFloorRows(int row, const TileRange& tiles);
    void addFloor(int first, int last, const TileRange& tiles);
    void startCeiling(TextureId texture);
    void endCeiling(Border at);

    // ---- slice_blocks.cpp
    Block blockAt(int x, int y, int level) const {
        const BlueprintId id = map_->cells[map_->cellIndex(x, y, level)];
        const CellBlueprint& blueprint = frame_.world->blueprints[id];
        const std::int32_t base = tileEdge(level).raw - eyeZ_;
        return {&blueprint, level, base + blueprint.bottom.raw, base + blueprint.top.raw, false};
    }
    void meetBlocks(std::uint32_t reached, TextureId ceilingTexture);
    __attribute__((noinline)) int leaveDownwards(const Block& block, int edgeRow);
    void meetFalling(std::uint32_t levels, TextureId ceilingTexture);
    void meetRising(std::uint32_t levels, TextureId ceilingTexture);
    void takeRoof(const Block& block, int firstRow, int lastRow, bool fromInside = false);
    void takeUnderside(const Block& block, int firstRow, int lastRow);
    void takeCeilingHere(TextureId texture);
    Plane planeOf(const Block& block, Face face) const;

    // ---- slice_slopes.cpp
    int rowOfFace(const CellBlueprint& block, Face face, int x, int y, int level,
                  const Crossing& at) const;
    FaceOfSlopes faceOfSlopes(const Block& block, Face face) const;
    int firstRowNotReflected(Border at) const {
        return clip_.isMirror ? rowBelow(clip_.low, at) : projection_->height;
    }
    MetSlopes enterSlopes(const Block& block);
    void passSlopes(const Block& block, const MetSlopes& met);
    int endOfSide(const Block& block, const FaceOfSlopes& face, Border at) const;
    void cutToPart(const Block& block, const FaceOfSlopes& at, bool isDownwards, int& first,
                   int& last) const;
    void passFace(const Block& block, const FaceOfSlopes& at, bool leaving);
    void takeSlope(const Block& block, const FaceOfSlopes& at, int firstRow, int lastRow);

    // ---- slice_sides.cpp
    // Rounding may put a point on the border of two texels just before it: positions are moved on
    // by this part of a tile, far less than a pixel and far more than the rounding error.
    static constexpr double kSnap = 1.0 / 17179869184.0;
    static std::uint32_t fractionBits(double fraction) {
        constexpr double kEnd = 4294967295.0;  // of 1 << 32
        return static_cast<std::uint32_t>(
            std::min(kEnd, std::max(0.0, fraction + kSnap) * 4294967296.0));
    }
    SideView sideView(const Crossing& border) const;
    Side sideOf(const Block& block, Face face, bool layer) const;
    TexelColumn sideColumn(const Side& side, const SideView& view, int first, int last) const;
    void addSide(const Side& side, const SideView& view, int first, int last);
    void addSideRows(const Side& side, const SideView& view, const TexelColumn& column, int first,
                     int last);
    void addSideSpan(const Side& side, const SideView& view, const TexelColumn& column, int first,
                     int last);
    void takeSide(const Side& side, const SideView& view, int firstRow, int lastRow);
    void takeEnteredSide(const Block& block, int firstRow, int lastRow);

    // ---- slice_plans.cpp
    std::uint32_t levelsWithPlans(int x, int y) const;
    void findPlanEdges(std::uint32_t levels);
    void meetTileWithPlans(std::uint32_t levels);
    bool isAtEye(int level) const { return walk_.entered == 0.0 && (late_ >> level & 1) == 0; }
    bool entersAt(int level) const {
        return enter_.hasSides() && (enter_.border || (within_ >> level & 1) == 0);
    }
    bool leavesAt(int level) const {
        return leave_.hasSides() && (leave_.border || (staying_ >> level & 1) == 0);
    }
    PlanWalk plansHere() const { return {walk_, vista_->viewpoint, ray_}; }

    // ---- slice_layers.cpp
    // Faces of water may be missing.
    bool isThere(const Block& block, Face face) const {
        const TextureId texture = block.blueprint->face(face).texture;
        return texture != kNoTexture && !(cuts_ && frame_.textures[texture].invisible);
    }
    // Called at many places, but rarely: not inlined, to keep the program small.
    __attribute__((noinline)) const CellBlueprint* joinedAt(const Block& block, const Map& map,
                                                            int x, int y, int level) const;
    const CellBlueprint* joinedBeyond(const Block& block, const Map& map, int x, int y,
                                      int level) const;
    const CellBlueprint* joinedBefore(const Block& block) const;
    const CellBlueprint* joinedNear(const Block& block, Border border) const;
    // The level of the next block if rays go on inside it, else kNoLevel.
    int insideOf(const Block& block, int up) const {
        return !block.blueprint->seeThrough && goesOn(block, up) ? block.level + up : kNoLevel;
    }
    bool isAbsent(int level) const { return absent_ != 0 && (absent_ >> (level & 31) & 1) != 0; }
    __attribute__((noinline)) bool goesOn(const Block& block, int up) const;
    bool joinsNext(const Block& block, int up, bool leaving) const;
    __attribute__((noinline)) void seeUnjoined(const Block& block, const CellBlueprint* joined,
                                               Face face, Border border, int firstRow, int lastRow);
    void enterThroughSide(const Block& block, int firstRow, int lastRow);
    void passThroughPlane(const Block& block, Face face, int firstRow, int lastRow, bool leaving);
    void leaveThroughSide(const Block& block, int firstRow, int lastRow);
    void seeThroughSide(const Side& side, const SideView& view, int firstRow, int lastRow);
    void seeThroughPlane(What what, const Plane& plane, int firstRow, int lastRow,
                         const TileRange& tiles, int level = kNoLevel);

    // ---- slice_objects.cpp
    void meetTileWithObjects();
    void meetObjectsBeyond();
    __attribute__((noinline)) void findObjects(double to);
    void skipHiddenObjects();
    double across(const FrameObject& object) const;
    Crossing crossingAt(const FrameObject& object) const;
    void meetObject(const FrameObject& object);

    // ---- slice_passages.cpp
    bool acts(PortalId portal, bool atExit) const;
    bool actsAtTop(const Block& block) const;
    bool actsAtBottom(const Block& block) const;
    bool isArrival() const {
        return portals_ > 0 && walk_.tileX == startX_ && walk_.tileY == startY_;
    }
    void enterSide(const Block& block, int firstRow, int lastRow);
    void enterTop(const Block& block, int firstRow, int lastRow);
    void enterBottom(const Block& block, int firstRow, int lastRow);
    void leaveSide(const Block& block, int firstRow, int lastRow);
    void leaveTop(const Block& block, int firstRow, int lastRow);
    void leaveBottom(const Block& block, int firstRow, int lastRow);
    bool cutToClip(Block& block) const;
    void sendThrough(PortalId id, int firstRow, int lastRow, const HeightClip& clip);
    void enterPortalTile();
    void mirror(std::int32_t rise, int first, int last, int strength, int ripples);
    bool beginReflection(SliceSpans& found);
    int mirrorStrength(std::uint8_t strength) const {
        return strength == 0
                   ? 0
                   : static_cast<int>(std::min(255.0, std::floor(strength * frame_.mirrors + 0.5)));
    }

    CutMargin cutMargin() const { return {frame_.rippleRows, projection_->firstFallingRow}; }

    int rowBelow(std::int32_t rise, const Crossing& border) const {
        return firstRowBelow(*projection_, rise, border);
    }
    int rowBelow(std::int32_t rise, Border border) const {
        return rowBelow(rise, border == Border::enter ? enter_ : leave_);
    }

    // The tile before a border of the current one, and the tile behind it.
    int beforeX(Border border) const {
        return walk_.tileX -
               (border == Border::enter && enter_.border && enter_.alongX ? walk_.stepX : 0);
    }
    int beforeY(Border border) const {
        return walk_.tileY -
               (border == Border::enter && enter_.border && !enter_.alongX ? walk_.stepY : 0);
    }
    int behindX(Border border) const {
        return walk_.tileX +
               (border == Border::leave && leave_.border && leave_.alongX ? walk_.stepX : 0);
    }
    int behindY(Border border) const {
        return walk_.tileY +
               (border == Border::leave && leave_.border && !leave_.alongX ? walk_.stepY : 0);
    }

    const Frame& frame_;
    Vista& ownVista_;  // of the eye
    const bool cuts_;
    OpenRows& open_;
    FrameReport& report_;

    // Of the slice
    int column_ = 0;
    ColumnSpans* found_ = nullptr;

    // Of its present part, in the coordinates of the part's map (see vista.h)
    Vista* vista_ = nullptr;
    const Map* map_ = nullptr;
    const Projection* projection_ = nullptr;
    GroundDirection ray_;
    int eyeTileX_ = 0;
    int eyeTileY_ = 0;
    double eyeFractionX_ = 0.0;
    double eyeFractionY_ = 0.0;
    std::int32_t eyeZ_ = 0;  // 1/65536 units; may be below the floor behind a portal or in a mirror
    double eyeHeight_ = 0.0;      // the same in units
    std::int32_t floorRise_ = 0;  // 1/65536 units above the eye
    std::int32_t ceilingRise_ = 0;
    std::uint32_t levelsToEye_ = 0;  // a bit for each level that starts at or below the eye
    const TextureId* ceilingTiles_ = nullptr;  // null if no ceiling can be met
    int floorMirror_ = 0;                      // strength
    bool hasTilePortals_ = false;
    HeightClip clip_;
    double lowest_ = 0.0;  // no ray of the part runs lower, units
    bool clipped_ = false;
    int part_ = 0;     // index of the part
    int portals_ = 0;  // passed so far
    int startX_ = 0;   // the tile where the part starts
    int startY_ = 0;
    int tiles_ = 0;  // tiles of the part so far
    bool endsInPortal_ = false;
    Before before_;

    GridWalk walk_;
    TileRange here_;  // the current tile
    Crossing enter_;  // how the current tile, or the stretch after an object in it, was entered
    Crossing leave_;  // how it will be left: through its border, or at the next object
    const ColumnObjects* objects_ = nullptr;  // null in a map without objects
    std::size_t object_ = 0;                  // of them, the next one that covers the column
    double objectsTo_ = kNever;               // how far along the ray all are known
    SideView enteredSide_;                    // only valid if enteredSideKnown_
    bool enteredSideKnown_ = false;
    std::uint32_t reached_ = 0;  // levels of the current tile whose blocks an open row may meet
    PlanEdges planEdges_;        // of the current tile
    // Of a tile with plans, levels whose blocks are not between `enter_` and `leave_`, began before
    // `enter_`, end after `leave_`, began at an edge within the tile
    std::uint32_t absent_ = 0;
    std::uint32_t within_ = 0;
    std::uint32_t staying_ = 0;
    std::uint32_t late_ = 0;
    Cover floor_;
    std::size_t floorSpan_ = kNone;  // the last floor span of this part
    Cover ceiling_;
};

inline Span& SliceWalk::add(What what, int first, int last) {
    Span& span = found_->spans.add();
    span.what = what;
    span.face = Face::top;
    span.layer = false;
    span.first = first;
    span.last = last;
    span.level = kNoLevel;
    span.object = -1;
    span.part = part_;
    span.portals = portals_;
    span.vista = vista_;
    return span;
}

inline Span& SliceWalk::addPlane(What what, PlaneLook& look, int first, int last,
                                 const TileRange& tiles) {
    Span& span = add(what, first, last);
    span.look = &look;
    span.tiles = tiles;
    return span;
}

inline bool SliceWalk::countLayer() {
    if (isFull()) return false;
    ++found_->layers;
    return true;
}

}  // namespace slicecast

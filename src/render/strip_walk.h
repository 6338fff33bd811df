// The walk of a strip's 16 columns together: each tile of the eye's map is examined once, front to
// back, for all columns that pass it.
//
//      +---+---+---+---+        The rays run mostly along the major axis, u. A slab is the
//      |   |   | . |.  |  ^     tiles between two borders of u. Within it the columns pass
//      |   | . |.' |   |  |     a few neighbouring tiles. Tiles are examined slab by slab,
//      | o:' ' |   |   |  v     and in a slab from the eye's row outward: for each column
//      +---+---+---+---+        that is front to back.
//        u -->
//
// The contents of a tile are projected for all columns at once, and open rows are closed for all at
// once. For rare contents (plans, portals, objects, movers that are see-through or sloped, the
// eye's own tile) each column goes by itself, by the walk of slice_walk.h. Mirrored parts of the
// eye's map are walked together, too. Functions marked noinline are not copied to each call, to
// keep the program small.
//
// strip_walk.cpp      from tile to tile
// strip_slabs.cpp     which columns pass which tiles
// strip_rows.cpp      where they see heights
// strip_cover.cpp     floor and ceiling
// strip_blocks.cpp    the blocks of a tile
// strip_sides.cpp     their sides
// strip_planes.cpp    their roofs and undersides
// strip_slopes.cpp    blocks with slopes
#pragma once

#include "render/open_lanes.h"
#include "render/open_slopes.h"
#include "render/slice_walk.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace slicecast {

// Memory kept from strip to strip and from frame to frame.
struct StripScratch {
    OpenLanes::Scratch open;
    std::array<SliceSpans, kLanes> found;
};

class StripWalk {
public:
    // All must outlive the walk.
    StripWalk(const Frame& frame, StripScratch& scratch, FrameReport& report);

    // Finds what all rows of the columns [first, first + count) show, 1 to 16 of them; writes the
    // first elements of scratch.found.
    void find(int first, int count);

private:
    using Border = SliceWalk::Border;
    using Block = SliceWalk::Block;
    using Pass = SliceWalk::Pass;
    using What = FilledRows::What;

    // One number for each column.
    struct LaneDoubles {
        alignas(16) std::array<double, kLanes> at;
        double& operator[](std::size_t i) { return at[i]; }
        double operator[](std::size_t i) const { return at[i]; }
        const double* data() const { return at.data(); }
    };

    // The top or the underside of a block with slopes.
    struct FaceOfSlopes {
        Face face = Face::top;
        bool isSloped = false;  // else level
        double height = 0.0;    // of its plane: see SlopedPlane
        LaneDoubles horizon;
        Lanes atEnter;  // the first rows below it there
        Lanes atLeave;
    };

    struct MetSlopes {
        FaceOfSlopes top;
        FaceOfSlopes bottom;
    };

    using SideViews = std::array<SliceWalk::SideView, kLanes>;

    template <std::size_t... index>
    StripWalk(const Frame& frame, StripScratch& scratch, FrameReport& report,
              std::index_sequence<index...>);

    // ---- strip_walk.cpp
    bool aim(int first, int count);
    unsigned walkMirrored(unsigned bits);
    void walk(unsigned bits);
    void walkSlab();
    void leaveGridSideways();
    bool isBeyond(double along) const;
    void goAlone(unsigned bits);
    void visit(int v);
    bool isAtEye(unsigned bits) const;
    unsigned crossing(int v);
    __attribute__((noinline)) unsigned withObjects(unsigned bits);
    void meetAlone(unsigned bits);
    void comeTo(int lane, int v);
    void countTiles(int lane, int v);
    void noticeChange(unsigned live);

    // ---- strip_slabs.cpp
    void findFarTiles();
    int farTile(int lane, double v) const;
    bool passOpenLand();

    // ---- strip_rows.cpp
    void findPerRaw();
    __attribute__((noinline)) Lanes rowsBelow(std::int32_t rise, Border at) const;
    __attribute__((noinline)) Lanes exactRows(Lanes rows, unsigned bits, std::int32_t rise,
                                              Border at) const;
    Crossing crossingOf(int lane, Border at) const;

    // ---- strip_cover.cpp
    void changeCover(TextureId floor, TextureId ceiling);
    __attribute__((noinline)) void takeFloor(Lanes mask, Border at);
    TileRange rangeTo(int lane, Border at, int fromU, int fromV) const;
    void startCeiling(Lanes mask, TextureId texture, Lanes rows);
    __attribute__((noinline)) void takeCeiling(Lanes mask, Lanes rows, Border at);
    __attribute__((noinline)) void takeCeilingHere(TextureId texture);

    // ---- strip_blocks.cpp
    bool findBlocks(std::uint32_t reached);
    bool hasPlainNeighbours(const Block& block) const;
    void meet(unsigned bits, TextureId floor, TextureId ceiling);
    void meetFalling(TextureId ceiling);
    void meetRising(TextureId ceiling);

    // ---- strip_sides.cpp
    Crossing borderOf(Border at, bool alongU, bool up) const;
    void takeSide(const Block& block, Lanes first, Lanes last);
    __attribute__((noinline)) void seeSide(const Block& block, Border at, Lanes first, Lanes last);
    __attribute__((noinline)) void seeRows(Lanes mask, const SliceWalk::Side& side, Border at,
                                           Lanes first, Lanes last);
    __attribute__((noinline)) const SideViews& viewsAt(Border at);

    // ---- strip_planes.cpp
    void enterTop(const Block& block, Lanes first, Lanes last);
    void enterBottom(const Block& block, Lanes first, Lanes last);
    __attribute__((noinline)) bool joinsNext(const Block& block, int up) const;
    __attribute__((noinline)) void takePlane(const Block& block, Face face, Lanes first,
                                             Lanes last);
    __attribute__((noinline)) void seePlane(const Block& block, Face face, Lanes first, Lanes last);

    // ---- strip_slopes.cpp
    __attribute__((noinline)) FaceOfSlopes faceOfSlopes(const Block& block, Face face) const;
    Lanes firstRowsNotReflected(Border at) const;
    __attribute__((noinline)) MetSlopes enterSlopes(const Block& block);
    void passSlopes(const Block& block, const MetSlopes& met);
    __attribute__((noinline)) void passFace(const Block& block, const FaceOfSlopes& at);

    // One of the columns that walk together, for values that they share.
    const SliceWalk& any() const { return lanes_[static_cast<std::size_t>(any_)]; }
    SliceWalk& lane(int index) { return lanes_[static_cast<std::size_t>(index)]; }
    int tileX(int v) const { return alongX_ ? u_ : v; }
    int tileY(int v) const { return alongX_ ? v : u_; }
    TileRange here() const { return {tileX(v_), tileY(v_), tileX(v_), tileY(v_), false}; }

    const Frame& frame_;
    StripScratch& scratch_;
    FrameReport& report_;
    OpenLanes open_;
    std::array<SliceWalk, kLanes> lanes_;

    // Of the strip
    const Map* map_ = nullptr;
    bool alongX_ = false;  // the major axis, u, is x
    int stepU_ = 1;
    int sizeU_ = 0;  // tiles
    int sizeV_ = 0;
    int eyeU_ = 0;  // the eye's tile
    int eyeV_ = 0;
    double fractionU_ = 0.0;  // the eye's place in its tile, 0 to 1
    double fractionV_ = 0.0;
    LaneDoubles speedU_;  // see Crossing
    LaneDoubles speedV_;
    LaneDoubles rayV_;   // the rays' direction along v
    LaneDoubles slope_;  // v per u, with sign
    std::array<int, kLanes> stepV_;
    Lanes stepsV_;            // stepV_ in lanes
    double alongPerU_ = 0.0;  // least and greatest `along` per unit of u
    double alongPerUMost_ = 0.0;

    // Of the walk, which is over the map or its reflection
    int any_ = 0;  // one of the walk's columns
    const Projection* projection_ = nullptr;

    // Of the slab
    int u_ = 0;
    double near_ = 0.0;  // distances of its borders from the eye, units
    double far_ = 0.0;
    LaneValues nearV_;  // the tiles in which columns enter and leave it
    LaneValues farV_;
    bool isWhole_ = false;     // all columns stay in one tile of it
    bool slabIsOpen_ = false;  // nothing was met in this slab so far, nor in the last one

    // Of the tile
    int v_ = 0;
    double enteredV_ = 0.0;  // distance of the border along v through which columns enter, units
    Lanes mask_;             // columns that pass it
    Lanes enteredAlongU_;    // which of them enter along u
    Lanes leftAlongU_;       // and which leave along u
    LaneDoubles entered_;    // rows per 1/65536 unit of height at its borders
    LaneDoubles left_;
    SideViews enteredViews_;  // of its sides, valid if known
    SideViews leftViews_;
    bool enteredViewsKnown_ = false;
    bool leftViewsKnown_ = false;
    std::array<Block, kMaxLevels> block_;
    std::size_t blocks_ = 0;

    // The runs of floor and ceiling under and above the columns
    LaneValues floor_;  // texture
    LaneValues floorFromU_;
    LaneValues floorFromV_;
    LaneValues ceiling_;  // texture
    LaneValues ceilingRow_;
    LaneValues ceilingFromU_;
    LaneValues ceilingFromV_;
    bool coverChanged_ = false;  // since the three following were found
    int onlyFloor_ = 0;          // texture of all columns, or -1
    int onlyCeiling_ = 0;
    double nextObject_ = 0.0;  // `along` of the nearest object that has not been met
};

}  // namespace slicecast

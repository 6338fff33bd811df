// One screen column: a walk over the grid, and what it meets drawn front to back into the rows that
// are still open.
//
//      rows                      A block seen from the side fills the rows between its top and bottom edge where the walk enters the tile; its roof those up to
//       |    .--------.  back    where the top edge appears at the tile's far border, its underside likewise below. Floor and ceiling fill what lies between
//       |   /  roof  /|          the two borders. A row that is drawn is closed, so each pixel is written once, and the walk ends when no row is open.
//       |  .--------. |
//       |  |  side  | '
//       v  '--------'  front
#pragma once

#include "render/frame.h"
#include "render/grid_walk.h"
#include "render/layers.h"
#include "render/open_rows.h"
#include "render/parts.h"
#include "render/trace.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace slicecast {

// What slices need while they are drawn; kept from slice to slice and from frame to frame, so that
// nothing is allocated again and again.
struct SliceMemory {
    OpenRows open;
    Layers layers;
    Parts parts;
    std::vector<MirrorRun> mirrors;
    // Of what shows in mirrors. The column stands upside down.
    Layers reflectedLayers;
    Parts reflectedParts;
    std::vector<Pixel> reflected;
};

class Slice {
public:
    Slice(const Frame& frame, SliceMemory& memory, FrameReport& report);

    // Fills all rows of `column` into `pixels`, one after another. `trace`, if given, receives
    // everything that happens.
    void draw(int column, Pixel* pixels, SliceTrace* trace);

private:
    static constexpr int kNoLevel = -1;  // rows that belong to no block

    // Why a walk over tiles was interrupted: something changes in a tile, the tile is a portal,
    // nothing more can be met, or the grid lies behind.
    enum class Pass { tile, portal, stopped, left };

    // One of the current tile's two borders.
    enum class Border { enter, leave };

    // A block in the current tile. Heights are in 1/65536 units, relative to the eye.
    struct Block {
        const CellBlueprint* blueprint;
        int level;
        std::int32_t bottom;
        std::int32_t top;
        bool cut = false;  // by the part's height clip, or the border between levels: there is no
                           // face at that end, and rays that begin there are inside
    };

    // What the sides at one border have in common.
    struct SideView {
        std::uint32_t fraction;  // of a tile, from its northern or western end, in 1/2^32
        double depth;            // units
        double brightness;       // see Lighting
        std::uint32_t fog;
    };

    // Floor or ceiling from a border on, as long as it has one texture.
    struct Cover {
        TextureId texture = kNoTexture;
        int row = 0;    // the first row below the plane at that border
        int fromX = 0;  // the tile behind it
        int fromY = 0;
    };

    // The tiles over which a plane's rows lie, relative to the eye's tile: its points are in [east,
    // eastEnd) x [south, southEnd).
    struct TileBox {
        double east;
        double eastEnd;
        double south;
        double southEnd;
    };

    void drawParts();
    void begin(const Part& part);
    void lookInto(Vista& vista);
    void walk();
    double whereToStop() const;

    // What a portal leads away, and what a mirror shows.
    bool acts(PortalId portal, bool atExit) const;
    bool actsAtTop(const Block& block) const;
    bool actsAtBottom(const Block& block) const;
    void sendThrough(const Portal& portal, int firstRow, int lastRow, const HeightClip& clip);
    void enterPortalTile();
    void mirror(std::int32_t rise, int first, int last, int strength);
    void reflect();
    int mirrorStrength(std::uint8_t strength) const {
        return strength == 0
                   ? 0
                   : static_cast<int>(std::min(255.0, std::floor(strength * frame_.mirrors + 0.5)));
    }

    Pass passTiles(bool leaveFirst) {
        return hasTilePortals_ ? passTilesWith<true>(leaveFirst) : passTilesWith<false>(leaveFirst);
    }
    template <bool portals>
    Pass passTilesWith(bool leaveFirst);
    void drawTile();
    void drawStretch();
    void drawTileWithObjects();
    void drawObjectsBeyond();
    void skipHiddenObjects();
    double across(const FrameObject& object) const;
    Crossing crossingAt(const FrameObject& object) const;
    void drawObject(const FrameObject& object);
    Block blockAt(int level) const;
    void drawBlocks(std::uint32_t reached, TextureId ceilingTexture);
    __attribute__((noinline)) bool leaveDownwards(const Block& block, int edgeRow);
    void drawFalling(std::uint32_t levels, TextureId ceilingTexture);
    void drawRising(std::uint32_t levels, TextureId ceilingTexture);
    SideView sideView(const Crossing& border) const;
    SideRun sideRun(const Block& block, Face face, const Crossing& border, const SideView& view,
                    int first, int last) const;
    void drawSide(const Block& block, Face face, const Crossing& border, const SideView& view,
                  int firstRow, int lastRow);
    void drawEnteredSide(const Block& block, int firstRow, int lastRow);
    bool cutToClip(Block& block) const;
    void enterSide(const Block& block, int firstRow, int lastRow);
    void enterTop(const Block& block, int firstRow, int lastRow);
    void enterBottom(const Block& block, int firstRow, int lastRow);
    void leaveSide(const Block& block, int firstRow, int lastRow);
    void leaveTop(const Block& block, int firstRow, int lastRow);
    void leaveBottom(const Block& block, int firstRow, int lastRow);
    void drawRoof(const Block& block, int firstRow, int lastRow, bool fromInside = false);
    void drawUnderside(const Block& block, int firstRow, int lastRow);
    void drawCeilingHere(TextureId texture);
    bool isArrival() const {
        return portals_ > 0 && walk_.tileX == startX_ && walk_.tileY == startY_;
    }
    // Water may lack faces.
    static bool isThere(const Block& block, Face face) {
        return block.blueprint->face(face).texture != kNoTexture;
    }
    __attribute__((noinline)) const CellBlueprint* joinedAt(const Block& block, const Map& map,
                                                            int x, int y, int level) const;
    const CellBlueprint* joinedBefore(const Block& block) const;
    // Called at many places, and seldom: a copy at each would be loaded for nothing.
    __attribute__((noinline)) bool goesOn(const Block& block, int up) const;
    bool joinsNext(const Block& block, int up, bool leaving) const;
    __attribute__((noinline)) void drawUnjoined(const Block& block, const CellBlueprint* joined,
                                                Face face, const Crossing& border, int firstRow,
                                                int lastRow);
    void enterThroughSide(const Block& block, int firstRow, int lastRow);
    void passThroughTop(const Block& block, int firstRow, int lastRow, bool leaving);
    void passThroughBottom(const Block& block, int firstRow, int lastRow, bool leaving);
    void leaveThroughSide(const Block& block, int firstRow, int lastRow);
    void seeThroughSide(const Block& block, Face face, const Crossing& border, const SideView& view,
                        int firstRow, int lastRow);
    void seeThroughPlane(int level, FilledRows::What what, const PlaneRun& run);
    void takeFloor(Border upTo);
    void takeFloorBeyond(int row);
    void startCeiling(TextureId texture);
    void endCeiling(Border at);
    void drawBackground();
    void drawHaze(int firstRow);
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

    void gather(const Plane& plane, int first, int last, int fromX, int fromY, int toX, int toY,
                bool endless = false);
    void fill(PlaneRun& run);
    void fillRows(const PlaneRun& run, Lay lay);
    void fillFromWater(const SideRun& run, Lay lay);
    std::uint32_t fogOf(std::uint32_t fog, int row) const {
        return waterFogs_ == nullptr ? fog : std::min<std::uint32_t>(fog, waterFogs_[row]);
    }
    void layOver();
    bool isOnBorder(const PlaneRun& run, const PlaneLine& line, const PlaneRows& rows) const;
    void fillInside(const PlaneRun& run, const PlaneLine& line, const PlaneRows& rows, int first,
                    int last, Lay lay);
    __attribute__((noinline)) void fillRowByRow(const PlaneRun& run, const PlaneLine& line,
                                                const PlaneRows& rows, int first, int last,
                                                Lay lay);
    void drawPlaneTexel(int row, const TextureLevel& level, std::uint32_t east, std::uint32_t south,
                        bool southReversed, const PlaneRows& rows, Lay lay, Pixel there);
    // The point of a plane that one row shows, as fractions of a tile in 1/2^32.
    struct PlanePoint {
        std::uint32_t east;
        std::uint32_t south;
    };
    PlanePoint planePoint(const PlaneLine& line, const TileBox& box, double inverse) const;
    TileBox boxAround(const PlaneRun& run) const;
    __attribute__((noinline)) static bool isInside(const TileBox& box, const PlaneLine& line,
                                                   double inverse);
    void count(int first, int last) {
        ++report_.spansDrawn;
        report_.rowsFilled += last - first;
    }
    void note(int level, FilledRows::What what, Face face, int first, int last) {
        if (trace_) traceRows(level, what, face, first, last);
    }
    FilledRows& traceRun(int level, FilledRows::What what, Face face, int first, int last,
                         TextureId texture, bool layer);
    void traceRows(int level, FilledRows::What what, Face face, int first, int last);
    void traceSide(const Block& block, Face face, const Crossing& border, const SideView& view,
                   int first, int last, bool layer);
    void tracePlane(int level, FilledRows::What what, Face face, const PlaneRun& run, int first,
                    int last, bool layer);
    bool watches(int first, int last) const {
        return first <= trace_->watchedRow && trace_->watchedRow < last;
    }
    void tracePoint(const TracedTexel& texel);
    SliceTrace& traceReflection();
    static void turnUpright(SliceTrace& trace, int height);
    void traceObject(const FrameObject& object, int u, std::uint64_t start, std::uint64_t step,
                     int first, int last);
    void traceTile(int x, int y, double along);
    void traceBlocks(std::uint32_t levels);
    void traceBlock(const Block& block);

    const Frame& frame_;
    Vista& ownVista_;  // of the eye
    SliceMemory& memory_;
    OpenRows& open_;
    FrameReport& report_;

    // Of the slice that is being drawn:
    int column_ = 0;
    Pixel* pixels_ = nullptr;
    SliceTrace* trace_ = nullptr;
    Layers* layers_ = nullptr;
    Parts* parts_ = nullptr;
    const std::uint8_t* waterFogs_ = nullptr;  // see Vistas; null too for what mirrors show

    // Of its part that is being drawn, in the coordinates of the part's map (see vista.h):
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
    std::uint32_t levelsToEye_ = 0;  // a bit for each level that begins at or below the eye
    const TextureId* ceilingTiles_ = nullptr;  // null where no ceiling can be met
    int floorMirror_ = 0;                      // strength
    bool hasTilePortals_ = false;
    HeightClip clip_;
    bool clipped_ = false;
    std::size_t part_ = 0;  // its number
    int portals_ = 0;       // passed so far
    int startX_ = 0;        // the tile in which it began
    int startY_ = 0;
    Before before_;

    GridWalk walk_;
    Crossing enter_;  // how the current tile was entered
    Crossing leave_;  // and how it will be left; where objects stand in it, the stretch between two
                      // of them
    const int* object_ = nullptr;  // the next object that covers the column
    const int* objectsEnd_ = nullptr;
    SideView enteredSide_;  // worked out where a side is seen
    bool enteredSideKnown_ = false;
    std::uint32_t reached_ = 0;  // its levels whose blocks an open row may meet
    Cover floor_;
    Cover ceiling_;
    PlaneRun falling_;                // of a plane below the eye
    PlaneRun rising_;                 // of a plane above it
    std::uint32_t tracedLevels_ = 0;  // of the current tile, whose blocks are the trace's last hits
    GridWalk tracedWalk_;  // the same walk again, for what the trace tells of its borders
};

// Adds rows to the run of their side of the horizon. Farther rows of a plane are nearer to the
// horizon, so a run grows towards it. Inlined always, and here and elsewhere numbers are handed
// over rather than small structures: WebAssembly passes those through memory, and waits for it.
__attribute__((always_inline)) inline void Slice::gather(const Plane& plane, int first, int last,
                                                         int fromX, int fromY, int toX, int toY,
                                                         bool endless) {
    const bool falls = plane.rise < 0;
    PlaneRun& run = falls ? falling_ : rising_;
    if ((falls ? run.first == last : run.last == first) && run.plane == plane) {
        (falls ? run.first : run.last) = falls ? first : last;
    } else {
        fill(run);
        run.plane.rise = plane.rise;
        run.plane.texture = plane.texture;
        run.plane.light = plane.light;
        run.plane.glow = plane.glow;
        run.plane.southReversed = plane.southReversed;
        run.plane.mirror = plane.mirror;
        run.first = first;
        run.last = last;
        run.fromX = fromX;
        run.fromY = fromY;
    }
    run.toX = toX;
    run.toY = toY;
    run.endless = endless;
}

}  // namespace slicecast

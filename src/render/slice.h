// One screen column: a walk over the grid, and what it meets drawn front to back into the rows that are still open.
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
#include "render/open_rows.h"
#include "render/trace.h"

#include <array>
#include <cstdint>

namespace slicecast {

class Slice {
public:
    Slice(const Frame& frame, OpenRows& open, FrameReport& report);

    // Fills all rows of `column` into `pixels`, one after another. `trace`, if given, receives everything that happens.
    void draw(int column, Pixel* pixels, SliceTrace* trace);

private:
    static constexpr int kNoLevel = -1;  // rows that belong to no block

    // Why a walk over tiles was interrupted: something changes in a tile, nothing more can be met, or the grid lies behind.
    enum class Pass { tile, stopped, left };

    struct Tile {
        int x;
        int y;
    };

    // A block in the current tile. Heights are in 1/65536 units, relative to the eye.
    struct Block {
        const CellBlueprint* blueprint;
        int level;
        std::int32_t bottom;
        std::int32_t top;
    };

    // What the sides at one border have in common.
    struct SideView {
        double fraction;    // of a tile, from its northern or western end, not negative
        double depth;       // units
        double brightness;  // see Lighting
        std::uint32_t fog;
    };

    // A level plane: the floor, a ceiling, or the roofs or undersides of blocks that end at one height.
    struct Plane {
        std::int32_t rise = 0;  // 1/65536 units above the eye, never 0 where anything is drawn
        TextureId texture = kNoTexture;
        double light = 1.0;
        bool southReversed = false;  // undersides and ceilings

        friend bool operator==(const Plane&, const Plane&) = default;
    };

    // Rows of a plane that lie over one tile or several in a row: closed already, but filled only when something else follows.
    struct PlaneRun {
        Plane plane;
        int first = -1;  // no rows where `first` is `last`
        int last = -1;
        Tile from = {0, 0};
        Tile to = {0, 0};
        bool endless = false;  // goes on in the ray's direction for ever
    };

    // Floor or ceiling from a border on, as long as it has one texture.
    struct Cover {
        TextureId texture = kNoTexture;
        int row = 0;         // the first row below the plane at that border
        Tile from = {0, 0};  // the tile behind it
    };

    // The tiles over which a plane's rows lie, relative to the eye's tile: its points are in [east, eastEnd) x [south, southEnd).
    struct TileBox {
        double east;
        double eastEnd;
        double south;
        double southEnd;
    };

    struct RowRange {
        int first;
        int last;
    };

    void walk();
    double whereToStop() const;

    Pass passTiles(bool leaveFirst);
    void drawTile();
    Block blockAt(int level) const;
    void drawBlocks(std::uint32_t reached, TextureId ceilingTexture);
    void drawFalling(std::uint32_t levels, TextureId ceilingTexture);
    void drawRising(std::uint32_t levels, TextureId ceilingTexture);
    SideView sideView(const Crossing& border) const;
    void drawSide(const Block& block, Face face, const Crossing& border, const SideView& view, RowRange rows);
    void drawEnteredSide(const Block& block, RowRange rows);
    void drawRoof(const Block& block, RowRange rows);
    void drawUnderside(const Block& block, RowRange rows);
    void drawCeilingHere(TextureId texture);
    void takeFloor(int row, Tile to, bool endless = false);
    void endCeiling(int row, Tile to);
    void drawBackground();
    int rowBelow(std::int32_t rise, const Crossing& border) const { return firstRowBelow(projection_, rise, border); }
    Tile here() const { return {walk_.tileX, walk_.tileY}; }
    Tile previous() const;
    Tile next() const;

    void gather(const Plane& plane, RowRange rows, Tile from, Tile to, bool endless = false);
    void fill(PlaneRun& run);
    TileBox boxAround(const PlaneRun& run) const;
    void holdInside(int row, const TextureLevel& level, const PlaneLine& line, const PlaneRows& rows, const TileBox& box);
    void note(int level, FilledRows::What what, Face face, int first, int last) {
        if (trace_) traceRows(level, {what, face, first, last});
    }
    void traceRows(int level, const FilledRows& rows);
    void traceTile(Tile tile, double along);
    void traceBlocks(std::uint32_t levels);
    void traceBlock(const Block& block);

    const Frame& frame_;
    const Map& map_;
    const Projection& projection_;
    OpenRows& open_;
    FrameReport& report_;
    const std::int32_t floorRise_;  // 1/65536 units above the eye
    const std::int32_t ceilingRise_;

    // Of the slice that is being drawn:
    int column_ = 0;
    Pixel* pixels_ = nullptr;
    SliceTrace* trace_ = nullptr;
    GroundDirection ray_;
    GridWalk walk_;
    Crossing enter_;             // how the current tile was entered
    Crossing leave_;             // and how it will be left
    SideView enteredSide_;       // worked out where a side is seen
    bool enteredSideKnown_ = false;
    std::uint32_t reached_ = 0;  // its levels whose blocks an open row may meet
    Cover floor_;
    Cover ceiling_;
    PlaneRun falling_;  // of a plane below the eye
    PlaneRun rising_;   // of a plane above it
    std::uint32_t tracedLevels_ = 0;  // of the current tile, whose blocks are the trace's last hits
};

}  // namespace slicecast

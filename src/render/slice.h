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
    // A block in the current tile. Heights are relative to the eye.
    struct Block {
        const CellBlueprint* blueprint;
        int level;
        std::int32_t bottomRaw;  // 1/65536 units
        std::int32_t topRaw;
        double bottom;           // units
        double top;
        int topFront;            // first row below the upper edge where the walk enters the tile
        int bottomFront;         // first row below the lower edge there
        int hit;                 // index into the trace, if there is one
    };

    // Floor or ceiling over one tile or several in a row that have the same texture, from a border on.
    struct PlaneRun {
        TextureId texture = kNoTexture;
        int row = 0;    // the first row below the plane at that border
        int fromX = 0;  // the tile behind it
        int fromY = 0;
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

    std::uint32_t levelsInReach(std::uint32_t occupied) const;
    int collectBlocks(std::uint32_t occupied, std::array<Block, kMaxLevels>& blocks) const;
    void drawBlocks(std::uint32_t occupied, TextureId ceilingTexture);
    void drawSides(const Block* blocks, int count);
    void drawFalling(const Block* blocks, int count, TextureId ceilingTexture);
    void drawRising(const Block* blocks, int count, TextureId ceilingTexture);
    void drawSide(const Block& block, Face face, const Crossing& border, RowRange rows);
    void drawLevelFace(const Block& block, Face face, RowRange rows);
    void drawCeilingHere(TextureId texture);
    PlaneRun startRun(TextureId texture, int row) const;
    void endFloor(int row, bool endless = false);
    void endCeiling(int row, bool inThisTile = false);
    int floorRow(const Crossing& border) const;
    int ceilingRow(const Crossing& border) const;
    void drawBackground();

    TileBox boxTo(int fromX, int fromY, int toX, int toY) const;
    TileBox boxToPrevious(const PlaneRun& run) const;
    TileBox boxWithoutEnd(const PlaneRun& run) const;
    void fillPlaneRows(int first, int last, std::int32_t riseRaw, const FaceBlueprint& face, bool southReversed, const TileBox& box);
    void holdInside(int row, const TextureLevel& level, const PlaneLine& line, const PlaneRows& rows, const TileBox& box);
    void note(const Block* block, FilledRows::What what, Face face, int first, int last) {
        ++report_.spansDrawn;
        if (trace_) traceRows(block, {what, face, first, last});
    }
    void traceRows(const Block* block, const FilledRows& rows);
    void traceTile();
    void traceBlock(Block& block);

    const Frame& frame_;
    const Map& map_;
    const Projection& projection_;
    OpenRows& open_;
    FrameReport& report_;

    // Of the slice that is being drawn:
    int column_ = 0;
    Pixel* pixels_ = nullptr;
    SliceTrace* trace_ = nullptr;
    GroundDirection ray_;
    GridWalk walk_;
    PlaneRun floor_;
    PlaneRun ceiling_;
};

}  // namespace slicecast

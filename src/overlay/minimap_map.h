// The minimap's map, kept as a picture: a tile is redrawn only when something shown of it has
// changed. Each picture looks all tiles around the eye up, which costs little compared with drawing
// them.
//
// A kept pixel has the colour of its tile, and instead of alpha a mark: the colour that lies over
// it. A tile's place is its coordinates modulo the size, so tiles in sight keep their places when
// the eye moves.
#pragma once

#include "base/image.h"
#include "overlay/minimap_tiles.h"
#include "overlay/minimap_view.h"
#include "slicecast/picture.h"

#include <cstdint>
#include <vector>

namespace slicecast {

class MinimapMap {
public:
    // The map to show.
    struct Place {
        const World& world;
        const Map& map;
        int level;
    };

    void draw(const Place& place, const MinimapView& view, int scale, const Picture& picture);

    // Tiles drawn since construction.
    long drawnTiles() const { return drawnTiles_; }

private:
    // Everything that the pixels of a tile depend on. Only numbers, so that looks compare as
    // memory; no look is all 0.
    struct Look {
        int x = 0;
        int y = 0;
        Pixel colour = 0;         // 0 outside the grid
        Pixel ground = 0;         // beside what fills only a part of the tile
        std::uint32_t plan = 0;   // that part: west, north, east and south, in 1/16 tile
        std::uint32_t kind = 0;   // its gate, water, motion, portals and half
        std::uint32_t edges = 0;  // four bits each: on a gap and on a dash, to the north, east ...
    };

    // The step from one pixel of a row to the next, in pixels of the map.
    struct MapStep {
        Coordinate x;
        Coordinate y;
    };

    void resize(int across, int size, int scale);
    void lookUp(const Place& place);
    Look lookOf(const MinimapTile* tile, int x, int y) const;
    void drawTile(const Look& look, int place);
    unsigned markOf(const Look& look, int fromWest, int fromNorth) const;
    void lay(Pixel* row, int count, Coordinate mapX, Coordinate mapY, MapStep step) const;

    int size_ = 0;    // of a tile, pixels
    int line_ = 0;    // width of edges, pixels
    int dash_ = 0;    // length of dashes, pixels
    int across_ = 0;  // tiles in a row
    int firstX_ = 0;  // the tile in the upper left corner
    int firstY_ = 0;
    long drawnTiles_ = 0;
    std::vector<std::uint32_t> looks_;  // by place
    Image image_;
};

}  // namespace slicecast

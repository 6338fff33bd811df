// The map under a minimap, as a picture that is kept: a tile is drawn again only when something
// that is shown of it has changed, whatever the reason. Each picture looks all tiles around the eye
// up anew, which is little beside drawing them.
//
// A kept pixel has the colour of its tile, and instead of an alpha a mark: which colour lies over
// it. Tiles have their places by their numbers, counted round, so that those that stay in sight
// stay where they are when the eye goes on.
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
    // What is to be shown.
    struct Place {
        const World& world;
        const Map& map;
        int level;
    };

    void draw(const Place& place, const MinimapView& view, int scale, const Picture& picture);

    // Since it was made.
    long drawnTiles() const { return drawnTiles_; }

private:
    // All that the pixels of a tile depend on. Numbers alone, to be kept and compared as such; no
    // tile is all 0.
    struct Look {
        int x = 0;
        int y = 0;
        Pixel colour = 0;         // 0 outside the grid
        std::uint32_t kind = 0;   // what there is on it, and its portals
        std::uint32_t edges = 0;  // four bits each: off and on a dash, to the north, east ...
    };

    // From one pixel of a row to the next, in pixels of the map.
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
    int line_ = 0;    // pixels that edges are wide
    int dash_ = 0;    // and dashes long
    int across_ = 0;  // tiles
    int firstX_ = 0;  // the tile in the upper left corner
    int firstY_ = 0;
    long drawnTiles_ = 0;
    std::vector<std::uint32_t> looks_;  // by place
    Image image_;
};

}  // namespace slicecast

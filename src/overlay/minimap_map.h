// The map under a minimap, as a picture that is kept: a tile is drawn again only when something
// that is shown of it has changed, whatever the reason. Each picture looks all tiles around the eye
// up anew, which is little beside drawing them.
//
// Of each pixel it keeps a mark: the tile that it belongs to, and which of the colours that lie
// over a tile's own. Tiles have their places by their numbers, counted round, so that those that
// stay in sight stay where they are when the eye goes on.
#pragma once

#include "overlay/minimap_tiles.h"
#include "overlay/minimap_view.h"
#include "render/picture.h"

#include <climits>
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
    // All that a tile's pixels depend on.
    struct Look {
        int x = INT_MIN;
        int y = 0;
        Colour colour;
        bool openGate = false;
        bool water = false;
        bool moves = false;
        std::uint8_t portals = 0;
        std::uint8_t edges[4] = {};  // to the north, east, south and west
        std::uint8_t dashes[4] = {};

        friend bool operator==(const Look&, const Look&) = default;
    };

    void resize(int across, int size, int scale, int width);
    void lookUp(const Place& place);
    Look lookOf(int x, int y) const;
    void drawTile(const Look& look, int slot);
    unsigned markOf(const Look& look, int fromWest, int fromNorth) const;
    void fetch(int count, Coordinate mapX, Coordinate mapY, Coordinate stepX, Coordinate stepY);

    int size_ = 0;  // of a tile, pixels
    int line_ = 0;  // pixels that edges are wide
    int dash_ = 0;
    int across_ = 0;  // tiles
    int firstX_ = 0;  // the tile in the upper left corner
    int firstY_ = 0;
    long drawnTiles_ = 0;
    std::vector<MinimapTile> tiles_;    // from the corner
    std::vector<Look> looks_;           // by the tile's place, as it is drawn
    std::vector<std::uint16_t> marks_;  // by the pixel's place
    std::vector<Pixel> colours_;        // by mark: of the tile
    std::vector<Pixel> under_;          // of a row
    std::vector<Pixel> over_;
};

}  // namespace slicecast

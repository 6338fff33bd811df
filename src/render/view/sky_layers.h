// A sky with layers: stars, sun, moon and clouds over its colours, from back to front. It is made
// of squares (see sky.h), which are worked out column by column by whole numbers.
#pragma once

#include "render/view/projection.h"
#include "slicecast/colour.h"
#include "world/sky.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

class SkyLayers {
public:
    // The sky must outlive the frame.
    void beginFrame(const Sky& sky, const Projection& projection, std::int64_t steps);

    // Fills the rows [first, last) of a column of pixels that starts at `colours`; no row is below
    // the horizon. Columns of squares are numbered clockwise from the east, from 0 to kSkyColumns -
    // 1.
    void fill(Pixel* colours, int column, int first, int last);

private:
    // Of squares: `first` up to and without `last`, counted from the horizon.
    struct Rows {
        int first;
        int last;
    };
    struct Disc {  // in halves of a square
        int x = 0;
        int y = 0;
        int radius = 0;  // 0 for none
        int glow = 0;
        std::uint32_t perDistance = 0;  // 2^28 / glow^2
        Colour colour;
        bool hasSpots = false;
    };
    static Disc discOf(const SkyDisc& disc);

    void beginColours(const Sky& sky, int rows);
    void beginClouds(const SkyClouds& clouds, std::int64_t steps);
    void fillColours(int column, Rows rows);
    void addStars(int column, Rows rows);
    void addStar(std::uint64_t star, int x, int y, Rows rows);
    void addDisc(const Disc& disc, int column, Rows rows);
    void addClouds(int column, Rows rows);
    static int spotAt(const Disc& disc, int x, int y);
    void layOver(Rows rows);

    const Sky* sky_ = nullptr;
    std::vector<std::uint16_t> skyRows_;  // by row of the picture
    std::vector<int> lastRows_;           // by row of squares: the row behind those of the picture
    std::vector<Pixel> colours_;          // by row of squares, of a sky without a panorama
    std::vector<int> panoramaOffsets_;    // by row of squares: start of the panorama's row
    std::vector<Pixel> squares_;          // of one column
    std::vector<Pixel> layer_;            // what is laid over them next; alpha is its weight
    Disc sun_;
    Disc moon_;
    int density_ = 0;                               // of stars, of 1024
    int brightness_ = 0;                            // of 255
    int threshold_ = 0;                             // density up to which there are no clouds
    int drift_ = 0;                                 // in 1/256 of a column of the clouds' shape
    std::array<std::uint8_t, 256> cloudWeights_{};  // by density
    std::array<Pixel, 16> cloudColours_{};          // from shade to light
    std::vector<int> densities_;                    // of one column, by row of the clouds' shape
};

}  // namespace slicecast

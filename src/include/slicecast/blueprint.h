// A block of a map's legend, as Game::blueprints() tells it. Heights are units above the base of
// the block's level.
#pragma once

#include "slicecast/colour.h"
#include "slicecast/face.h"
#include "slicecast/half.h"

#include <array>
#include <optional>
#include <string>

namespace slicecast {

// How a face looks.
struct FaceLook {
    std::string texture;           // its name; empty where there is no face, as in water
    std::optional<Colour> colour;  // the texture's average; none where all of it is a hole
    double light = 1.0;            // share of the map's light, 0 to 1
    bool glows = false;
    double mirror = 0.0;  // how strongly it mirrors, 0 to 1
};

// The heights of an underside and a top over two edges of the tile: the western and the eastern,
// or, unless `alongX`, the northern and the southern.
struct BlockSlopes {
    bool alongX = true;
    std::array<double, 2> bottom = {};
    std::array<double, 2> top = {};
};

struct Blueprint {
    std::string sign;  // in the rows of cells(), and for setCell()
    std::string name;
    double bottom = 0.0;                // of its lowest point
    double top = 1.0;                   // of its highest point
    std::optional<BlockSlopes> slopes;  // if one of them rises
    double west = 0.0;                  // what it fills of its tile, units from the north-western
    double north = 0.0;                 // corner
    double east = 1.0;
    double south = 1.0;
    Half diagonal = Half::none;          // the half of the tile that it fills
    bool isSeeThrough = false;           // a face has holes or glass
    bool moves = false;                  // setCell() puts neither what moves
    bool isGate = false;                 // nor gates
    std::array<FaceLook, kFaces> faces;  // by Face
};

}  // namespace slicecast

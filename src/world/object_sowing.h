// Objects that are sown over a map rather than placed one by one: trees in a meadow, people in a
// square.
//
// A spot can hold one if it is on the ground that was asked for, its tile is empty from there up to
// the object's top, it is no portal's, nobody starts there and nothing stands there yet. Each tile
// draws its own numbers from the seed and its place: what changes elsewhere on the map, or the
// map's size, does not move what was sown here.
#pragma once

#include "world/blueprint.h"
#include "world/object.h"
#include "world/object_motion.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace slicecast {

struct Map;
struct World;

// Coordinates from `least` to `greatest`, both included.
struct CoordinateRange {
    Coordinate least;
    Coordinate greatest;
};

struct Sowing {
    Object object;         // what is sown; its place and height are found for each
    double density = 0.1;  // share of the spots that can hold one, 0 to 1
    std::uint64_t seed = 1;
    CoordinateRange height;           // units
    CoordinateRange above;            // of the feet over the ground
    bool onFloor = true;              // it grows on the floor
    std::vector<BlueprintId> on;      // and on the roofs of these
    std::vector<TextureId> textures;  // if there are any: only where the ground shows one of them
    Coordinate clear;                 // distance that is kept from the world's start
    std::optional<ObjectMotion> motion;
    bool anyHeading = true;  // each one moves off another way
};

// The spots of a map that hold something.
class TakenSpots {
public:
    // Those of the objects that stand there.
    explicit TakenSpots(const Map& map);

    // False if it was taken already.
    bool take(std::size_t tile, Coordinate feet);

private:
    std::size_t spots_;  // of a tile
    std::vector<bool> taken_;
};

enum class Sown : std::uint8_t { all, tooMany, tooManyMoving };

// Adds to the map's objects, and to what moves. Ends, with part of them added, where they would be
// more than a world may have.
Sown sowObjects(World& world, int map, const Sowing& sowing, TakenSpots& taken);

}  // namespace slicecast

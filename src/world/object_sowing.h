// Objects that are sown over a map at random instead of placed one by one: trees in a meadow,
// people in a square.
//
// A spot can hold an object if it is on the wanted ground and its tile is empty from there up to
// the object's top. No portal may belong to it, nobody may start there, and nothing may stand there
// yet. Each tile draws its own random numbers from the seed and its place. So changes elsewhere on
// the map, or of its size, do not move what was sown here.
#pragma once

#include "world/blueprint.h"
#include "world/object.h"
#include "world/object_motion.h"
#include "world/quest.h"

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
    Object object;         // the object to sow; its place and height vary
    double density = 0.1;  // part of the possible spots that get one, 0 to 1
    std::uint64_t seed = 1;
    CoordinateRange height;           // units
    CoordinateRange above;            // of the feet above the ground
    bool onFloor = true;              // sow on the floor
    std::vector<BlueprintId> on;      // and on the roofs of these blocks
    std::vector<TextureId> textures;  // if not empty: only where the ground shows one of these
    Coordinate clear;                 // distance to keep from the world's start
    std::optional<ObjectMotion> motion;
    bool anyHeading = true;    // each one gets a random heading
    std::optional<Find> find;  // each one is such a find
};

// The spots of a map that are taken.
class TakenSpots {
public:
    // Starts with the spots of the map's objects.
    explicit TakenSpots(const Map& map);

    bool isTaken(std::size_t tile, Coordinate feet) const { return taken_[spotAt(tile, feet)]; }
    void take(std::size_t tile, Coordinate feet) { taken_[spotAt(tile, feet)] = true; }

private:
    std::size_t spotAt(std::size_t tile, Coordinate feet) const;

    std::size_t spots_;  // per tile
    std::vector<bool> taken_;
};

enum class Sown : std::uint8_t { all, tooMany, tooManyMoving, tooManyFinds };

// Sows the map's rows of tiles from `first` to before `end`: adds to the map's objects, to the
// moving ones and to the finds. Stops, with a part of them added, when a limit of the world is
// exceeded.
Sown sowObjects(World& world, int map, const Sowing& sowing, TakenSpots& taken, int first, int end);

}  // namespace slicecast

// How boxes meet solid things. collision.cpp applies it to a map, traveller.cpp to the surroundings
// of a body near portals.
#pragma once

#include "world/collision.h"

#include <cstdint>
#include <optional>
#include <type_traits>

namespace slicecast {

// Higher and deeper than everything, but sums with body heights still fit their type.
inline constexpr Coordinate kBoundless = tileEdge(4096);

// Tiles or levels first .. last, both included; none if last < first.
struct SolidRange {
    int first;
    int last;
};

// The tiles that the open interval low < v < high touches.
constexpr SolidRange reached(Coordinate low, Coordinate high) {
    return {low.tile(), Coordinate{high.raw - 1}.tile()};
}

// A callback. Refers to a function object, which must outlive it.
template <typename... Arguments>
class Visitor {
public:
    template <typename Met>
        requires(!std::is_same_v<Met, Visitor>)
    Visitor(const Met& met)
        : met_(&met), call_([](const void* called, Arguments... arguments) {
              (*static_cast<const Met*>(called))(arguments...);
          }) {}
    void operator()(Arguments... arguments) const { call_(met_, arguments...); }

private:
    const void* met_;
    void (*call_)(const void*, Arguments...);
};

// Whether a box that reaches into tile (x, y) is over a part of the plan there, or under it.
bool isOver(const Plan& plan, int x, int y, const Box& box);

// The slopes of a solid thing, whose heights count from `base`. Between its bottom and its top they
// cut off what is above and below them.
struct SolidSlopes {
    Slopes slopes;
    Coordinate base;
};
inline constexpr SolidSlopes kNoSlopes;

// For a solid thing in a tile: its bottom, its top, what it fills of the tile, and its slopes.
using Meeting = Visitor<Coordinate, Coordinate, const Plan&, const SolidSlopes&>;

// Lists solid things.
class Solids {
public:
    // Calls met(bottom, top, plan, slopes) for the solid things above tile (x, y) that touch the
    // heights from `low` to `high`, and possibly for others; planes have bottom == top.
    virtual void visit(int x, int y, Coordinate low, Coordinate high, Meeting met) const = 0;

protected:
    ~Solids() = default;
};

// A map with its floor, ceiling and outline, and the upper limit of the air.
class MapSolids final : public Solids {
public:
    MapSolids(const World& world, const Map& map, bool floats = false)
        : world_(world), map_(map), floats_(floats) {}
    void visit(int x, int y, Coordinate low, Coordinate high, Meeting met) const override;

private:
    const World& world_;
    const Map& map_;
    bool floats_;  // water counts as solid
};

bool isFreeAmong(const Solids& solids, const Box& box);

// Like the functions of the same names in collision.h, for a box anywhere.
Coordinate sweepXAmong(const Solids& solids, const Box& box, Coordinate distance);
Coordinate sweepYAmong(const Solids& solids, const Box& box, Coordinate distance);
Coordinate sweepZAmong(const Solids& solids, const Box& box, Coordinate distance);
std::optional<Coordinate> leastRiseAmong(const Solids& solids, const Box& box, Coordinate limit);

// Whether only cuts of halves, all alike, stop a box that goes further along an axis: 1 if x and y
// grow together along them, -1 if one grows while the other shrinks, else 0.
int slipAmong(const Solids& solids, const Box& box, Coordinate Offset::*axis, bool isUp);

// Of a box at rest: see fallOf in traveller.h.
struct Fall;
Fall fallAmong(const Solids& solids, const Box& box);

// One part of a slide along one axis, at most kLongestSlide long, over a step if needed. True if it
// got all the way.
bool advanceAmong(const Solids& solids, Slide& state, Coordinate Offset::*axis, Coordinate distance,
                  Coordinate step);

// Part i of a way in `parts` parts.
constexpr Coordinate partOf(Coordinate whole, std::int64_t i, std::int64_t parts) {
    return {static_cast<std::int32_t>(whole.raw * (i + 1) / parts - whole.raw * i / parts)};
}

// The number of parts that keeps each at most kLongestSlide long on both axes.
std::int64_t partsOf(Coordinate distanceX, Coordinate distanceY);

}  // namespace slicecast

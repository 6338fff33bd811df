// What is solid around a body among portals, while its eye stays before, behind or beside the same
// ones (see traveller.h); in the coordinates of its map.
//
// Portals side by side that lead on side by side are one opening: what a body reaches into of it is
// open as a whole.
//
// Each tile is put together from up to three stretches of height: what is behind the threshold that
// the body has come over, what is seen through a portal face, and the map's own. A tile behind a
// threshold or with a portal of its own is of one piece.
#pragma once

#include "world/solids.h"
#include "world/traveller.h"
#include "world/world.h"

namespace slicecast {

// Heights low .. high that show what a portal leads to.
struct Opening {
    const Portal* portal = nullptr;  // null for none
    Coordinate low = kBoundless;
    Coordinate high = kBoundless;
};

// What an eye is right in front of above one tile: in it upwards and downwards, beside it at most
// one.
struct Openings {
    Opening below;  // or beside
    Opening above;
};

// Null for none.
const Portal* portalOf(const World& world, PortalId id);

// The block of a cell if it has portals, or null.
const CellBlueprint* portalBlock(const World& world, const Map& map, int x, int y, int level);

class PortalSolids final : public Solids {
public:
    PortalSolids(const World& world, const Traveller& body)
        : world_(world),
          map_(mapAt(body.map)),
          behind_(body.behind),
          eye_(body.eye),
          eyeTile_{body.eye.x.tile(), body.eye.y.tile()},
          floats_(body.floats) {}

    void visit(int x, int y, Coordinate low, Coordinate high, Meeting met) const override;

private:
    const Map& mapAt(int map) const { return world_.maps[static_cast<std::size_t>(map)]; }
    bool isBehind(int x, int y) const;
    void visitThrough(const Portal& portal, int x, int y, Coordinate from, Coordinate to,
                      Coordinate low, Coordinate high, Meeting met) const;
    Openings openingsAbove(GridTile tile) const;
    Opening openingBeside(GridTile tile, Face side, const Portal* like) const;
    const Portal* portalAt(GridTile tile, Coordinate height, Face face, const Portal& other) const;
    bool leadsOn(const Portal& portal, const FaceBlueprint& face) const;

    const World& world_;
    const Map& map_;
    const Threshold& behind_;
    Position eye_;
    GridTile eyeTile_;
    bool floats_;
};

}  // namespace slicecast

// Finds what is solid around a body near portals, in the coordinates of its map, while its eye
// stays in front of, behind or beside the same portals (see traveller.h).
//
// Adjacent portals that lead to adjacent places are one opening: the body may reach into any part
// of it.
//
// Each tile has up to three height ranges: what is behind the threshold that the body has passed,
// what is behind a portal face, and the map's own. A tile behind a threshold or with a portal of
// its own has only one.
#pragma once

#include "world/solids.h"
#include "world/traveller.h"
#include "world/world.h"

namespace slicecast {

// The heights low .. high that show what is behind a portal.
struct Opening {
    const Portal* portal = nullptr;  // null for none
    Coordinate low = kBoundless;
    Coordinate high = kBoundless;
};

// The openings at a tile that the eye is right in front of: in the eye's tile below and above it,
// in neighbouring tiles at most one.
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
    Openings findOpeningsOfEye() const;
    const Openings& openingsOfEye() const {
        if (!ofEye_) ofEye_ = findOpeningsOfEye();
        return *ofEye_;
    }
    Opening openingBeside(GridTile tile, Face side, const Portal* like) const;
    const Portal* portalAt(GridTile tile, Coordinate height, Face face, const Portal& other) const;
    bool leadsOn(const Portal& portal, const FaceBlueprint& face) const;

    const World& world_;
    const Map& map_;
    const Threshold& behind_;
    Position eye_;
    GridTile eyeTile_;
    bool floats_;
    mutable std::optional<Openings> ofEye_;  // once it is known
};

}  // namespace slicecast

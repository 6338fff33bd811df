#include "world/portal_solids.h"

#include <algorithm>

namespace slicecast {
namespace {

// The side of a tile that faces a neighbour; nothing for tiles without a common side.
std::optional<Face> sideTowards(GridTile tile, GridTile other) {
    const int x = other.x - tile.x;
    const int y = other.y - tile.y;
    if (x == 0 && y == -1) return Face::north;
    if (x == 1 && y == 0) return Face::east;
    if (x == 0 && y == 1) return Face::south;
    if (x == -1 && y == 0) return Face::west;
    return std::nullopt;
}

// Calls met() for the part of a solid thing between two heights, including planes at these heights.
void meet(Coordinate bottom, Coordinate top, const Plan& plan, const SolidSlopes& slopes,
          Coordinate low, Coordinate high, Meeting met) {
    const Coordinate from = std::max(bottom, low);
    const Coordinate to = std::min(top, high);
    if (from < to || (bottom == top && from == to)) met(from, to, plan, slopes);
}

}  // namespace

const Portal* portalOf(const World& world, PortalId id) {
    return id == kNoPortal ? nullptr : &world.portals[id];
}

const CellBlueprint* portalBlock(const World& world, const Map& map, int x, int y, int level) {
    const BlueprintId id = map.cell(x, y, level);
    return id != kEmptyCell && world.blueprints[id].hasPortals ? &world.blueprints[id] : nullptr;
}

void PortalSolids::visit(int x, int y, Coordinate low, Coordinate high, Meeting met) const {
    // Behind the threshold
    Coordinate from = {-kBoundless.raw};
    Coordinate to = kBoundless;
    if (behind_.isOn) {
        if (isBehind(x, y)) return visitThrough(behind_.back, x, y, from, to, low, high, met);
        if (behind_.side == Face::top) {
            to = behind_.height;
            visitThrough(behind_.back, x, y, to, kBoundless, low, high, met);
        } else if (behind_.side == Face::bottom) {
            from = behind_.height;
            visitThrough(behind_.back, x, y, Coordinate{-kBoundless.raw}, from, low, high, met);
        }
    }
    // Through a tile
    const GridTile tile = {x, y};
    const Portal* portal = tile == eyeTile_ ? nullptr : portalOf(world_, map_.tilePortal(x, y));
    if (portal != nullptr) return visitThrough(*portal, x, y, from, to, low, high, met);
    // Through faces
    const Openings openings = openingsAbove(tile);
    const auto clipped = [&](Coordinate bottom, Coordinate top, const Plan& plan,
                             const SolidSlopes& slopes) {
        const Opening& a = openings.below;
        const Opening& b = openings.above;
        if (a.portal == nullptr && b.portal == nullptr)
            return meet(bottom, top, plan, slopes, from, to, met);
        if (a.portal != nullptr) meet(bottom, top, plan, slopes, from, std::min(to, a.low), met);
        const Coordinate middle = a.portal != nullptr ? std::max(from, a.high) : from;
        meet(bottom, top, plan, slopes, middle, b.portal != nullptr ? std::min(to, b.low) : to,
             met);
        if (b.portal != nullptr) meet(bottom, top, plan, slopes, std::max(from, b.high), to, met);
    };
    MapSolids(world_, map_, floats_).visit(x, y, low, high, clipped);
    for (const Opening& opening : {openings.below, openings.above}) {
        if (opening.portal == nullptr) continue;
        visitThrough(*opening.portal, x, y, std::max(from, opening.low), std::min(to, opening.high),
                     low, high, met);
    }
}

bool PortalSolids::isBehind(int x, int y) const {
    switch (behind_.side) {
        case Face::north:
            return y < behind_.back.fromY;
        case Face::east:
            return x > behind_.back.fromX;
        case Face::south:
            return y > behind_.back.fromY;
        case Face::west:
            return x < behind_.back.fromX;
        default:
            return false;
    }
}

void PortalSolids::visitThrough(const Portal& portal, int x, int y, Coordinate from, Coordinate to,
                                Coordinate low, Coordinate high, Meeting met) const {
    if (from >= to) return;
    const GridTile tile = carried(portal, GridTile{x, y});
    const Coordinate shift = tileEdge(portal.levels);
    MapSolids(world_, mapAt(portal.toMap), floats_)
        .visit(tile.x, tile.y, low + shift, high + shift,
               [&](Coordinate bottom, Coordinate top, const Plan& plan, const SolidSlopes& slopes) {
                   const int back = (4 - portal.turn) % 4;
                   meet(bottom - shift, top - shift, turned(plan, back),
                        {turned(slopes.slopes, back), slopes.base - shift}, from, to, met);
               });
}

// In the eye's tile: down to the next block and up to the next one.
Openings PortalSolids::findOpeningsOfEye() const {
    Openings openings;
    for (int level = std::min(eye_.z.tile(), map_.levels - 1); level >= 0; --level) {
        if (!map_.isOccupied(eyeTile_.x, eyeTile_.y, level)) continue;
        const CellBlueprint& block = world_.blueprints[map_.cell(eyeTile_.x, eyeTile_.y, level)];
        const Coordinate top = tileEdge(level) + block.top;
        if (top > eye_.z || block.isWater) continue;
        openings.below = {portalOf(world_, block.face(Face::top).portal), {-kBoundless.raw}, top};
        break;
    }
    for (int level = std::max(eye_.z.tile(), 0); level < map_.levels; ++level) {
        if (!map_.isOccupied(eyeTile_.x, eyeTile_.y, level)) continue;
        const CellBlueprint& block = world_.blueprints[map_.cell(eyeTile_.x, eyeTile_.y, level)];
        const Coordinate bottom = tileEdge(level) + block.bottom;
        if (bottom <= eye_.z || block.isWater) continue;
        openings.above = {portalOf(world_, block.face(Face::bottom).portal), bottom, kBoundless};
        break;
    }
    return openings;
}

Openings PortalSolids::openingsAbove(GridTile tile) const {
    if (tile == eyeTile_) return openingsOfEye();
    Openings openings;
    // Beside the eye, or beside such a tile if both lead to adjacent places
    const GridTile across = {tile.x, eyeTile_.y};
    const GridTile along = {eyeTile_.x, tile.y};
    if (const std::optional<Face> side = sideTowards(tile, eyeTile_)) {
        openings.below = openingBeside(tile, *side, nullptr);
    } else {
        for (const GridTile between : {across, along}) {
            const std::optional<Face> towardsEye = sideTowards(between, eyeTile_);
            if (!towardsEye || !sideTowards(between, tile)) continue;
            const Portal* const neighbour = openingBeside(between, *towardsEye, nullptr).portal;
            if (neighbour != nullptr && openings.below.portal == nullptr)
                openings.below = openingBeside(tile, *towardsEye, neighbour);
        }
    }
    if (openings.below.portal != nullptr) return openings;
    // Beside a top or bottom face that the eye is above or below
    const Openings& ofEye = openingsOfEye();
    if (ofEye.below.portal != nullptr)
        openings.below = {portalAt(tile, ofEye.below.high, Face::top, *ofEye.below.portal),
                          ofEye.below.low, ofEye.below.high};
    if (ofEye.above.portal != nullptr)
        openings.above = {portalAt(tile, ofEye.above.low, Face::bottom, *ofEye.above.portal),
                          ofEye.above.low, ofEye.above.high};
    return openings;
}

// The opening of a side at the eye's height, extended by adjacent blocks above and below that lead
// on alike; with `like`, only if it leads on as that portal.
Opening PortalSolids::openingBeside(GridTile tile, Face side, const Portal* like) const {
    const int eyeLevel = eye_.z.tile();
    const CellBlueprint* block = portalBlock(world_, map_, tile.x, tile.y, eyeLevel);
    if (block == nullptr) return {};
    const Portal* const portal = portalOf(world_, block->face(side).portal);
    Opening opening = {portal, tileEdge(eyeLevel) + block->bottom, tileEdge(eyeLevel) + block->top};
    if (portal == nullptr || eye_.z < opening.low || eye_.z >= opening.high ||
        (like != nullptr && !leadOnTogether(*like, *portal)))
        return {};
    for (int level = eyeLevel + 1; opening.high == tileEdge(level); ++level) {
        block = portalBlock(world_, map_, tile.x, tile.y, level);
        if (block == nullptr || block->bottom.raw != 0 || !leadsOn(*portal, block->face(side)))
            break;
        opening.high = tileEdge(level) + block->top;
    }
    for (int level = eyeLevel - 1; opening.low == tileEdge(level + 1); --level) {
        block = portalBlock(world_, map_, tile.x, tile.y, level);
        if (block == nullptr || block->top != tileEdge(1) || !leadsOn(*portal, block->face(side)))
            break;
        opening.low = tileEdge(level) + block->bottom;
    }
    return opening;
}

// The portal of a top or bottom face at this height, if it leads on like `other`.
const Portal* PortalSolids::portalAt(GridTile tile, Coordinate height, Face face,
                                     const Portal& other) const {
    const int level = face == Face::top ? Coordinate{height.raw - 1}.tile() : height.tile();
    const CellBlueprint* block = portalBlock(world_, map_, tile.x, tile.y, level);
    if (block == nullptr ||
        tileEdge(level) + (face == Face::top ? block->top : block->bottom) != height)
        return nullptr;
    return leadsOn(other, block->face(face)) ? portalOf(world_, block->face(face).portal) : nullptr;
}

bool PortalSolids::leadsOn(const Portal& portal, const FaceBlueprint& face) const {
    return face.portal != kNoPortal && leadOnTogether(portal, world_.portals[face.portal]);
}

}  // namespace slicecast

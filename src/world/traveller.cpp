#include "world/traveller.h"

#include "world/portal_solids.h"

#include <cstdlib>

namespace slicecast {
namespace {

constexpr Coordinate kTiniest = {1};

bool isThere(const World& world, const Traveller& body) {
    return body.map >= 0 && static_cast<std::size_t>(body.map) < world.maps.size();
}

const Map& mapOf(const World& world, const Traveller& body) {
    return world.maps[static_cast<std::size_t>(body.map)];
}

GridTile tileOf(const Position& place) {
    return {place.x.tile(), place.y.tile()};
}

// Forgets the threshold when no part of the box is beyond it any more.
void leaveThreshold(Traveller& body) {
    if (!body.behind.isOn) return;
    const Portal& back = body.behind.back;
    const Box& box = body.box;
    bool reaches = false;
    switch (body.behind.side) {
        case Face::north:
            reaches = box.north < tileEdge(back.fromY);
            break;
        case Face::east:
            reaches = box.east > tileEdge(back.fromX + 1);
            break;
        case Face::south:
            reaches = box.south > tileEdge(back.fromY + 1);
            break;
        case Face::west:
            reaches = box.west < tileEdge(back.fromX);
            break;
        case Face::top:
            reaches = box.top > body.behind.height;
            break;
        case Face::bottom:
            reaches = box.bottom < body.behind.height;
            break;
    }
    if (!reaches) body.behind = {};
}

// Carries a body whose eye has just passed a portal by that side. Returns how far the place was
// moved into the exit tile (see keptInside).
Offset passPortal(Traveller& body, const Portal& portal, Face side, Coordinate height) {
    const Position middle = body.eye;
    const Position carriedEye = carried(portal, middle);
    const Position kept = keptInside({portal.toX, portal.toY}, carriedEye);
    // The box turns about the eye
    Coordinate halfX = body.box.east - middle.x;
    Coordinate halfY = body.box.south - middle.y;
    if (portal.turn % 2 != 0) std::swap(halfX, halfY);
    const Coordinate lift = tileEdge(portal.levels);
    body.box = {kept.x - halfX, kept.x + halfX,         kept.y - halfY,
                kept.y + halfY, body.box.bottom + lift, body.box.top + lift};
    body.eye = kept;
    body.map = portal.toMap;
    body.behind = {.isOn = true,
                   .back = reversed(portal),
                   .side = turned(side, portal.turn),
                   .height = height + lift};
    body.turn = (body.turn + portal.turn) % 4;
    ++body.leaps;
    return {.x = kept.x - carriedEye.x, .y = kept.y - carriedEye.y, .z = {}};
}

// The portal face of a block through which an eye has just come.
struct EnteredFace {
    const Portal* portal = nullptr;
    Coordinate low;  // of the block
    Coordinate high;
};

EnteredFace enteredFace(const World& world, const Map& map, const Position& eye, Face face) {
    const int level = eye.z.tile();
    const CellBlueprint* block = portalBlock(world, map, eye.x.tile(), eye.y.tile(), level);
    if (block == nullptr) return {};
    const Coordinate low = tileEdge(level) + block->bottom;
    const Coordinate high = tileEdge(level) + block->top;
    if (eye.z < low || eye.z >= high) return {};
    return {portalOf(world, block->face(face).portal), low, high};
}

// Updates a body whose eye has entered the next tile by that side.
Offset enterTile(const World& world, Traveller& body, GridTile left, Face side) {
    const Map& map = mapOf(world, body);
    const GridTile tile = tileOf(body.eye);
    const Portal* portal = portalOf(world, map.tilePortal(tile.x, tile.y));
    if (portal == nullptr) portal = enteredFace(world, map, body.eye, side).portal;
    if (portal != nullptr) return passPortal(body, *portal, side, {});
    body.behind = {};
    // Parts that are still in a portal's tile after the eye has left it stay there
    if (map.tilePortal(left.x, left.y) != kNoPortal)
        body.behind = {
            .isOn = true, .back = identityPortal(body.map, tile), .side = side, .height = {}};
    return {};
}

// Updates a body whose eye has crossed an edge of a portal's block, or its threshold, upwards or
// downwards.
void passEdge(const World& world, Traveller& body, Coordinate before) {
    const bool down = body.eye.z < before;
    const Face side = down ? Face::top : Face::bottom;
    const EnteredFace entered = enteredFace(world, mapOf(world, body), body.eye, side);
    const bool isNew = down ? before >= entered.high : before < entered.low;
    if (entered.portal != nullptr && isNew) {
        passPortal(body, *entered.portal, side, down ? entered.high : entered.low);
        return;
    }
    if (!body.behind.isOn) return;
    const bool isBack = body.behind.side == Face::top ? !down && body.eye.z >= body.behind.height
                                                      : body.behind.side == Face::bottom && down &&
                                                            body.eye.z < body.behind.height;
    if (isBack) body.behind = {};
}

// How far the eye can move up or down, at most `distance`, while it stays in front of, behind and
// beside the same portals.
Coordinate roomForEye(const World& world, const Traveller& body, Coordinate distance) {
    Coordinate room = distance;
    const Coordinate eye = body.eye.z;
    const auto edgeAt = [&](Coordinate edge) {
        if (distance.raw > 0 && edge > eye) room = std::min(room, edge - kTiniest - eye);
        if (distance.raw < 0 && edge <= eye) room = std::max(room, edge - eye);
    };
    if (body.behind.isOn && (body.behind.side == Face::top || body.behind.side == Face::bottom))
        edgeAt(body.behind.height);
    const Map& map = mapOf(world, body);
    const GridTile here = tileOf(body.eye);
    const int first = std::max(0, std::min(eye, eye + distance).tile() - 1);
    const int last = std::min(map.levels - 1, std::max(eye, eye + distance).tile());
    for (int y = here.y - 1; y <= here.y + 1; ++y) {
        for (int x = here.x - 1; x <= here.x + 1; ++x) {
            for (int level = first; level <= last; ++level) {
                const CellBlueprint* block = portalBlock(world, map, x, y, level);
                if (block == nullptr) continue;
                edgeAt(tileEdge(level) + block->bottom);
                edgeAt(tileEdge(level) + block->top);
            }
        }
    }
    return room;
}

// Accepts the new state of the body if it has room, over a step if needed.
bool arrive(const World& world, Traveller& body, const Traveller& candidate, Coordinate step,
            Coordinate& risen) {
    const PortalSolids solids(world, candidate);
    const std::optional<Coordinate> rise = leastRiseAmong(solids, candidate.box, step);
    if (!rise) return false;
    body = candidate;
    if (rise->raw > 0) {
        body.box = moved(body.box, {.x = {}, .y = {}, .z = *rise});
        risen = risen + *rise;
    }
    return true;
}

// A way along one axis of the ground.
struct Stretch {
    Coordinate x;
    Coordinate y;

    bool isAlongX() const { return x.raw != 0; }
    Coordinate length() const { return isAlongX() ? x : y; }
};

// One part of a slide. Goes through everything on the way: each time to the border of the eye's
// tile, then over it. Returns what is left of the way when something stops it.
Stretch go(const World& world, Traveller& body, Stretch way, Coordinate step, Travelled& done) {
    while (way.length().raw != 0) {
        const bool alongX = way.isAlongX();
        const auto axis = alongX ? &Offset::x : &Offset::y;
        const Coordinate all = way.length();
        const bool ahead = all.raw > 0;
        const GridTile tile = tileOf(body.eye);
        Coordinate& eye = alongX ? body.eye.x : body.eye.y;
        const int index = alongX ? tile.x : tile.y;
        const Coordinate room =
            ahead ? tileEdge(index + 1) - kTiniest - eye : tileEdge(index) - eye;
        const bool crosses = ahead ? all > room : all < room;
        const Coordinate part = crosses ? room : all;

        // Within the tile
        if (part.raw != 0) {
            const PortalSolids solids(world, body);
            Slide state;
            state.box = body.box;
            const bool whole = advanceAmong(solids, state, axis, part, step);
            const Coordinate gone =
                alongX ? state.box.west - body.box.west : state.box.north - body.box.north;
            eye = eye + gone;
            body.box = state.box;
            done.rise = done.rise + state.rise;
            if (!whole) {
                (alongX ? way.x : way.y) = all - gone;
                leaveThreshold(body);
                return way;
            }
        }
        leaveThreshold(body);
        if (!crosses) return {};

        // Over its border
        Offset over;
        over.*axis = ahead ? kTiniest : Coordinate{-1};
        Traveller candidate = body;
        candidate.box = moved(candidate.box, over);
        candidate.eye.x = candidate.eye.x + over.x;
        candidate.eye.y = candidate.eye.y + over.y;
        const Face side =
            alongX ? (ahead ? Face::west : Face::east) : (ahead ? Face::north : Face::south);
        const Offset inwards = enterTile(world, candidate, tile, side);
        const int turn = (candidate.turn - body.turn + 4) % 4;
        if (!arrive(world, body, candidate, step, done.rise)) {
            (alongX ? way.x : way.y) = all - part;
            return way;
        }
        way.x = way.x - part - over.x;
        way.y = {};
        if (!alongX) way = {.x = {}, .y = all - part - over.y};
        turnArrow(turn, way.x, way.y);
        if (turn % 2 != 0) {
            std::swap(done.stoppedX, done.stoppedY);
            done.slip = -done.slip;
        }
        if (way.x.raw != 0) way.x = way.x - inwards.x;
        if (way.y.raw != 0) way.y = way.y - inwards.y;
    }
    return {};
}

// The same, and along the cuts of halves.
void goOrSlip(const World& world, Traveller& body, Stretch way, Coordinate step, Travelled& done) {
    const Stretch left = go(world, body, way, step, done);
    if (left.length().raw == 0) return;
    const bool alongX = left.isAlongX();
    const int slip = slipAmong(PortalSolids(world, body), body.box,
                               alongX ? &Offset::x : &Offset::y, left.length().raw > 0);
    bool& stopped = alongX ? done.stoppedX : done.stoppedY;
    stopped = stopped || slip == 0 || done.slip == -slip;
    if (slip == 0) return;
    done.slip = slip;
    const Coordinate half = {left.length().raw / 2};
    Coordinate x = alongX ? Coordinate{} : Coordinate{slip * half.raw};
    Coordinate y = alongX ? Coordinate{slip * half.raw} : Coordinate{};
    const int before = body.turn;
    go(world, body, {x, y}, step, done);
    x = alongX ? half : Coordinate{};
    y = alongX ? Coordinate{} : half;
    turnArrow((body.turn - before + 4) % 4, x, y);
    go(world, body, {x, y}, step, done);
}

}  // namespace

bool isFree(const World& world, const Traveller& body) {
    if (!isThere(world, body)) return false;
    return world.portals.empty() ? isFree(world, body.map, body.box, body.floats)
                                 : isFreeAmong(PortalSolids(world, body), body.box);
}

Coordinate sweepZ(const World& world, const Traveller& body, Coordinate distance) {
    if (!isThere(world, body)) return {};
    return world.portals.empty() ? sweepZ(world, body.map, body.box, distance, body.floats)
                                 : sweepZAmong(PortalSolids(world, body), body.box, distance);
}

Coordinate sweepSideways(const World& world, const Traveller& body, Axis axis,
                         Coordinate distance) {
    if (!isThere(world, body)) return {};
    const auto among = [&](const Solids& solids) {
        return axis == Axis::x ? sweepXAmong(solids, body.box, distance)
                               : sweepYAmong(solids, body.box, distance);
    };
    return world.portals.empty() ? among(MapSolids(world, mapOf(world, body), body.floats))
                                 : among(PortalSolids(world, body));
}

bool isSupported(const World& world, const Traveller& body) {
    return sweepZ(world, body, {-1}).raw == 0;
}

Fall fallOf(const World& world, const Traveller& body) {
    return isThere(world, body) ? fallAmong(PortalSolids(world, body), body.box) : Fall{};
}

Travelled slide(const World& world, Traveller& body, Coordinate distanceX, Coordinate distanceY,
                Coordinate step) {
    if (!isThere(world, body)) return {};
    if (world.portals.empty()) {
        const Slide way = slide(world, body.map, body.box, distanceX, distanceY, step, body.floats);
        body.eye.x = body.eye.x + way.box.west - body.box.west;
        body.eye.y = body.eye.y + way.box.north - body.box.north;
        body.box = way.box;
        return {
            .rise = way.rise, .stoppedX = way.stoppedX, .stoppedY = way.stoppedY, .slip = way.slip};
    }
    Travelled done;
    const int before = body.turn;
    const std::int64_t parts = partsOf(distanceX, distanceY);
    for (std::int64_t i = 0; i < parts; ++i) {
        const auto walk = [&](Coordinate x, Coordinate y) {
            turnArrow((body.turn - before + 4) % 4, x, y);
            goOrSlip(world, body, {x, y}, step, done);
        };
        walk(partOf(distanceX, i, parts), {});
        walk({}, partOf(distanceY, i, parts));
    }
    return done;
}

bool rise(const World& world, Traveller& body, Coordinate distance) {
    if (!isThere(world, body)) return false;
    Coordinate left = distance;
    for (;;) {
        const Coordinate room = world.portals.empty() ? left : roomForEye(world, body, left);
        const Coordinate way = sweepZ(world, body, room);
        body.box = moved(body.box, {.x = {}, .y = {}, .z = way});
        body.eye.z = body.eye.z + way;
        leaveThreshold(body);
        left = left - way;
        if (way != room) return false;
        if (left.raw == 0) return true;

        // Over an edge
        const Coordinate over = left.raw > 0 ? kTiniest : Coordinate{-1};
        Traveller candidate = body;
        candidate.box = moved(candidate.box, {.x = {}, .y = {}, .z = over});
        candidate.eye.z = candidate.eye.z + over;
        passEdge(world, candidate, body.eye.z);
        Coordinate none;
        if (!arrive(world, body, candidate, {}, none)) return false;
        left = left - over;
    }
}

bool moveEye(const World& world, Traveller& body, Coordinate distance) {
    if (!isThere(world, body)) return false;
    Coordinate left = distance;
    for (;;) {
        const Coordinate room = world.portals.empty() ? left : roomForEye(world, body, left);
        body.eye.z = body.eye.z + room;
        left = left - room;
        if (left.raw == 0) return true;

        const Coordinate over = left.raw > 0 ? kTiniest : Coordinate{-1};
        Traveller candidate = body;
        candidate.eye.z = candidate.eye.z + over;
        passEdge(world, candidate, body.eye.z);
        Coordinate none;
        if (!arrive(world, body, candidate, {}, none)) return false;
        leaveThreshold(body);
        left = left - over;
    }
}

}  // namespace slicecast

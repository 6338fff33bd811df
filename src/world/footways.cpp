#include "world/footways.h"

#include "base/sort.h"
#include "world/player.h"
#include "world/portal_solids.h"
#include "world/water.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace slicecast {
namespace {

// Behind so many tiles even a fall through all levels has ended.
constexpr int kLongestJump = 16;

// How much higher than where it jumped a running body is behind so many tiles, at most.
constexpr Coordinate heightBehind(int tiles) {
    const double seconds = tiles / (kWalkingPace.move * kWalkingPace.fast);
    const double rising = kJumpSpeed / kGravity;
    const double falling = std::max(0.0, seconds - rising);
    constexpr double kRounding = 1.0 / 1024.0;  // of all steps together
    return toCoordinate(kJumpSpeed * rising / 2.0 + kRounding - kGravity / 2.0 * falling * falling);
}

// What a cell is to bodies in its tile.
struct CellPart {
    std::optional<RoomHeights> solid = {};  // ends rooms
    std::optional<RoomHeights> climb = {};  // who gets as high as the low end gets to the high end
    std::optional<RoomHeights> wall = {};   // where it closes those sides that its plan fills
};

// From where to where a mover lifts people.
RoomHeights rideOn(const World& world, const CellBlueprint& block, BlueprintId id, int level) {
    const Mover& mover = world.movers[static_cast<std::size_t>(block.mover)];
    const Motion& motion = world.motions[static_cast<std::size_t>(mover.motion)];
    const Coordinate top = tileEdge(level) + block.top;
    if (motion.isSideways()) return {top, top};
    for (const Shaft& shaft : mover.shafts) {
        if (id < shaft.firstPart || id > shaft.firstPart + (shaft.last - shaft.first)) continue;
        const auto [least, most] = std::minmax(motion.from, motion.to);
        const Coordinate highest =
            motion.edges == MovingEdges::low ? shaft.high : shaft.high + most;
        if (block.isWater) return {shaft.low + std::min(least, Coordinate{0}), highest};
        return {motion.edges == MovingEdges::low ? shaft.high : shaft.high + least, highest};
    }
    return {top, top};
}

CellPart partAt(const World& world, const Map& map, int x, int y, int level,
                const std::vector<bool>& isShut) {
    const BlueprintId id = map.cells[map.cellIndex(x, y, level)];
    const CellBlueprint& block = world.blueprints[id];
    const Coordinate base = tileEdge(level);
    const RoomHeights whole = {base + block.bottom, base + block.top};
    int gate = block.gateIndex;
    if (block.mover >= 0) gate = world.movers[static_cast<std::size_t>(block.mover)].gate;
    const bool isShutGate = gate >= 0 && isShut[static_cast<std::size_t>(gate)];
    if (!isShutGate) {
        if (block.mover >= 0) return {.climb = rideOn(world, block, id, level)};
        if (gate >= 0) return {.climb = RoomHeights{whole.high, whole.high}};
    }
    if (!map.isOccupied(x, y, level)) return {};
    if (block.isWater) return {.climb = whole};
    const Slopes& slopes = block.slopes;
    if (!block.plan.isWhole()) {
        return {.climb = RoomHeights{slopes.any() ? whole.low : whole.high, whole.high},
                .wall = slopes.any() ? std::nullopt : std::optional(whole)};
    }
    if (!slopes.any()) return {.solid = whole};
    CellPart part;
    const bool isSteep = std::abs(slopes.top.rise()) > kSteepest.raw;
    part.climb = {base + (isSteep ? slopes.top.most() : slopes.top.least()),
                  base + slopes.top.most()};
    const RoomHeights core = {base + slopes.bottom.most(), base + slopes.top.least()};
    if (core.low < core.high) part.solid = core;
    return part;
}

// The sides of its tile that a plan fills.
unsigned sidesOf(const Plan& plan) {
    unsigned sides = 0;
    const auto add = [&](Face side, bool isFilled) {
        if (isFilled) sides |= 1u << static_cast<unsigned>(side);
    };
    if (plan.half != Half::none) {
        for (const Face side : {Face::north, Face::east, Face::south, Face::west})
            add(side, hasSide(plan.half, side));
        return sides;
    }
    const bool isWide = plan.west == Coordinate{0} && plan.east == tileEdge(1);
    const bool isDeep = plan.north == Coordinate{0} && plan.south == tileEdge(1);
    add(Face::north, isWide && plan.north == Coordinate{0});
    add(Face::east, isDeep && plan.east == tileEdge(1));
    add(Face::south, isWide && plan.south == tileEdge(1));
    add(Face::west, isDeep && plan.west == Coordinate{0});
    return sides;
}

// The highest feet, at most `feet`, of a body that passes between two heights and between walls.
std::optional<Coordinate> passage(RoomHeights open, Coordinate feet,
                                  std::vector<RoomHeights>& walls) {
    mergeSort(walls, [](const RoomHeights& a, const RoomHeights& b) { return a.low < b.low; });
    walls.push_back({open.high, open.high});
    std::optional<Coordinate> found;
    for (const RoomHeights& wall : walls) {
        const Coordinate highest = std::min(wall.low, open.high) - kCrouchedHeight;
        if (open.low <= feet && open.low <= highest) found = std::min(feet, highest);
        open.low = std::max(open.low, wall.high);
    }
    return found;
}

struct NextTile {
    int x;
    int y;
    Face out;  // the side of the tile that leads there
    Face in;   // the side of that tile
};
constexpr NextTile kNextTiles[] = {{1, 0, Face::east, Face::west},
                                   {-1, 0, Face::west, Face::east},
                                   {0, 1, Face::south, Face::north},
                                   {0, -1, Face::north, Face::south}};

}  // namespace

Footways::Footways(const World& world) : Footways(world, std::numeric_limits<std::int64_t>::max()) {
    while (next()) {
    }
}

Footways::Footways(const World& world, std::int64_t mostPlaces)
    : world_(world),
      isShut_(world.gates.size()),
      isMoving_(world.quest.finds.size()),
      hasMovers_(world.maps.size()),
      places_(mostPlaces) {
    for (std::size_t i = 0; i < world.gates.size(); ++i)
        isShut_[i] = !world.gateKinds[static_cast<std::size_t>(world.gates[i].kind)].startsOpen;
    for (const ObjectMotion& motion : world.movingObjects.motions) {
        hasMovers_[static_cast<std::size_t>(motion.map)] = true;
        for (std::size_t i = 0; i < isMoving_.size(); ++i) {
            const Find& find = world.quest.finds[i];
            if (find.map == motion.map && find.object == motion.object) isMoving_[i] = true;
        }
    }
    begin();
}

// Forgets what can be reached, to find it anew while those gates are shut.
void Footways::begin() {
    constexpr std::int64_t kTilesOfPlace = 64;  // that take the time of a place, without a look
    std::int64_t tiles = 0;
    for (const Map& map : world_.maps) tiles += static_cast<std::int64_t>(map.occupied.size());
    places_ -= tiles / kTilesOfPlace;
    if (gaveUp()) return;
    grids_.assign(world_.maps.size(), {});
    for (std::size_t map = 0; map < grids_.size(); ++map)
        grids_[map].columns.resize(world_.maps[map].occupied.size());
    const Start& start = world_.start;
    arrive(start.map, start.x.tile(), start.y.tile(), start.z, kMaxBodyHeight, start.z);
}

bool Footways::next() {
    constexpr int kPlacesOfTask = 16;
    for (int i = 0; i < kPlacesOfTask && !waiting_.empty(); ++i) {
        const Spot spot = waiting_.top();
        waiting_.pop();
        if (spot.feet != roomAt(spot).feet) continue;  // it is listed higher, too
        if (--places_ < 0) return false;
        jumpFrom(spot);
        goThroughEnds(spot);
    }
    if (!waiting_.empty()) return true;
    if (gaveUp() || !openMore()) return false;
    begin();
    return true;
}

// Opens the gates that open by now. False if there are no more.
bool Footways::openMore() {
    std::vector<std::size_t> opening;
    for (std::size_t i = 0; i < isShut_.size(); ++i) {
        if (isShut_[i] && canOpen(world_.gates[i])) opening.push_back(i);
    }
    for (const std::size_t gate : opening) isShut_[gate] = false;
    return !opening.empty();
}

bool Footways::canOpen(const Gate& gate) const {
    const GateKind& kind = world_.gateKinds[static_cast<std::size_t>(gate.kind)];
    if (!kind.needs.none() && !canHold(kind.needs)) return false;
    if (kind.everySteps > 0 || isMet(gate)) return true;
    if (kind.opensOnApproach && hasMovers_[static_cast<std::size_t>(gate.map)]) return true;
    for (std::size_t i = 0; i < isShut_.size(); ++i) {
        if (!isShut_[i] && std::find(kind.follows.begin(), kind.follows.end(),
                                     world_.gates[i].kind) != kind.follows.end())
            return true;
    }
    return false;
}

bool Footways::canHold(const Needs& needs) const {
    const Quest& quest = world_.quest;
    std::vector<int> taken(quest.kinds.size());
    int all = 0;
    for (std::size_t i = 0; i < quest.finds.size(); ++i) {
        if (!takes(i)) continue;
        ++taken[quest.finds[i].kind];
        ++all;
    }
    return all >= needs.any &&
           std::all_of(needs.kinds.begin(), needs.kinds.end(), [&](const NeededKind& needed) {
               return taken[needed.kind] >= needed.count;
           });
}

// Looks at a tile when somebody comes near for the first time.
const Footways::Column& Footways::columnAt(int mapIndex, int x, int y) {
    const Map& map = world_.maps[static_cast<std::size_t>(mapIndex)];
    const std::size_t tile = map.tileIndex(x, y);
    Grid& grid = grids_[static_cast<std::size_t>(mapIndex)];
    Column& column = grid.columns[tile];
    if (column.isKnown) return column;
    column = {.isKnown = true,
              .firstRoom = static_cast<std::uint32_t>(grid.rooms.size()),
              .firstClimb = static_cast<std::uint32_t>(grid.climbs.size()),
              .firstWall = static_cast<std::uint32_t>(grid.walls.size())};
    std::vector<RoomHeights> solids;
    for (int level = 0; level < map.levels; ++level) {
        const CellPart part = partAt(world_, map, x, y, level, isShut_);
        if (part.solid) solids.push_back(*part.solid);
        if (part.climb) grid.climbs.push_back(*part.climb);
        if (part.wall) {
            const Plan& plan = world_.blueprints[map.cell(x, y, level)].plan;
            grid.walls.push_back({*part.wall, sidesOf(plan)});
        }
    }
    const Ceiling& ceiling = map.ceiling;
    if (!ceiling.tiles.empty() && ceiling.tiles[tile] != kNoTexture)
        solids.push_back({ceiling.height, ceiling.height});
    mergeSort(solids, [](const RoomHeights& a, const RoomHeights& b) { return a.low < b.low; });
    solids.push_back({kMaxBodyHeight, kMaxBodyHeight});
    Coordinate ground = {map.isWaterFloor(tile) ? -kFloorWade.raw : 0};
    for (const RoomHeights& solid : solids) {
        if (solid.low - ground >= kCrouchedHeight)
            grid.rooms.push_back({.ground = ground, .above = solid.low});
        ground = std::max(ground, solid.high);
    }
    column.rooms = static_cast<std::uint32_t>(grid.rooms.size()) - column.firstRoom;
    column.climbs = static_cast<std::uint32_t>(grid.climbs.size()) - column.firstClimb;
    column.walls = static_cast<std::uint32_t>(grid.walls.size()) - column.firstWall;
    return column;
}

// Adds the heights at which a side of a spot's tile is closed.
void Footways::addWalls(const Spot& spot, Face side, std::vector<RoomHeights>& walls) {
    const Column& column = columnAt(spot.map, spot.x, spot.y);
    const Grid& grid = grids_[static_cast<std::size_t>(spot.map)];
    for (const Wall& wall : std::span(grid.walls).subspan(column.firstWall, column.walls)) {
        if ((wall.sides >> static_cast<unsigned>(side) & 1u) != 0) walls.push_back(wall.heights);
    }
}

// Puts a body into the rooms of a tile, with its feet there or lower.
void Footways::arrive(int map, int x, int y, Coordinate low, Coordinate high, Coordinate feet) {
    const Column column = columnAt(map, x, y);
    for (std::size_t i = 0; i < column.rooms; ++i) {
        const Spot spot = {map, x, y, column.firstRoom + i};
        const Room& room = roomAt(spot);
        std::vector<RoomHeights> walls;
        const auto passed =
            passage({std::max(low, room.ground), std::min(high, room.above)}, feet, walls);
        // It may have come with a jump, so it goes on as if it stood there
        if (passed) stand(spot, *passed, *passed);
    }
}

// Notes that a body's feet get there, and how high it can stand then; at least at `least`.
void Footways::stand(const Spot& spot, Coordinate feet, Coordinate least) {
    Room& room = roomAt(spot);
    const Column& column = columnAt(spot.map, spot.x, spot.y);
    const Grid& grid = grids_[static_cast<std::size_t>(spot.map)];
    const auto climbs = std::span(grid.climbs).subspan(column.firstClimb, column.climbs);
    const Coordinate highest = room.above - kCrouchedHeight;
    Coordinate stands = std::max(room.ground, least);
    Coordinate high = std::max({room.high, feet, std::min(highest, stands + heightBehind(0))});
    for (std::size_t i = 0; i < climbs.size(); ++i) {
        if (climbs[i].low > high || climbs[i].low > highest) continue;
        const Coordinate top = std::min(climbs[i].high, highest);
        if (top <= stands) continue;
        stands = top;
        high = std::max(high, std::min(highest, stands + heightBehind(0)));
        i = static_cast<std::size_t>(-1);  // what comes before may be in reach now
    }
    room.high = high;
    if (stands <= room.feet) return;
    room.feet = stands;
    waiting_.push({spot.map, spot.x, spot.y, spot.room, stands});
}

// Looks at all that a body gets to from there on foot, through the air, and down.
void Footways::jumpFrom(const Spot& spot) {
    const Map& map = world_.maps[static_cast<std::size_t>(spot.map)];
    const Coordinate takeOff = roomAt(spot).feet;
    roomAt(spot).jump = ++jumps_;
    roomAt(spot).jumped = roomAt(spot).above;
    std::vector<Spot> reached = {spot};
    std::vector<RoomHeights> walls;
    for (int tiles = 0; tiles <= kLongestJump && !reached.empty(); ++tiles) {
        const Coordinate feet = takeOff + heightBehind(tiles);
        std::vector<Spot> next;
        for (const Spot& from : reached) {
            for (const NextTile& side : kNextTiles) {
                const int x = from.x + side.x;
                const int y = from.y + side.y;
                if (!map.contains(x, y) || goThroughTile(from, x, y, feet)) continue;
                goThroughSides(from, side.in, x, y, feet);
                const Column column = columnAt(spot.map, x, y);
                for (std::size_t i = 0; i < column.rooms; ++i) {
                    const Spot to = {spot.map, x, y, column.firstRoom + i};
                    const RoomHeights open = {std::max(roomAt(from).ground, roomAt(to).ground),
                                              std::min(roomAt(from).above, roomAt(to).above)};
                    if (open.low > feet || open.high - open.low < kCrouchedHeight) continue;
                    walls.clear();
                    addWalls(from, side.out, walls);
                    addWalls(to, side.in, walls);
                    const auto passed = passage(open, feet, walls);
                    const bool isNew = roomAt(to).jump != jumps_;
                    if (!passed || (!isNew && roomAt(to).jumped >= *passed)) continue;
                    const bool isListed = !isNew && roomAt(to).tiles == tiles;
                    roomAt(to).jump = jumps_;
                    roomAt(to).jumped = *passed;
                    roomAt(to).tiles = tiles;
                    stand(to, *passed, kNowhere);
                    // Else a jump from there goes further
                    if (!isListed && roomAt(to).ground < takeOff) next.push_back(to);
                }
            }
        }
        reached = std::move(next);
    }
}

// True if the tile is a portal.
bool Footways::goThroughTile(const Spot& from, int x, int y, Coordinate feet) {
    const Map& map = world_.maps[static_cast<std::size_t>(from.map)];
    const Portal* portal = portalOf(world_, map.tilePortal(x, y));
    if (portal == nullptr) return false;
    const Coordinate lift = tileEdge(portal->levels);
    const Room room = roomAt(from);
    arrive(portal->toMap, portal->toX, portal->toY, room.ground + lift, room.above + lift,
           feet + lift);
    return true;
}

// Goes through the portals on a side of the tile's blocks.
void Footways::goThroughSides(const Spot& from, Face side, int x, int y, Coordinate feet) {
    const Map& map = world_.maps[static_cast<std::size_t>(from.map)];
    for (int level = 0; level < map.levels; ++level) {
        const CellBlueprint* block = portalBlock(world_, map, x, y, level);
        const Portal* portal =
            block == nullptr ? nullptr : portalOf(world_, block->face(side).portal);
        if (portal == nullptr) continue;
        const Room room = roomAt(from);
        if (room.ground + kCrouchedEye >= tileEdge(level) + block->top ||
            feet + kStandingEye < tileEdge(level) + block->bottom)
            continue;
        const Coordinate lift = tileEdge(portal->levels);
        arrive(portal->toMap, portal->toX, portal->toY, room.ground + lift, room.above + lift,
               feet + lift);
    }
}

// Goes through the portals that one stands on, or that are above the head.
void Footways::goThroughEnds(const Spot& spot) {
    const Map& map = world_.maps[static_cast<std::size_t>(spot.map)];
    for (int level = 0; level < map.levels; ++level) {
        const CellBlueprint* block = portalBlock(world_, map, spot.x, spot.y, level);
        if (block == nullptr) continue;
        const Room room = roomAt(spot);
        for (const Face face : {Face::top, Face::bottom}) {
            const Portal* portal = portalOf(world_, block->face(face).portal);
            const bool isMet = face == Face::top ? tileEdge(level) + block->top == room.ground
                                                 : tileEdge(level) + block->bottom == room.above &&
                                                       room.high + kStandingEye >= room.above;
            if (portal == nullptr || !isMet) continue;
            arrive(portal->toMap, portal->toX, portal->toY, {}, kMaxBodyHeight,
                   room.high + tileEdge(portal->levels));
        }
    }
}

// True if the test is true of a room that is reached, in one of the tiles that the box touches.
template <typename Test>
bool Footways::anyRoom(int mapIndex, const Box& tiles, Test test) const {
    const Map& map = world_.maps[static_cast<std::size_t>(mapIndex)];
    const Grid& grid = grids_[static_cast<std::size_t>(mapIndex)];
    for (int y = std::max(0, tiles.north.tile()); y <= std::min(map.depth - 1, tiles.south.tile());
         ++y) {
        for (int x = std::max(0, tiles.west.tile());
             x <= std::min(map.width - 1, tiles.east.tile()); ++x) {
            const Column& column = grid.columns[map.tileIndex(x, y)];
            for (std::size_t i = 0; i < column.rooms; ++i) {
                const Room& room = grid.rooms[column.firstRoom + i];
                if (room.feet != kNowhere && test(x, y, room)) return true;
            }
        }
    }
    return false;
}

bool Footways::comesWithin(int map, const Box& box, Coordinate distance) const {
    const Coordinate around = distance + kBodyHalfWidth;
    return anyRoom(map,
                   {box.west - around, box.east + around, box.north - around, box.south + around,
                    box.bottom, box.top},
                   [&](int x, int y, const Room& room) {
                       return areWithin(
                           {tileEdge(x) - kBodyHalfWidth, tileEdge(x + 1) + kBodyHalfWidth,
                            tileEdge(y) - kBodyHalfWidth, tileEdge(y + 1) + kBodyHalfWidth,
                            room.ground, room.high + kStandingHeight},
                           box, distance);
                   });
}

bool Footways::comesInto(int map, const Box& box) const {
    const Coordinate least = {1};
    return anyRoom(map,
                   {box.west, box.east - least, box.north, box.south - least, box.bottom, box.top},
                   [&](int, int, const Room& room) {
                       return room.ground <= box.top && room.high + kStandingEye >= box.bottom;
                   });
}

std::optional<Footways::Place> Footways::nearestTo(int map, const Box& box) const {
    const auto square = [](Coordinate at, Coordinate low, Coordinate high) {
        const double gap = std::max({0.0, low.value() - at.value(), at.value() - high.value()});
        return gap * gap;
    };
    const Map& grid = world_.maps[static_cast<std::size_t>(map)];
    std::optional<Place> nearest;
    double least = 0.0;
    anyRoom(map, {{}, tileEdge(grid.width), {}, tileEdge(grid.depth), {}, kMaxBodyHeight},
            [&](int x, int y, const Room& room) {
                const Coordinate middle = toCoordinate(0.5);
                const double distance = square(tileEdge(x) + middle, box.west, box.east) +
                                        square(tileEdge(y) + middle, box.north, box.south) +
                                        square(room.feet, box.bottom, box.top);
                if (!nearest || distance < least) {
                    nearest = {x, y, room.feet};
                    least = distance;
                }
                return false;
            });
    return nearest;
}

bool Footways::isMet(const Gate& gate) const {
    const GateKind& kind = world_.gateKinds[static_cast<std::size_t>(gate.kind)];
    return std::any_of(gate.boxes.begin(), gate.boxes.end(), [&](const Box& box) {
        return (kind.keyed && comesWithin(gate.map, box, kind.reach)) ||
               (kind.opensOnApproach && comesWithin(gate.map, box, kind.approach));
    });
}

bool Footways::takes(std::size_t index) const {
    if (isMoving_[index]) return true;
    const Find& find = world_.quest.finds[index];
    const Map& map = world_.maps[static_cast<std::size_t>(find.map)];
    return comesWithin(find.map, objectBody(map.objects[static_cast<std::size_t>(find.object)]),
                       {});
}

}  // namespace slicecast

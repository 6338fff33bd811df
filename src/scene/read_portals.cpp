// Portals: faces of blocks and tiles that lead elsewhere.
//
//     map a               map b
//     . . . . .           . . . . .
//     . B|A . .    ->     . N|E . .
//     . . . . .           . . . . .
//
// The portal is the face of block A towards tile B; its exit is tile E. With "twoWay", block N
// behind the exit gets a portal on its face towards E, which leads back to tile B: a player who
// turns around and walks back comes out where they went in. For a top or bottom, N is the block
// that touches the same plane from the other side. The way back of a tile is a portal of the exit
// tile.
#include "base/later_text.h"
#include "scene/limits.h"
#include "scene/readers.h"
#include "world/player.h"
#include "world/portal.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr NumberRange kLevelNumber = {0.0, kMaxLevels, false,
                                      "a whole number of levels, from 0 to 32"};
constexpr NumberRange kTurn = {0.0, 270.0, false,
                               "0, 90, 180 or 270 degrees, clockwise as seen from above"};
static_assert(kMaxMapWidth == 4096 && kMaxMapDepth == 4096 && kMaxLevels == 32, "as the words say");

// A portal as the scene file states it.
struct PortalOrder {
    JsonValue value;
    JsonValue exit;  // "to"
    Portal portal;
    int level = 0;
    int toLevel = 0;
    std::optional<Face> face;
    bool twoWay = false;
};

// Heights low .. high.
struct Stretch {
    Coordinate low;
    Coordinate high;
};

constexpr bool overlap(const Stretch& a, const Stretch& b) {
    return a.low < b.high && b.low < a.high;
}

std::string cellText(const GridTile& tile, int level) {
    return words("x ", tile.x, ", y ", tile.y, ", level ", level);
}

Face opposite(Face face) {
    constexpr Face kOpposites[kFaces] = {Face::south, Face::west,   Face::north,
                                         Face::east,  Face::bottom, Face::top};
    return kOpposites[static_cast<std::size_t>(face)];
}

// The tile that lies before a side.
GridTile neighbour(GridTile tile, Face side) {
    constexpr int kEast[kFaces] = {0, 1, 0, -1, 0, 0};
    constexpr int kSouth[kFaces] = {-1, 0, 1, 0, 0, 0};
    return {tile.x + kEast[static_cast<std::size_t>(side)],
            tile.y + kSouth[static_cast<std::size_t>(side)]};
}

class PortalPlacer {
public:
    explicit PortalPlacer(Reading& reading)
        : reading_(reading),
          checker_(reading.checker),
          world_(reading.description.world),
          firstOwn_(world_.blueprints.size()) {}

    void read(const PortalList& list) {
        if (!list.value.isArray()) {
            checker_.add(list.value, checker_.shown(list.value), "an array of portals");
            return;
        }
        for (const JsonValue element : list.value) {
            const std::size_t faultsBefore = checker_.count();
            const std::optional<PortalOrder> order = readOrder(element, list.map);
            if (order && checker_.count() == faultsBefore) place(*order);
        }
    }

private:
    std::optional<PortalOrder> readOrder(JsonValue value, std::size_t map) {
        const auto fields =
            checker_.fields(value, {"x", "y", "level", "face", "to", "turn", "twoWay"},
                            "a portal: an object with \"x\", \"y\" and \"to\""_onFault);
        if (!fields) return std::nullopt;
        PortalOrder order{value, value, {}, 0, 0, std::nullopt, false};
        for (const char* key : {"x", "y"}) fields->require(key, kTile.words);
        order.portal.fromMap = static_cast<int>(map);
        order.portal.fromX = fields->wholeNumber("x", kTile, 0);
        order.portal.fromY = fields->wholeNumber("y", kTile, 0);
        order.level = fields->wholeNumber("level", kLevelNumber, 0);
        if (const auto face = fields->find("face")) order.face = readFace(*face);
        if (const auto turn = fields->find("turn")) order.portal.turn = readTurn(*turn);
        order.twoWay = fields->flag("twoWay", false);
        if (const auto exit =
                fields->require("to", "where it leads: an object with \"x\" and \"y\""))
            readExit(*exit, order);
        return order;
    }

    Face readFace(JsonValue value) {
        std::vector<std::string_view> names(kFaceNames.begin(), kFaceNames.end());
        const auto name = checker_.text(value, kMaxNameLength, "the name of a face");
        if (!name) return Face::north;
        const auto found = std::find(names.begin(), names.end(), *name);
        if (found != names.end()) return static_cast<Face>(found - names.begin());
        checker_.add(value, {"the name ", quoted(*name)},
                     {"one of the faces ", listed(names), suggestion(*name, names)});
        return Face::north;
    }

    int readTurn(JsonValue value) {
        const auto degrees = checker_.number(value, kTurn);
        if (!degrees) return 0;
        const int quarters = static_cast<int>(*degrees) / 90;
        if (90.0 * quarters != *degrees) checker_.refuse(value, kTurn.words);
        return quarters;
    }

    void readExit(JsonValue value, PortalOrder& order) {
        const auto fields =
            checker_.fields(value, {"map", "place", "x", "y", "level"},
                            "where it leads: an object with \"x\" and \"y\""_onFault);
        if (!fields) return;
        order.exit = value;
        const auto map = fields->mapOr(reading_.maps, order.portal.fromMap);
        order.portal.toMap = map.value_or(0);
        const NamedPlace place = readPosition(reading_, value, *fields, true, map);
        order.portal.toX = static_cast<int>(place.x);
        order.portal.toY = static_cast<int>(place.y);
        const int level = place.z ? static_cast<int>(*place.z) : order.level;
        order.toLevel = fields->wholeNumber("level", kLevelNumber, level);
        order.portal.levels = order.toLevel - order.level;
    }

    // With faults in the maps on either side, the portal may be right: it is not checked.
    bool isSound(int map) const {
        const auto index = static_cast<std::size_t>(map);
        return reading_.areBlueprintsSound && index < reading_.isMapSound.size() &&
               reading_.isMapSound[index];
    }

    const Map& mapAt(int map) const { return world_.maps[static_cast<std::size_t>(map)]; }

    bool isOnMap(JsonValue at, int mapIndex, GridTile tile, int level, const char* what) {
        const Map& map = mapAt(mapIndex);
        if (!map.contains(tile.x, tile.y)) {
            checker_.add(at, {what, " outside the map ", quoted(map.name)},
                         {"x below ", map.width, " and y below ", map.depth});
            return false;
        }
        if (level > map.levels) {
            checker_.add(at, {what, " on level ", level},
                         {"a level from 0 to ", map.levels,
                          ", the one above all blocks of the map "_later, quoted(map.name)});
            return false;
        }
        return true;
    }

    void place(const PortalOrder& order) {
        const Portal& portal = order.portal;
        if (!isSound(portal.fromMap) || !isSound(portal.toMap)) return;
        const GridTile from = {portal.fromX, portal.fromY};
        const GridTile to = {portal.toX, portal.toY};
        if (!isOnMap(order.value, portal.fromMap, from, order.level, "a portal") ||
            !isOnMap(order.exit, portal.toMap, to, order.toLevel, "an exit"))
            return;
        if (order.face) {
            placeFace(order, *order.face);
        } else {
            placeTile(order);
        }
    }

    void placeTile(const PortalOrder& order) {
        const Portal& portal = order.portal;
        if (portal.turn == 0 && portal.levels == 0 && portal.fromMap == portal.toMap &&
            portal.fromX == portal.toX && portal.fromY == portal.toY) {
            checker_.add(order.value, "a portal that leads to itself"_later,
                         "another tile, a turn or another level"_later);
            return;
        }
        if (!hasRoom(order.exit, portal.toMap, {portal.toX, portal.toY},
                     {tileEdge(order.toLevel), tileEdge(order.toLevel + 1)}, "an exit"))
            return;
        if (!addTile(order.value, portal) || !order.twoWay) return;
        const Portal back = reversed(portal);
        if (!hasRoom(order.value, back.toMap, {back.toX, back.toY},
                     {tileEdge(order.level), tileEdge(order.level + 1)}, "the way back's exit"))
            return;
        addTile(order.value, back);
    }

    void placeFace(const PortalOrder& order, Face face) {
        const Portal& portal = order.portal;
        const GridTile tile = {portal.fromX, portal.fromY};
        const BlueprintId id = mapAt(portal.fromMap).cell(tile.x, tile.y, order.level);
        if (id == kEmptyCell) {
            checker_.add(
                order.value, {"no block at ", cellText(tile, order.level)},
                "a block that has this face; without \"face\" the whole tile is the portal"_later);
            return;
        }
        const Stretch block = {world_.blueprints[id].bottom, world_.blueprints[id].top};
        if (!hasRoom(order.exit, portal.toMap, {portal.toX, portal.toY},
                     beyond(face, order.toLevel, block), "an exit"))
            return;
        if (!addFace(order.value, portal, order.level, face) || !order.twoWay) return;

        // The way back
        const Face backFace = turned(opposite(face), portal.turn);
        const bool isLevel = face == Face::top || face == Face::bottom;
        Portal back = reversed(portal);
        int backLevel = order.toLevel;
        if (isLevel) {
            backLevel += face == Face::top ? (block.high == tileEdge(1) ? 1 : 0)
                                           : (block.low == Coordinate{0} ? -1 : 0);
        } else {
            const GridTile behind = neighbour({portal.toX, portal.toY}, opposite(backFace));
            const GridTile before = neighbour(tile, face);
            back.fromX = behind.x;
            back.fromY = behind.y;
            back.toX = before.x;
            back.toY = before.y;
        }
        const BlueprintId backId = mapAt(back.fromMap).cell(back.fromX, back.fromY, backLevel);
        const Face fitting = backFace == Face::top ? Face::bottom : Face::top;
        if (backId == kEmptyCell ||
            (isLevel && edge(backFace, backLevel, world_.blueprints[backId]) !=
                            edge(fitting, order.toLevel, world_.blueprints[id]))) {
            checker_.add(order.value,
                         {"no block for the way back at "_later,
                          cellText({back.fromX, back.fromY}, backLevel)},
                         {"a block whose ", kFaceNames[static_cast<std::size_t>(backFace)],
                          " face lies behind the exit, or no \"twoWay\""_later});
            return;
        }
        const CellBlueprint& other = world_.blueprints[backId];
        const int exitLevel = backLevel + back.levels;
        if (!mapAt(back.toMap).contains(back.toX, back.toY)) {
            checker_.add(order.value, "a two-way portal that faces the edge of the map"_later,
                         "a tile in front of the portal, or no \"twoWay\""_later);
            return;
        }
        if (!hasRoom(order.value, back.toMap, {back.toX, back.toY},
                     beyond(backFace, exitLevel, {other.bottom, other.top}), "the way back's exit"))
            return;
        addFace(order.value, back, backLevel, backFace);
    }

    // The height of a top or bottom.
    static Coordinate edge(Face face, int level, const CellBlueprint& block) {
        return tileEdge(level) + (face == Face::top ? block.top : block.bottom);
    }

    // The heights that the opening of a block's face covers.
    static Stretch beyond(Face face, int level, const Stretch& block) {
        const Stretch box = {tileEdge(level) + block.low, tileEdge(level) + block.high};
        if (face == Face::top) return {box.high - Coordinate{1}, box.high};
        if (face == Face::bottom) return {box.low, box.low + Coordinate{1}};
        return box;
    }

    // An exit must not be inside a block. Where the player does not fit, it can still be looked
    // through.
    bool hasRoom(JsonValue at, int mapIndex, GridTile tile, const Stretch& opening,
                 const char* what) {
        const Map& map = mapAt(mapIndex);
        std::vector<Stretch> free;
        Coordinate low = {0};
        std::string_view inTheWay;
        int levelInTheWay = 0;
        for (int level = 0; level < map.levels; ++level) {
            const BlueprintId id = map.cell(tile.x, tile.y, level);
            const CellBlueprint& block = world_.blueprints[id];
            if (id == kEmptyCell || !block.isStill() || block.isWater) continue;
            const Stretch solid = {tileEdge(level) + block.bottom, tileEdge(level) + block.top};
            if (low < solid.low) free.push_back({low, solid.low});
            low = solid.high;
            if (overlap(solid, opening)) {
                inTheWay = block.name;
                levelInTheWay = level;
            }
        }
        free.push_back({low, kMaxBodyHeight});
        const auto leadsInto = [&](const Stretch& room) { return overlap(room, opening); };
        if (std::none_of(free.begin(), free.end(), leadsInto)) {
            checker_.add(at,
                         {what, " inside the block ", quoted(inTheWay), " at ",
                          cellText(tile, levelInTheWay)},
                         "an exit outside solid blocks"_later);
            return false;
        }
        const auto isHighEnough = [&](const Stretch& room) {
            return leadsInto(room) && room.high - room.low >= kCrouchedHeight;
        };
        if (std::none_of(free.begin(), free.end(), isHighEnough)) {
            checker_.warn(at, {what, " where the player does not fit"_later},
                          "at least 0.35 units of free height, so that the player can enter"_later);
        }
        return true;
    }

    std::optional<PortalId> add(JsonValue at, const Portal& portal) {
        if (world_.portals.size() >= static_cast<std::size_t>(kMaxPortals)) {
            checker_.add(at, {"more than ", kMaxPortals, " portals"},
                         "fewer in all maps together"_later);
            return std::nullopt;
        }
        if (std::none_of(ways_.rbegin(), ways_.rend(),
                         [&](const Portal& way) { return leadOnTogether(way, portal); })) {
            if (ways_.size() == kMaxPortalWays) {
                checker_.add(
                    at, {"more than ", kMaxPortalWays, " different ways through portals"_later},
                    "fewer; portals side by side that lead to places side by side are "
                    "one way"_later);
                return std::nullopt;
            }
            ways_.push_back(portal);
        }
        world_.portals.push_back(portal);
        return static_cast<PortalId>(world_.portals.size() - 1);
    }

    bool addTile(JsonValue at, const Portal& portal) {
        Map& map = world_.maps[static_cast<std::size_t>(portal.fromMap)];
        if (map.tilePortals.empty()) map.tilePortals.assign(map.occupied.size(), kNoPortal);
        PortalId& place = map.tilePortals[map.tileIndex(portal.fromX, portal.fromY)];
        if (place != kNoPortal) {
            checker_.add(at,
                         {"a second portal at x "_later, portal.fromX, ", y ", portal.fromY,
                          " of the map ", quoted(map.name)},
                         "one portal per tile, counting the ways back of others"_later);
            return false;
        }
        const auto id = add(at, portal);
        if (id) place = *id;
        return id.has_value();
    }

    // Rays that come out of a roof or an underside start within the exit tile, where a slope could
    // be partly behind them.
    bool leadsToLevelBlocks(JsonValue at, const Portal& portal) {
        const Map& map = mapAt(portal.toMap);
        for (int level = 0; level < map.levels; ++level) {
            const CellBlueprint& block = world_.blueprints[map.cell(portal.toX, portal.toY, level)];
            if (!block.slopes.any()) continue;
            checker_.add(at,
                         {"a portal in a roof or an underside that leads to the block "_later,
                          quoted(block.name), " at ", cellText({portal.toX, portal.toY}, level),
                          ", which has slopes"},
                         "an exit tile without blocks with \"rise\""_later);
            return false;
        }
        return true;
    }

    bool addFace(JsonValue at, const Portal& portal, int level, Face face) {
        Map& map = world_.maps[static_cast<std::size_t>(portal.fromMap)];
        const GridTile tile = {portal.fromX, portal.fromY};
        BlueprintId id = map.cell(tile.x, tile.y, level);
        if (!world_.blueprints[id].isStill()) {
            checker_.add(at,
                         {"a portal on the block "_later, quoted(world_.blueprints[id].name),
                          ", which moves or opens"_later},
                         "a block that stands still"_later);
            return false;
        }
        if (!world_.blueprints[id].plan.isWhole()) {
            checker_.add(at,
                         {"a portal on the block "_later, quoted(world_.blueprints[id].name),
                          ", which fills a part of its tile"_later},
                         "a block without \"plan\" and \"diagonal\""_later);
            return false;
        }
        if (world_.blueprints[id].slopes.any()) {
            checker_.add(at,
                         {"a portal on the block "_later, quoted(world_.blueprints[id].name),
                          ", which has slopes"},
                         "a block without \"rise\""_later);
            return false;
        }
        if ((face == Face::top || face == Face::bottom) && !leadsToLevelBlocks(at, portal))
            return false;
        if (world_.blueprints[id].isWater) {
            checker_.add(at,
                         {"a portal on the block "_later, quoted(world_.blueprints[id].name),
                          ", which is water"},
                         "a solid block, or a portal of the whole tile, without \"face\""_later);
            return false;
        }
        if (id < firstOwn_) {
            if (world_.blueprints.size() >= static_cast<std::size_t>(kMaxBlueprints)) {
                checker_.add(at,
                             {"more than ", kMaxBlueprints,
                              " blueprints: each block with portals needs its own"_later},
                             "fewer blocks with portals"_later);
                return false;
            }
            CellBlueprint own = instanceOf(world_, id);
            own.hasPortals = true;
            id = static_cast<BlueprintId>(world_.blueprints.size());
            world_.blueprints.push_back(std::move(own));
            map.setCell(tile.x, tile.y, level, id);
        }
        PortalId& place = world_.blueprints[id].faces[static_cast<std::size_t>(face)].portal;
        if (place != kNoPortal) {
            checker_.add(
                at,
                {"a second portal on the "_later, kFaceNames[static_cast<std::size_t>(face)],
                 " face at ", cellText(tile, level), " of the map ", quoted(map.name)},
                "one portal per face, counting the ways back of others"_later);
            return false;
        }
        const auto added = add(at, portal);
        if (added) place = *added;
        return added.has_value();
    }

    Reading& reading_;
    Checker& checker_;
    World& world_;
    std::vector<Portal> ways_;  // one portal of each, see kMaxPortalWays
    std::size_t firstOwn_;      // blueprints from here on belong to one cell each
};

}  // namespace

void placePortals(Reading& reading) {
    PortalPlacer placer(reading);
    for (const PortalList& list : reading.portals) placer.read(list);
}

}  // namespace slicecast

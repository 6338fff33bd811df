#include "scene/unreached.h"

#include "base/sort.h"
#include "base/words.h"
#include "scene/spares.h"
#include "world/collision.h"
#include "world/footways.h"

#include <algorithm>
#include <tuple>

namespace slicecast {
namespace {

constexpr const char* kWay =
    "a way to it from the start, without steps above 0.79, the height of a jump";

bool isMoving(const World& world, int map, int object) {
    const std::vector<ObjectMotion>& motions = world.movingObjects.motions;
    return std::any_of(motions.begin(), motions.end(), [&](const ObjectMotion& motion) {
        return motion.map == map && motion.object == object;
    });
}

// Number keys enter every map: in one that no way leads to, only finds and the goal are out of
// reach.
bool isOnTheWay(const World& world, const Footways& ways, int map) {
    const Map& grid = world.maps[static_cast<std::size_t>(map)];
    return ways.comesInto(map,
                          {{}, tileEdge(grid.width), {}, tileEdge(grid.depth), {}, kMaxBodyHeight});
}

// How far a player gets.
std::string nearest(const World& world, const Footways& ways, int map, const Box& box) {
    const std::optional<Footways::Place> place = ways.nearestTo(map, box);
    if (!place)
        return words("; nobody gets into the map \"",
                     world.maps[static_cast<std::size_t>(map)].name, "\" on foot");
    return words("; the nearest place that one gets to is x ", Shortest{place->x + 0.5}, ", y ",
                 Shortest{place->y + 0.5}, ", z ", Fixed{place->feet.value(), 2});
}

std::string unreachedFinds(const World& world, const Footways& ways, const Aim& aim) {
    std::size_t missed = 0;
    for (std::size_t i = aim.first; i < aim.first + aim.count; ++i) missed += !ways.takes(i);
    if (missed == 0) return "";
    const FindKind& kind = world.quest.kinds[world.quest.finds[aim.first].kind];
    const std::string name = words("\"", kind.name, "\"");
    if (aim.count == 1) {
        const Find& find = world.quest.finds[aim.first];
        const Map& map = world.maps[static_cast<std::size_t>(find.map)];
        const Box body = objectBody(map.objects[static_cast<std::size_t>(find.object)]);
        return words("a find ", name, " that nobody can reach on foot",
                     nearest(world, ways, find.map, body));
    }
    return words("sown finds ", name, " of which nobody can reach ", missed, " of ", aim.count,
                 " on foot");
}

std::string unreachedNotice(const World& world, const Footways& ways, const Notice& notice) {
    Box box = notice.area;
    if (notice.object >= 0) {
        if (isMoving(world, notice.map, notice.object)) return "";
        const Map& map = world.maps[static_cast<std::size_t>(notice.map)];
        box = objectBody(map.objects[static_cast<std::size_t>(notice.object)]);
    }
    if (!isOnTheWay(world, ways, notice.map) || ways.comesWithin(notice.map, box, notice.near))
        return "";
    return "a message that nobody can come near on foot" + nearest(world, ways, notice.map, box);
}

// What follows others, or opens at times, may be out of reach.
std::string unreachedGates(const World& world, const Footways& ways, std::size_t number) {
    const GateKind& kind = world.gateKinds[number];
    if (kind.everySteps > 0 || !kind.follows.empty()) return "";
    for (const Gate& gate : world.gates) {
        if (gate.kind != static_cast<int>(number) || !isOnTheWay(world, ways, gate.map) ||
            ways.isMet(gate))
            continue;
        const Map& map = world.maps[static_cast<std::size_t>(gate.map)];
        return words("a gate at x ", gate.bounds.west.tile(), ", y ", gate.bounds.north.tile(),
                     " of the map \"", map.name, "\" that nobody can open on foot",
                     nearest(world, ways, gate.map, gate.boxes.front()));
    }
    return "";
}

// Pictures of single things are seldom wider, and frames seldom fewer.
bool isLikeASheet(const World& world, std::size_t sprite) {
    const SpriteLevel& picture = world.sprites[sprite].frames[0][0];
    return picture.width >= 4 * picture.height || picture.width == 3 * picture.height;
}

std::string unreached(const World& world, const Footways& ways, const Aim& aim) {
    switch (aim.what) {
        case Aim::What::finds:
            return unreachedFinds(world, ways, aim);
        case Aim::What::notice:
            return unreachedNotice(world, ways, world.quest.notices[aim.first]);
        case Aim::What::gates:
            return unreachedGates(world, ways, aim.first);
        case Aim::What::goal:
        case Aim::What::block:
        case Aim::What::light:
        case Aim::What::place:
        case Aim::What::spare:
        case Aim::What::sheet:
        case Aim::What::mistake:
            break;
    }
    const std::optional<Goal>& goal = world.quest.goal;
    if (!goal || !goal->map || ways.comesInto(*goal->map, goal->area)) return "";
    return "a goal that nobody can reach on foot" + nearest(world, ways, *goal->map, goal->area);
}

}  // namespace

std::vector<Fault> findUnreached(const LoadedScene& scene) {
    std::vector<Fault> warnings;
    if (!scene.world || scene.aims.empty()) return warnings;
    const auto warn = [&](const Aim& aim, std::string found, const char* expected) {
        Fault& warning = warnings.emplace_back(aim.place);
        warning.found = std::move(found);
        warning.expected = expected;
    };
    const std::vector<bool> stands = standingBlocks(*scene.world);
    std::optional<Footways> ways;
    for (const Aim& aim : scene.aims) {
        if (aim.what == Aim::What::block) {
            if (!stands[aim.first])
                warn(aim, "a blueprint that stands in no map",
                     "its letter of the legend in the rows of a level");
            continue;
        }
        if (aim.what == Aim::What::light) {
            warn(aim, "baked light in a map whose \"light\" is on: it grows dark with the distance",
                 "\"light\": { \"on\": false } beside \"baked\"");
            continue;
        }
        if (aim.what == Aim::What::place) {
            warn(aim, "a place that nothing names",
                 "its name as the \"place\" of something, or no such place");
            continue;
        }
        if (aim.what == Aim::What::sheet) {
            if (isLikeASheet(*scene.world, aim.first))
                warn(aim,
                     "a picture so wide that it may be a sheet: all of its frames show at once",
                     "\"frames\" beside its \"file\": how many it has");
            continue;
        }
        if (aim.what == Aim::What::spare || aim.what == Aim::What::mistake) {
            warnings.push_back(aim.place);
            continue;
        }
        if (!ways) ways.emplace(*scene.world);
        std::string found = unreached(*scene.world, *ways, aim);
        if (!found.empty()) warn(aim, std::move(found), kWay);
    }
    mergeSort(warnings, [](const Fault& a, const Fault& b) {
        return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    });
    return warnings;
}

}  // namespace slicecast

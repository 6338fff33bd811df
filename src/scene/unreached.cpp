#include "scene/unreached.h"

#include "base/later_text.h"
#include "base/sort.h"
#include "base/words.h"
#include "scene/spares.h"
#include "world/collision.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace slicecast {
namespace {

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
        return words("; nobody gets into the map \""_later,
                     world.maps[static_cast<std::size_t>(map)].name, "\" on foot");
    return words("; the nearest place that one gets to is x "_later, Shortest{place->x + 0.5},
                 ", y ", Shortest{place->y + 0.5}, ", z ", Fixed{place->feet.value(), 2});
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
        return words("a find ", name, " that nobody can reach on foot"_later,
                     nearest(world, ways, find.map, body));
    }
    return words("sown finds ", name, " of which nobody can reach "_later, missed, " of ",
                 aim.count, " on foot");
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
    return "a message that nobody can come near on foot"_later +
           nearest(world, ways, notice.map, box);
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
                     " of the map \"", map.name, "\" that nobody can open on foot"_later,
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
    if (aim.what == Aim::What::finds) return unreachedFinds(world, ways, aim);
    if (aim.what == Aim::What::notice)
        return unreachedNotice(world, ways, world.quest.notices[aim.first]);
    if (aim.what == Aim::What::gates) return unreachedGates(world, ways, aim.first);
    const std::optional<Goal>& goal = world.quest.goal;
    if (!goal || !goal->map || ways.comesInto(*goal->map, goal->area)) return "";
    return "a goal that nobody can reach on foot"_later +
           nearest(world, ways, *goal->map, goal->area);
}

bool isOfReach(Aim::What what) {
    return what == Aim::What::finds || what == Aim::What::notice || what == Aim::What::gates ||
           what == Aim::What::goal;
}

void putInOrder(std::vector<Fault>& warnings) {
    mergeSort(warnings, [](const Fault& a, const Fault& b) {
        return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    });
}

}  // namespace

MistakeSearch::MistakeSearch(const LoadedScene& scene, std::int64_t mostPlaces)
    : scene_(scene), mostPlaces_(mostPlaces) {
    if (scene.world) stands_ = standingBlocks(*scene.world);
}

bool MistakeSearch::next() {
    if (isWalking_) {
        isWalking_ = ways_->next();
        return true;
    }
    if (!scene_.world || aims_ == scene_.aims.size()) return false;
    const Aim& aim = scene_.aims[aims_];
    if (!ways_ && isOfReach(aim.what)) {
        ways_.emplace(*scene_.world, mostPlaces_);
        isWalking_ = true;
        return true;
    }
    judge(aim);
    ++aims_;
    return true;
}

void MistakeSearch::judge(const Aim& aim) {
    const auto add = [&](std::vector<Fault>& list, std::string found, const char* expected) {
        Fault& warning = list.emplace_back(aim.place);
        warning.found = std::move(found);
        warning.expected = expected;
    };
    switch (aim.what) {
        case Aim::What::block:
            if (!stands_[aim.first])
                add(found_.spares, "a blueprint that stands in no map"_later,
                    "its letter of the legend in the rows of a level"_later);
            return;
        case Aim::What::place:
            add(found_.spares, "a place that nothing names"_later,
                "its name as the \"place\" of something, or no such place"_later);
            return;
        case Aim::What::spare:
            found_.spares.push_back(aim.place);
            return;
        case Aim::What::light:
            add(found_.warnings,
                "baked light in a map whose \"light\" is on: it grows dark with the distance"_later,
                "\"light\": { \"on\": false } beside \"baked\""_later);
            return;
        case Aim::What::sheet:
            if (isLikeASheet(*scene_.world, aim.first))
                add(found_.warnings,
                    "a picture so wide that it may be a sheet: all frames show at once"_later,
                    "\"frames\" beside its \"file\": how many it has"_later);
            return;
        case Aim::What::mistake:
            found_.warnings.push_back(aim.place);
            return;
        case Aim::What::finds:
        case Aim::What::notice:
        case Aim::What::gates:
        case Aim::What::goal:
            break;
    }
    if (ways_->gaveUp()) return;
    std::string found = unreached(*scene_.world, *ways_, aim);
    if (!found.empty())
        add(found_.warnings, std::move(found),
            "a way to it from the start, without steps above 0.79, the height of a "
            "jump"_later);
}

Mistakes MistakeSearch::take() {
    putInOrder(found_.warnings);
    putInOrder(found_.spares);
    return std::move(found_);
}

std::vector<Fault> findUnreached(const LoadedScene& scene) {
    MistakeSearch search(scene, std::numeric_limits<std::int64_t>::max());
    while (search.next()) {
    }
    Mistakes found = search.take();
    found.warnings.insert(found.warnings.end(), found.spares.begin(), found.spares.end());
    putInOrder(found.warnings);
    return std::move(found.warnings);
}

}  // namespace slicecast

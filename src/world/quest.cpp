#include "world/quest.h"

#include "base/hash.h"
#include "base/words.h"
#include "world/gate.h"
#include "world/line_of_sight.h"
#include "world/object_walk.h"
#include "world/player.h"
#include "world/world.h"

#include <algorithm>

namespace slicecast {
namespace {

// A notice is shown again only after the player has been this much further away.
constexpr Coordinate kAway = toCoordinate(0.5);

void tell(Quest& quest, QuestNews::Kind kind, const std::string& text, std::string name = {}) {
    quest.news.push_back(
        {.kind = kind, .text = text, .name = std::move(name), .taken = quest.taken});
}

const Object& objectOf(const World& world, int map, int object) {
    return world.maps[static_cast<std::size_t>(map)].objects[static_cast<std::size_t>(object)];
}

// The gates that open for the finds that the player has.
void unlockGates(World& world) {
    for (GateKind& kind : world.gateKinds) kind.isLocked = !holds(world.quest, kind.needs);
}

// The objects of all finds that are taken leave the world together.
void takeFinds(World& world, const Player& player, const Box& body) {
    Quest& quest = world.quest;
    const int before = quest.taken;
    for (const Find& find : quest.finds) {
        if (find.object < 0 || find.map != player.map ||
            !areWithin(body, objectBody(objectOf(world, find.map, find.object)), {}))
            continue;
        world.movingObjects.gone.push_back({.map = find.map, .object = find.object});
        ++quest.taken;
        ++quest.kinds[find.kind].taken;
        tell(quest, QuestNews::Kind::find, find.message, quest.kinds[find.kind].name);
    }
    if (quest.taken == before) return;
    closeGaps(world);
    unlockGates(world);
}

bool isWanted(const Quest& quest, const Notice& notice) {
    return holds(quest, notice.needs) && (notice.unless.none() || !holds(quest, notice.unless));
}

// Takes one of the `looks` for a look into the player's sight; says no if none is left.
bool isShown(const World& world, const Player& player, const Box& body, const Notice& notice,
             int& looks) {
    if (notice.map != player.map) return false;
    const Coordinate near = notice.isNear ? notice.near + kAway : notice.near;
    if (notice.object < 0)
        return areWithin(body, notice.area, near) && isWanted(world.quest, notice);
    const Object& object = objectOf(world, notice.map, notice.object);
    if (!areWithin(body, objectBody(object), near) || !isWanted(world.quest, notice)) return false;
    if (notice.isNear) return true;
    if (--looks < 0) return false;
    return isInSight(
        world, world.maps[static_cast<std::size_t>(notice.map)],
        {player.x.value(), player.y.value(), eyeHeight(player).value()},
        {object.x.value(), object.y.value(), object.z.value() + object.height.value() / 2.0});
}

void showNotices(World& world, const Player& player, const Box& body) {
    Quest& quest = world.quest;
    const std::size_t count = quest.notices.size();
    const std::size_t first = quest.nextNotice;
    quest.nextNotice = 0;
    int looks = kMostNoticeLooks;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t index = (first + i) % count;
        Notice& notice = quest.notices[index];
        const bool wasNear = notice.isNear;
        const bool hadLooks = looks >= 0;
        notice.isNear = isShown(world, player, body, notice, looks);
        if (hadLooks && looks < 0) quest.nextNotice = index;
        if (!notice.isNear || wasNear || (notice.once && notice.wasShown)) continue;
        notice.wasShown = true;
        tell(quest, QuestNews::Kind::message, notice.text);
    }
}

// Says what is missing at a gate that the player tries.
void tellRefusals(World& world, const GateAsk& ask, int map, const Box& body) {
    Quest& quest = world.quest;
    const bool isAsked = ask.wish == GateAsk::Wish::change || ask.wish == GateAsk::Wish::open;
    const int before = quest.refusedGate;
    quest.refusedGate = refusedGate(world, ask, map, body);
    if (quest.refusedGate < 0 || (quest.refusedGate == before && !isAsked)) return;
    tell(quest, QuestNews::Kind::message,
         refusal(world, world.gates[static_cast<std::size_t>(quest.refusedGate)]));
}

void checkGoal(Quest& quest, const Player& player) {
    if (!quest.goal || quest.isReached || !holds(quest, quest.goal->needs)) return;
    const Goal& goal = *quest.goal;
    if (goal.map && (*goal.map != player.map || !areWithin({player.x, player.x, player.y, player.y,
                                                            player.z, eyeHeight(player)},
                                                           goal.area, {})))
        return;
    quest.isReached = true;
    tell(quest, QuestNews::Kind::goal, goal.message);
}

}  // namespace

bool holds(const Quest& quest, const Needs& needs) {
    if (quest.taken < needs.any) return false;
    return std::all_of(needs.kinds.begin(), needs.kinds.end(), [&](const NeededKind& needed) {
        return quest.kinds[needed.kind].taken >= needed.count;
    });
}

std::string missing(const Quest& quest, const Needs& needs) {
    std::vector<std::string> parts;
    if (quest.taken < needs.any)
        parts.push_back(words(needs.any - quest.taken,
                              quest.taken + 1 == needs.any ? " more find" : " more finds"));
    for (const auto& [kind, count] : needs.kinds) {
        const int lacking = count - quest.kinds[kind].taken;
        if (lacking == 1) parts.push_back(quest.kinds[kind].name);
        if (lacking > 1) parts.push_back(words(lacking, " ", quest.kinds[kind].name));
    }
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i)
        add(text, {i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ", parts[i]});
    return text;
}

std::string refusal(const World& world, const Gate& gate) {
    const GateKind& kind = world.gateKinds[static_cast<std::size_t>(gate.kind)];
    return kind.locked.empty() ? words("Still missing: ", missing(world.quest, kind.needs), ".")
                               : kind.locked;
}

void startQuest(World& world) {
    for (Find& find : world.quest.finds) ++world.quest.kinds[find.kind].count;
    world.quest.findsAtStart = world.quest.finds;
    world.quest.noticesAtStart = world.quest.notices;
    unlockGates(world);
}

void stepQuest(World& world, const Player& player, const GateAsk& ask, bool isInput) {
    Quest& quest = world.quest;
    if (quest.none()) return;
    quest.news.clear();
    quest.hasBegun = quest.hasBegun || isInput;
    if (quest.hasBegun && !quest.isReached) ++quest.steps;
    const Box body = bodyBox(player);
    takeFinds(world, player, body);
    showNotices(world, player, body);
    tellRefusals(world, ask, player.map, body);
    checkGoal(quest, player);
}

void resetQuest(World& world) {
    Quest& quest = world.quest;
    quest.finds = quest.findsAtStart;
    quest.notices = quest.noticesAtStart;
    for (FindKind& kind : quest.kinds) kind.taken = 0;
    quest.taken = 0;
    quest.hasBegun = quest.isReached = false;
    quest.steps = 0;
    quest.refusedGate = -1;
    quest.nextNotice = 0;
    quest.news.clear();
    unlockGates(world);
}

QuestMoment momentOfQuest(const World& world) {
    const Quest& quest = world.quest;
    QuestMoment moment = {.takenOfKind = {},
                          .finds = quest.finds,
                          .notices = quest.notices,
                          .taken = quest.taken,
                          .hasBegun = quest.hasBegun,
                          .isReached = quest.isReached,
                          .steps = quest.steps,
                          .refusedGate = quest.refusedGate,
                          .nextNotice = quest.nextNotice};
    for (const FindKind& kind : quest.kinds) moment.takenOfKind.push_back(kind.taken);
    return moment;
}

void restoreQuest(World& world, const QuestMoment& moment) {
    Quest& quest = world.quest;
    for (std::size_t i = 0; i < quest.kinds.size(); ++i)
        quest.kinds[i].taken = moment.takenOfKind[i];
    quest.finds = moment.finds;
    quest.notices = moment.notices;
    quest.taken = moment.taken;
    quest.hasBegun = moment.hasBegun;
    quest.isReached = moment.isReached;
    quest.steps = moment.steps;
    quest.refusedGate = moment.refusedGate;
    quest.nextNotice = moment.nextNotice;
    quest.news.clear();
    unlockGates(world);
}

void addTo(Hash& hash, const Quest& quest) {
    if (quest.none()) return;
    for (const std::int64_t number :
         {std::int64_t{quest.taken}, std::int64_t{quest.hasBegun}, std::int64_t{quest.isReached},
          quest.steps, std::int64_t{quest.refusedGate}})
        hash.add(number);
    if (quest.nextNotice > 0) hash.add(static_cast<std::int64_t>(quest.nextNotice));
    for (const Find& find : quest.finds) hash.add(std::int64_t{find.object >= 0});
    for (const Notice& notice : quest.notices)
        hash.add(std::int64_t{notice.isNear} + 2 * std::int64_t{notice.wasShown});
}

}  // namespace slicecast

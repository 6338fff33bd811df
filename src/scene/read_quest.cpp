// Finds, messages and the game of a scene.
#include "base/later_text.h"
#include "scene/limits.h"
#include "scene/readers.h"

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

constexpr NumberRange kNoticeNear = {0.0, kFarthestNotice, false,
                                     "a number from 0 to 32, in units"};
constexpr NumberRange kAreaHeight = {0.0, kMaxHeight, false, "a number from 0 to 1000"};
constexpr NumberRange kCount = {1.0, static_cast<double>(kMaxFinds), false,
                                "a whole number of finds, from 1 to 1024"};
static_assert(kFarthestNotice == 32.0 && kMaxFinds == 1024 && kMaxMapWidth == 4096 &&
                  kMaxHeight == 1000.0,
              "as the words say");

constexpr Coordinate kUsualNear = toCoordinate(1.5);

std::string readMessage(Checker& checker, JsonValue value) {
    return checker
        .text(value, kMaxMessageLength, {"a message of 1 to ", kMaxMessageLength, " characters"})
        .value_or("");
}

bool hasRoomForNotice(Reading& reading, JsonValue value) {
    if (reading.description.world.quest.notices.size() < kMaxNotices) return true;
    reading.checker.add(value, {"more than ", kMaxNotices, " messages"},
                        {"at most ", kMaxNotices, " in a scene"});
    return false;
}

// { "place", "x", "y", "width", "depth", "bottom", "top" }: tiles of a map.
Box readArea(Reading& reading, JsonValue value, const Fields& fields,
             std::optional<std::uint16_t> map) {
    const NamedPlace place = readPosition(reading, value, fields, true, map);
    const int x = static_cast<int>(place.x);
    const int y = static_cast<int>(place.y);
    const int width = fields.wholeNumber("width", kTiles, 1);
    const int depth = fields.wholeNumber("depth", kTiles, 1);
    return {tileEdge(x),
            tileEdge(x + width),
            tileEdge(y),
            tileEdge(y + depth),
            toCoordinate(fields.number("bottom", kAreaHeight, 0.0)),
            toCoordinate(fields.number("top", kAreaHeight, kMaxHeight))};
}

// "needs" and "unless" of the next message; the names of finds are known once all maps are read.
void readConditions(Reading& reading, JsonValue value) {
    const std::size_t number = reading.description.world.quest.notices.size();
    if (const auto needs = value.find("needs"))
        reading.needs.push_back({*needs, PlacedNeeds::Of::notice, number});
    if (const auto unless = value.find("unless"))
        reading.needs.push_back({*unless, PlacedNeeds::Of::unless, number});
}

void checkArea(Reading& reading, JsonValue value, int map, const Box& area, const char* what) {
    const Map& grid = reading.description.world.maps[static_cast<std::size_t>(map)];
    if (area.east > tileEdge(grid.width) || area.south > tileEdge(grid.depth)) {
        reading.checker.add(value, {what, " beyond the edge of the map"_later},
                            {"tiles with x below ", grid.width, " and y below ", grid.depth});
    } else if (!reading.rooms.hasRoomIn(reading.description.world, map, area)) {
        reading.checker.warn(value, {what, " where the player has no room"_later},
                             "a tile that the player can enter"_later);
    }
}

// A number of finds, the name of a kind, or a list of names: one that stands there twice is needed
// twice.
Needs readNeeds(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    Needs needs;
    constexpr std::size_t kNone = kMaxFinds;
    std::vector<std::size_t> placeOf(reading.description.world.quest.kinds.size(), kNone);
    const auto add = [&](JsonValue name) {
        const auto kind = checker.name(name, reading.findKinds, "find");
        if (!kind) return;
        std::size_t& place = placeOf[*kind];
        if (place == kNone) {
            place = needs.kinds.size();
            needs.kinds.push_back({*kind, 0});
        }
        ++needs.kinds[place].count;
    };
    if (value.kind() == JsonValue::Kind::number) {
        needs.any = checker.wholeNumber(value, kCount).value_or(0);
    } else if (value.isText()) {
        add(value);
    } else if (value.isArray() && value.count() > 0 && value.count() <= kMaxFinds) {
        for (const JsonValue name : value) add(name);
    } else {
        checker.refuse(value, "a number of finds, the name of a find, or an array of names"_later);
    }
    return needs;
}

// Warns of needs that nobody can meet.
void checkNeeds(Reading& reading, JsonValue value, const Needs& needs) {
    const Quest& quest = reading.description.world.quest;
    const auto finds = static_cast<int>(quest.finds.size());
    if (needs.any > finds) {
        reading.checker.warn(value, {"a need of ", Counted{needs.any, "find"}},
                             {"at most ", finds, ", as many as there are"_later});
    }
    std::vector<int> thereOf(quest.kinds.size());
    for (const Find& find : quest.finds) ++thereOf[find.kind];
    for (const auto& [kind, wanted] : needs.kinds) {
        const int there = thereOf[kind];
        if (wanted <= there) continue;
        reading.checker.warn(
            value,
            {"a need of ", Counted{wanted, "find"}, " named ", quoted(quest.kinds[kind].name)},
            {"at most ", there, ", as many as there are"_later});
        return;
    }
}

// { "aim", "needs", "at", "message" }
void readGame(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    const auto fields = checker.fields(value, {"aim", "needs", "at", "message"},
                                       "a game: an object, for example with \"aim\""_onFault);
    if (!fields) return;
    Quest& quest = reading.description.world.quest;
    if (const auto aim = fields->require("aim", "what the player is to do"))
        quest.aim = readMessage(checker, *aim);
    Goal goal;
    goal.needs.any = static_cast<int>(quest.finds.size());
    if (const auto needs = fields->find("needs")) {
        goal.needs = readNeeds(reading, *needs);
        if (checker.count() == 0) checkNeeds(reading, *needs, goal.needs);
    }
    if (const auto message = fields->find("message")) goal.message = readMessage(checker, *message);
    if (const auto at = fields->find("at")) {
        const auto place =
            checker.fields(*at, {"map", "place", "x", "y", "width", "depth", "bottom", "top"},
                           "tiles of a map: an object with \"x\" and \"y\""_onFault);
        if (!place) return;
        const auto map = place->mapOr(reading.maps, reading.description.world.start.map);
        goal.map = map.value_or(0);
        goal.area = readArea(reading, *at, *place, map);
        if (checker.count() == 0) checkArea(reading, *at, *goal.map, goal.area, "a goal");
        reading.addAim(Aim::What::goal, *at, 0);
    }
    if (!goal.needs.none() || goal.map) {
        quest.goal = goal;
    } else {
        checker.warn(value, "a game that never ends: it has no finds and no \"at\""_later,
                     "objects with \"find\", or \"at\": where the player is to come"_later);
    }
}

void checkNotice(Reading& reading, std::size_t number) {
    const PlacedNotice& placed = reading.placedNotices[number];
    const Notice& notice = reading.description.world.quest.notices[placed.notice];
    checkArea(reading, placed.value, notice.map, notice.area, "a message");
}

}  // namespace

void placeFind(Reading& reading, JsonValue value, Find find, int object) {
    Quest& quest = reading.description.world.quest;
    if (quest.finds.size() == kMaxFinds) {
        reading.checker.add(value, {"more than ", kMaxFinds, " finds"},
                            {"at most ", kMaxFinds, " in a scene"});
        return;
    }
    find.map = static_cast<int>(reading.description.world.maps.size());
    find.object = object;
    reading.addAim(Aim::What::finds, value, quest.finds.size());
    quest.finds.push_back(std::move(find));
}

std::optional<Find> readFindKind(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    Quest& quest = reading.description.world.quest;
    Find find;
    std::optional<JsonValue> kind = value;
    if (!value.isText()) {
        const auto fields = checker.fields(value, {"kind", "message"},
                                           "a find: its name, or an object with \"kind\""_onFault);
        if (!fields) return std::nullopt;
        const auto named = fields->require("kind", "the find's name");
        if (const auto message = fields->find("message"))
            find.message = readMessage(checker, *message);
        if (!named) return std::nullopt;
        kind = *named;
    }
    const auto name = checker.text(*kind, kMaxNameLength, "the find's name");
    if (!name) return std::nullopt;
    const auto known = reading.findKinds.find(*name);
    find.kind = known.value_or(static_cast<std::uint16_t>(quest.kinds.size()));
    if (!known) {
        quest.kinds.push_back({.name = *name});
        reading.findKinds.add(kind->text(), find.kind);
    }
    return find;
}

Notice readObjectMessage(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    Notice notice;
    notice.near = kUsualNear;
    if (value.isText()) {
        notice.text = readMessage(checker, value);
        return notice;
    }
    const auto fields = checker.fields(value, {"text", "near", "once", "needs", "unless"},
                                       "a message: its text, or an object with \"text\""_onFault);
    if (!fields) return notice;
    if (const auto text = fields->require("text", "the message"))
        notice.text = readMessage(checker, *text);
    notice.near = toCoordinate(fields->number("near", kNoticeNear, kUsualNear.value()));
    notice.once = fields->flag("once", false);
    return notice;
}

void placeObjectMessage(Reading& reading, JsonValue value, Notice notice, int object) {
    if (!hasRoomForNotice(reading, value)) return;
    std::vector<Notice>& notices = reading.description.world.quest.notices;
    notice.map = static_cast<int>(reading.description.world.maps.size());
    notice.object = object;
    if (value.isObject()) readConditions(reading, value);
    reading.addAim(Aim::What::notice, value, notices.size());
    notices.push_back(std::move(notice));
}

void readMessages(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    if (!value.isArray()) {
        checker.refuse(value, "an array of messages"_later);
        return;
    }
    for (const JsonValue element : value) {
        if (!hasRoomForNotice(reading, element)) return;
        const auto fields =
            checker.fields(element,
                           {"text", "place", "x", "y", "width", "depth", "bottom", "top", "near",
                            "once", "needs", "unless"},
                           "a message: an object with \"text\", \"x\" and \"y\""_onFault);
        if (!fields) continue;
        Notice notice;
        notice.map = static_cast<int>(reading.description.world.maps.size());
        if (const auto text = fields->require("text", "the message"))
            notice.text = readMessage(checker, *text);
        notice.area = readArea(reading, element, *fields, static_cast<std::uint16_t>(notice.map));
        notice.near = toCoordinate(fields->number("near", kNoticeNear, 0.0));
        notice.once = fields->flag("once", false);
        readConditions(reading, element);
        std::vector<Notice>& notices = reading.description.world.quest.notices;
        reading.placedNotices.push_back({element, notices.size()});
        reading.addAim(Aim::What::notice, element, notices.size());
        notices.push_back(std::move(notice));
    }
}

void placeQuest(Reading& reading, FoundValue game) {
    for (const PlacedNeeds& placed : reading.needs) {
        World& world = reading.description.world;
        const Needs needs = readNeeds(reading, placed.value);
        if (reading.checker.count() == 0) checkNeeds(reading, placed.value, needs);
        if (placed.of == PlacedNeeds::Of::gate) {
            world.gateKinds[placed.number].needs = needs;
        } else if (placed.number < world.quest.notices.size()) {
            Notice& notice = world.quest.notices[placed.number];
            (placed.of == PlacedNeeds::Of::notice ? notice.needs : notice.unless) = needs;
        }
    }
    if (game) readGame(reading, *game);
    if (reading.checker.count() != 0) return;
    for (std::size_t notice = 0; notice < reading.placedNotices.size(); ++notice)
        reading.tasks.add<checkNotice>(reading, notice);
}

}  // namespace slicecast

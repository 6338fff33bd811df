#include "answers/quest_json.h"

#include "answers/json_text.h"
#include "session/session.h"

namespace slicecast {
namespace {

constexpr Named<QuestNews::Kind> kNewsKinds[] = {{QuestNews::Kind::message, "message"},
                                                 {QuestNews::Kind::find, "find"},
                                                 {QuestNews::Kind::goal, "goal"}};

void addCount(JsonText& json, int finds, std::size_t of) {
    json.key("finds").number(finds).key("of").number(static_cast<double>(of));
}

double questSeconds(const Quest& quest) {
    return static_cast<double>(quest.steps) / kStepsPerSecond;
}

}  // namespace

std::string newsJson(Session& session) {
    const Quest& quest = session.world().quest;
    JsonText json;
    json.beginArray();
    for (const QuestNews& news : session.takeNews()) {
        json.beginObject()
            .key("kind")
            .text(nameOf(kNewsKinds, news.kind))
            .key("text")
            .text(news.text);
        json.key("name").text(news.name);
        addCount(json, news.taken, quest.finds.size());
        json.key("seconds").number(questSeconds(quest)).endObject();
    }
    return json.endArray().str();
}

std::string gameJson(const Session& session) {
    const Quest& quest = session.world().quest;
    JsonText json;
    if (quest.none()) return "null";
    json.beginObject().key("aim").text(quest.aim);
    addCount(json, quest.taken, quest.finds.size());
    json.key("kinds").beginArray();
    for (const FindKind& kind : quest.kinds) {
        json.beginObject().key("name").text(kind.name);
        addCount(json, kind.taken, static_cast<std::size_t>(kind.count));
        json.endObject();
    }
    json.endArray().key("hasGoal").yesNo(quest.goal.has_value());
    json.key("begun").yesNo(quest.hasBegun).key("reached").yesNo(quest.isReached);
    json.key("steps").number(static_cast<double>(quest.steps));
    json.key("locked").text(session.lockedText());
    return json.key("seconds").number(questSeconds(quest)).endObject().str();
}

}  // namespace slicecast

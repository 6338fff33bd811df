// What makes a world a game: things to find, messages, and a goal. A world without them spends
// nothing here.
//
//     startQuest(world);                                    once the world is complete
//     stepQuest(world, player, ask, isInput);               after the player's step
//     for (const QuestNews& news : world.quest.news) ...    what has happened in it
//     resetQuest(world);                                    after resetObjects
//
// A find is an object that the player takes by touching it. A notice is a message that an object or
// an area shows when the player comes near. The time of a game counts steps, from the first input
// to the goal.
#pragma once

#include "base/coordinate.h"
#include "world/box.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slicecast {

class Hash;
struct Gate;
struct GateAsk;
struct Player;
struct World;

// A step looks at each of them.
inline constexpr std::size_t kMaxFinds = 1024;
inline constexpr std::size_t kMaxNotices = 1024;
// Objects with messages that a step looks for in the player's sight. Where more are near and have
// not been seen yet, they take turns.
inline constexpr int kMostNoticeLooks = 64;
inline constexpr double kFarthestNotice = 32.0;  // units

// Finds of one kind that somebody must have.
struct NeededKind {
    std::uint16_t kind = 0;
    int count = 1;

    friend bool operator==(const NeededKind&, const NeededKind&) = default;
};

// Finds that somebody must have: a number of any, or some of named kinds.
struct Needs {
    int any = 0;
    std::vector<NeededKind> kinds = {};  // each kind once

    bool none() const { return any == 0 && kinds.empty(); }
};

struct FindKind {
    std::string name;
    int count = 0;  // in the world
    int taken = 0;
};

struct Find {
    int map = 0;     // indices into World::maps and its objects
    int object = 0;  // -1 once it is taken
    std::uint16_t kind = 0;
    std::string message;  // may be empty
};

struct Notice {
    int map = 0;
    int object = -1;  // -1 for an area
    Box area = {};
    Coordinate near;  // units from the player's body, 0 if it must touch
    bool once = false;
    std::string text;
    Needs needs = {};   // shown only to a player who has these finds
    Needs unless = {};  // and not once these are there, if there are any

    bool isNear = false;
    bool wasShown = false;
};

struct Goal {
    Needs needs;
    std::optional<int> map;  // where the player must be, besides
    Box area = {};
    std::string message;
};

struct QuestNews {
    enum class Kind : std::uint8_t { message, find, goal };
    Kind kind = Kind::message;
    std::string text;  // may be empty for finds and the goal
    std::string name;  // of a find's kind
    int taken = 0;     // finds until now
};

struct Quest {
    std::string aim;  // what to do, for the player; may be empty
    std::vector<FindKind> kinds;
    std::vector<Find> finds;
    std::vector<Notice> notices;
    std::optional<Goal> goal;

    int taken = 0;                // finds
    bool hasBegun = false;        // there was an input
    bool isReached = false;       // the goal
    std::int64_t steps = 0;       // from the first input to the goal
    int refusedGate = -1;         // the gate that the player stands at in vain
    std::size_t nextNotice = 0;   // the notice that looks for the player first
    std::vector<QuestNews> news;  // of the last step

    std::vector<Find> findsAtStart;
    std::vector<Notice> noticesAtStart;

    bool none() const { return finds.empty() && notices.empty() && !goal && aim.empty(); }
};

bool holds(const Quest& quest, const Needs& needs);

// What is missing: "2 more finds", "shell and feather".
std::string missing(const Quest& quest, const Needs& needs);

// What a player is told at a gate that stays locked: its own message, or what is missing.
std::string refusal(const World& world, const Gate& gate);

void startQuest(World& world);

// `ask` is what the player asked of gates in this step.
void stepQuest(World& world, const Player& player, const GateAsk& ask, bool isInput);

void resetQuest(World& world);

// What a moment keeps of the quest, see world_moment.h.
struct QuestMoment {
    std::vector<int> takenOfKind;  // by kind
    std::vector<Find> finds;
    std::vector<Notice> notices;
    int taken = 0;
    bool hasBegun = false;
    bool isReached = false;
    std::int64_t steps = 0;
    int refusedGate = -1;
    std::size_t nextNotice = 0;
};
QuestMoment momentOfQuest(const World& world);
// Without news: what has happened before is told.
void restoreQuest(World& world, const QuestMoment& moment);

void addTo(Hash& hash, const Quest& quest);

}  // namespace slicecast

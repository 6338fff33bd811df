// The world's game as JSON, for pages.
//
// newsJson: what has happened since the last call, an array of
//     {"kind": "message", "find" or "goal", "text", "name" (of a find's kind), "finds" (taken),
//      "of" (in the world), "seconds"}
// gameJson: {"aim", "finds", "of", "kinds": [{"name", "finds", "of"}], "hasGoal", "begun",
//     "reached", "steps", "locked" (what is missing at the locked gate within reach), "seconds"};
//     null for a world without a game, finds and messages. Time runs from the first input to the
//     goal.
#pragma once

#include <string>

namespace slicecast {

class Session;

std::string newsJson(Session& session);
std::string gameJson(const Session& session);

}  // namespace slicecast

// Warns of what a scene has that no player can get to on foot: finds, messages, gates, and the
// goal. And of other probable mistakes that take a look at the whole scene: baked light that the
// map's light dims, sheets of frames that are not called so, still objects in the way of what
// moves, and what nothing uses.
//
//     for (const Fault& warning : findUnreached(loaded)) ...
//
// It looks at the whole world (see world/footways.h), so it is for tools. A page, which does not
// wait for it, asks afterwards, a little at a time:
//
//     MistakeSearch search(loaded, kMostPlacesOfPage);
//     while (search.next()) ...
//     search.take() ...
#pragma once

#include "scene/scene.h"
#include "world/footways.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace slicecast {

// In the order of the text. None for a scene with faults.
std::vector<Fault> findUnreached(const LoadedScene& scene);

// In the order of the text.
struct Mistakes {
    std::vector<Fault> warnings;
    std::vector<Fault> spares;  // what nothing uses: who builds may mean to use it later
};

// A world with more places does without the warnings of what cannot be reached.
inline constexpr std::int64_t kMostPlacesOfPage = 200'000;

class MistakeSearch {
public:
    // The scene must outlive this. It needs SceneParser::lookForMistakes.
    MistakeSearch(const LoadedScene& scene, std::int64_t mostPlaces);
    // Does a part of the work. False if none was left.
    bool next();
    Mistakes take();

private:
    void judge(const Aim& aim);

    const LoadedScene& scene_;
    std::int64_t mostPlaces_;
    std::vector<bool> stands_;  // by BlueprintId
    std::optional<Footways> ways_;
    bool isWalking_ = false;  // the ways are still being looked for
    std::size_t aims_ = 0;    // that have been judged
    Mistakes found_;
};

}  // namespace slicecast

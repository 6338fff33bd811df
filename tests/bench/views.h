// The views that are measured: of scenes of the frozen set, and one made of very many objects.
#pragma once

#include "session/session.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slicecast {

struct View {
    std::string title;  // "castle, start"
    std::shared_ptr<Session> session;
    double fraction = 1.0;          // of the way between the session's last two steps
    std::string comparedWith = {};  // the title of another view of the same picture, or near it
    double mostTimes = 0.0;         // that it may take as long as that one
};

// Opens the views of those titles, or all where there are none. A view with many objects and the
// one that it is compared with come together. Prints what is wrong with a scene, or which title no
// view has, and gives nothing then.
std::optional<std::vector<View>> openViews(const std::string& assets,
                                           const std::vector<std::string>& titles);

}  // namespace slicecast

// The views that are measured: of the shipped scenes, as they are played, and a few of what no
// shipped scene shows by itself. `root` is the folder of the sources. Whatever cannot be opened is
// nothing; the reason is printed.
#pragma once

#include "session/session.h"

#include <memory>
#include <optional>
#include <string>

namespace slicecast {

// A shipped scene, and the recorded tour through it.
std::unique_ptr<Session> openScene(const std::string& root, const std::string& name);
std::optional<Replay> openTour(const std::string& root, const std::string& scene);

// The name of a view is one of
//
//     castle           the start of a shipped scene, after a second in which nobody plays
//     castle@4320      the moment of its tour after so many steps
//     flat hall        or another one that is made for this: the table in views.cpp
std::unique_ptr<Session> openView(const std::string& root, const std::string& name);

}  // namespace slicecast

// How long each overlay takes beside the picture that it is laid over, while the eye walks and
// turns.
#pragma once

#include <string>

namespace slicecast {

// Prints a line for each view and overlay: milliseconds at 1280x720, medians over so many frames of
// the same walk, and a hash of all those pictures. False if a scene cannot be opened.
bool printOverlays(const std::string& assets, int frames);

}  // namespace slicecast

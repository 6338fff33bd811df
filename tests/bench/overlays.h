// How long each overlay takes beside the picture that it is laid over, while the eye walks and
// turns.
#pragma once

#include <string>

namespace slicecast {

// Prints a line for each view and overlay: milliseconds at 1280x720, medians over so many frames of
// the same walk, and a hash of all those pictures. Only of the overlay of that name, or of all
// where it is empty. False if a scene cannot be opened.
bool printOverlays(const std::string& root, int frames, const std::string& only);

}  // namespace slicecast

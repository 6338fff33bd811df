// Lines for a terminal.
#pragma once

#include "base/words.h"

#include <cstdio>

namespace slicecast {

// Prints the words and ends the line. What a terminal would obey is shown as "?": see
// base/printable.h.
void printLine(std::FILE* to, const Words& line);

}  // namespace slicecast

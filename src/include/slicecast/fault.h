// One thing that is wrong with a scene or a recording, with its place.
#pragma once

#include <string>

namespace slicecast {

struct Fault {
    std::string file;     // name that the caller gave the scene; for a scene made in code, the kind
                          // and name of the faulty part
    std::string pointer;  // JSON pointer to the value, "" for the whole document
    int line = 0;         // from 1; 0 where the fault has no place in a text
    int column = 0;       // from 1, in characters
    int row = -1;  // within a grid of characters: the tile's y, from 0 in the north; -1 elsewhere
    int character = -1;    // within such a row: the tile's x, from 0 in the west; -1 elsewhere
    std::string found;     // what the text has there
    std::string expected;  // what is allowed there

    friend bool operator==(const Fault&, const Fault&) = default;
};

// "castle.json:12:5 (/maps/0/levels/1/3, row 3, character 7): found 'Q', expected a character of
// the legend ..." For a terminal: control characters of names and of the file are shown as "?".
std::string describe(const Fault& fault);

}  // namespace slicecast

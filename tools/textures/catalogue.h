// Every picture that the program draws: its file name, what it is good for, and how it is painted.
#pragma once

#include <string>
#include <vector>

#include "picture.h"

namespace slicecast::textures {

enum class Use { Wall, Floor, Roof, Ceiling, Sky, Test };

struct Entry {
    std::string name;  // the file is name.png
    Use use;
    Picture (*paint)();
    std::string wall = {};       // what it is painted on: its borders continue that texture
    bool repeatsUpwards = true;  // false: its upper and lower borders meet other things than its own copies
};

const std::vector<Entry>& catalogue();

const char* nameOf(Use use);

}  // namespace slicecast::textures

// Every picture that the program draws: its file name, its use, and how it is painted.
#pragma once

#include <string>
#include <vector>

#include "picture.h"

namespace slicecast::textures {

enum class Use { Wall, Floor, Roof, Ceiling, Sky, Test, SeeThrough, Sheet, Sprite };

// The alphas of a picture: only 255; 0 (holes) and 255; any; or only 0.
enum class Alpha { Opaque, Holes, Blended, Nothing };

struct Entry {
    std::string name;  // the file is name.png
    Use use;
    Picture (*paint)();
    std::string wall = {};        // the texture that it is painted on and that its borders continue
    bool repeatsUpwards = true;   // false: its upper and lower borders do not meet copies of itself
    bool repeatsSideways = true;  // the same for its left and right borders
    Alpha alpha = Alpha::Opaque;
    int side = kSide;    // of a block texture, texels
    int frames = 1;      // side by side, equally wide; a sheet's are square
    bool loops = false;  // whether the first frame continues the last
    bool stands = true;  // a sprite with its feet on the lowest row
    int views = 1;       // of a sprite: rows, one for each of its sides
};

const std::vector<Entry>& catalogue();

const char* nameOf(Use use);

// The folder of its files in assets.
const char* folderOf(Use use);

}  // namespace slicecast::textures

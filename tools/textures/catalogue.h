// Every picture that the program draws: its file name, what it is good for, and how it is painted.
#pragma once

#include <string>
#include <vector>

#include "picture.h"

namespace slicecast::textures {

enum class Use { Wall, Floor, Roof, Ceiling, Sky, Test, SeeThrough, Sheet, Sprite };

// Which alphas a picture has: 255 alone; holes (0) and 255; blends between as well; or nothing but
// a hole.
enum class Alpha { Opaque, Holes, Blended, Nothing };

struct Entry {
    std::string name;  // the file is name.png
    Use use;
    Picture (*paint)();
    std::string wall = {};  // what it is painted on: its borders continue that texture
    bool repeatsUpwards =
        true;  // false: its upper and lower borders meet other things than its own copies
    bool repeatsSideways = true;  // the same for its left and right borders
    Alpha alpha = Alpha::Opaque;
    int frames = 1;      // side by side, equally wide; a sheet's are square
    bool loops = false;  // the first frame follows the last as any frame follows the one before
    bool stands = true;  // a sprite with its feet on the lowest row
};

const std::vector<Entry>& catalogue();

const char* nameOf(Use use);

// The folder of assets in which its files are.
const char* folderOf(Use use);

}  // namespace slicecast::textures

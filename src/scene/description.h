// A scene whose text has been checked and whose images have not been read yet.
#pragma once

#include "scene/scene.h"
#include "scene/source_text.h"
#include "world/world.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slicecast {

// Where a scene names an image file.
struct ImageReference {
    std::string file;
    std::string pointer;
    TextPosition place;
};

struct PanoramaReference {
    std::size_t map;  // index into World::maps
    ImageReference image;
};

// A texture's file, which may be a sheet of frames side by side; or one colour, without a file.
struct TextureReference {
    ImageReference image;
    std::optional<Colour> colour;
    int frames = 1;
    double rate = 0.0;                    // frames per second
    int views = 1;                        // of sprites only: rows of the sheet
    Material material = Material::stone;  // of textures only
};

// Something within a block. If that turns out to be opaque, nobody sees it.
struct HiddenThing {
    BlueprintId block;
    Fault warning;
};

struct SceneDescription {
    std::string fileName;
    World world;  // complete but for the images
    std::vector<TextureReference>
        textures;  // in the order of TextureId; a file named twice in the same way is one texture
    std::vector<TextureReference> sprites;  // in the order of SpriteId
    std::vector<PanoramaReference> panoramas;
    std::vector<HiddenThing> hiddenThings;
    std::vector<Aim> aims;
};

}  // namespace slicecast

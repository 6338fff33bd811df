// Reads a scene from disk: the text, then the images that it names, with paths relative to the
// scene's folder. Every program, tool and test opens scene files through this.
//
//     LoadedScene scene = readSceneFile("assets/scenes/first-walk.json");
//     for (const Fault& fault : scene.faults) print(describe(fault));
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace slicecast {

// No valid image needs a file this large.
inline constexpr std::uintmax_t kMaxImageBytes = 64u << 20;

// The world, or all faults. It is a fault if a file cannot be read, is too large, or is not a
// regular file; so a pipe cannot block the caller.
LoadedScene readSceneFile(const std::filesystem::path& scene, const Progress& progress = {});

// Where the shipped pictures and their table are: in the sources that this was built from.
std::filesystem::path shippedFolder();
std::string readPictureTable();  // kNoPictures if it cannot be read

// The images that a scene names, with paths relative to `folder`, by their names in the scene:
// `files` holds the bytes of those that could be read, `unread` the reasons why others could not,
// and perhaps a file of a similar name, in words to put behind a message. A shipped picture, named
// as shipped scenes name it, comes from its own folder if `folder` has none.
struct ReadImages {
    struct Unread {
        std::string why;
        std::string nearest;
    };
    SceneFiles files;
    std::map<std::string, Unread> unread;
};
ReadImages readImages(const ParsedScene& scene, const std::filesystem::path& folder);

}  // namespace slicecast

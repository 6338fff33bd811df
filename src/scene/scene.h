// Reading a scene file, in two steps because a page loads asynchronously:
//
//     ParsedScene scene = parseScene(text, "castle.json");        // checks the text, gives the names of the files that it needs
//     for (const std::string& name : scene.files) ...             // the caller brings their bytes
//     LoadedScene loaded = loadScene(std::move(scene), files);    // decodes the images and builds the world
//
// Both report all faults that they can reach, in the order of the text; a scene with any fault
// gives no world. At most kMaxFaults (limits.h) are listed, and then one more that says how many
// are not. Warnings are told like faults, but the scene loads: what they name is probably not meant
// so. What a scene file may hold is written down in assets/scene.schema.json.
#pragma once

#include "base/image.h"
#include "slicecast/fault.h"
#include "world/world.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

struct SceneDescription;  // the checked text; opaque

struct ParsedScene {
    std::unique_ptr<SceneDescription> description;  // null when there are faults
    std::vector<std::string>
        files;  // image files named by the scene, relative to it, each once, in order of appearance
    std::vector<Fault> faults;
    std::vector<Fault> warnings;  // none where there are faults

    ParsedScene();
    ParsedScene(ParsedScene&&) noexcept;
    ParsedScene& operator=(ParsedScene&&) noexcept;
    ~ParsedScene();
};

ParsedScene parseScene(std::string_view text, const std::string& fileName);

struct LoadedScene {
    std::optional<World> world;  // empty when there are faults
    std::vector<Fault> faults;
    std::vector<Fault> warnings = {};
};

// The bytes of the files by name; a name without an entry is a fault ("could not be read").
using SceneFiles = std::map<std::string, std::vector<std::uint8_t>>;

// Images that are decoded while other files are still on their way, as far as they are images.
class EarlyImages {
public:
    // Gives the pixels, none if it is no image. Who knows them already asks for `blank` ones, of
    // the size that the bytes tell, and writes them.
    std::span<Pixel> decode(const std::string& name, std::span<const std::uint8_t> bytes,
                            bool blank = false);
    // An empty one if there is none, or no longer.
    Image take(const std::string& name);

private:
    std::map<std::string, Image> images_;
    std::int64_t texels_ = 0;
};

// What has been decoded early is not decoded again; `files` has all of them. The scene becomes the
// world: nothing of it is copied, and none is left for a second one.
LoadedScene loadScene(ParsedScene scene, const SceneFiles& files, EarlyImages early = {});

// What a fault has found where an image is named: "\"brick.png\", which could not be read".
std::string imageFound(std::string_view name, std::string_view what);
inline constexpr std::string_view kUnreadImage = "which could not be read";

}  // namespace slicecast

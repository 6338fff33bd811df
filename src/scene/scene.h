// Reading a scene file, in two steps because a page loads asynchronously:
//
//     ParsedScene scene = parseScene(text, "castle.json");       // checks the text
//     for (const std::string& name : scene.files) ...            // the caller brings their bytes
//     LoadedScene loaded = loadScene(std::move(scene), files);   // images -> world
//
// A page must not stand still meanwhile, so each step can also be taken a little at a time:
//
//     SceneParser parser(text, "castle.json");
//     while (parser.next()) ...                                  // parser.share() grows to 1
//     ParsedScene scene = parser.take();
//
// A name that no texture or sprite of the scene has may be that of a shipped picture. They are
// listed in the table assets/pictures.json, which the parser takes as a text. Few scenes need it:
// without it, a SceneParser stops at the first such name, and gives nothing but `needsPictures`.
// Then parse the scene again with the table.
//
// Both report all faults that they can reach, in the order of the text, loadScene those of the text
// too; a scene with a fault gives no world. At most kMaxFaults (limits.h) are listed, and then one
// more that counts the others. A scene with warnings loads: they name probable mistakes.
// assets/scene.schema.json defines what a scene file may hold.
#pragma once

#include "base/image.h"
#include "slicecast/fault.h"
#include "world/world.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

class NameUses;

struct SceneDescription;  // the checked text; opaque

// Begins the names of files that are shipped, in the folder of the table. A scene cannot name such
// a file itself, because of the colon.
inline constexpr std::string_view kShippedFile = "slicecast:";
inline constexpr std::string_view kShippedTable = "slicecast:pictures.json";
inline constexpr std::string_view kNoPictures = "{}";  // a table without any

// Told the share of a work that is done, growing to 1.
using Progress = std::function<void(double share)>;

struct ParsedScene {
    std::unique_ptr<SceneDescription> description;  // null if the text is none of a scene
    std::vector<std::string>
        files;  // image files named by the scene, relative to it, each once, in order of appearance
    std::vector<Fault> faults;
    std::vector<Fault> warnings;  // none where there are faults
    bool needsPictures = false;

    ParsedScene();
    ParsedScene(ParsedScene&&) noexcept;
    ParsedScene& operator=(ParsedScene&&) noexcept;
    ~ParsedScene();
};

inline constexpr double kShareOfParsing = 0.2;  // of the progress of loading

// Of a text of 200 KB, each call of next() takes at most as long as some 12 simple pictures: see
// tests/worst/bounds.cpp. Of longer texts it may take longer.
class SceneParser {
public:
    // The texts must outlive this.
    SceneParser(std::string_view text, std::string fileName);
    SceneParser(SceneParser&&) noexcept;
    SceneParser& operator=(SceneParser&&) noexcept;
    ~SceneParser();

    // The table of shipped pictures, before the first next().
    void takePictures(std::string_view table);
    // Looks for more probable mistakes, for findUnreached; before the first next(). The names that
    // the scene uses are noted there meanwhile.
    void lookForMistakes(NameUses& uses);
    // Does a part of the work. False if none was left.
    bool next();
    // What is done of the work that is known, 0 to 1.
    double share() const;
    // Once, when all is done.
    ParsedScene take();

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

// Looks for mistakes, too. The progress is that of both steps: this one is the smaller part.
ParsedScene parseScene(std::string_view text, const std::string& fileName,
                       const Progress& progress = {}, std::string_view pictures = kNoPictures);

// What a player is to get to, and where the file states it: some of the world's finds, a notice,
// the gates of a kind, the goal, or a block. Or what is a mistake by itself: light that dims baked
// light, a place that nothing names, what else is to spare (spares.h), a sprite that may be a sheet
// of frames, and others. For findUnreached in unreached.h.
struct Aim {
    enum class What : std::uint8_t {
        finds,
        notice,
        gates,
        goal,
        block,
        light,
        place,
        spare,
        sheet,
        mistake
    };
    What what = What::finds;
    // Index into Quest::finds, Quest::notices, World::gateKinds, World::blueprints or
    // World::sprites
    std::size_t first = 0;
    std::size_t count = 1;
    Fault place;  // without words, but with those of what is to spare and of others
};

struct LoadedScene {
    std::optional<World> world;  // empty when there are faults
    std::vector<Fault> faults;
    std::vector<Fault> warnings = {};
    std::vector<Aim> aims = {};
};

// The bytes of the files by name; a name without an entry is a fault ("could not be read").
using SceneFiles = std::map<std::string, std::vector<std::uint8_t>>;

// Images that are decoded while other files are still being fetched.
class EarlyImages {
public:
    // Gives the pixels, none if it is no image. With `blank`, decodes nothing: gives pixels of the
    // size that the bytes state, for the caller to write.
    std::span<Pixel> decode(const std::string& name, std::span<const std::uint8_t> bytes,
                            bool blank = false);
    // Empty if there is none, or if it has been taken.
    Image take(const std::string& name);

private:
    std::map<std::string, Image> images_;
    std::int64_t texels_ = 0;
};

// Early images are not decoded again, but `files` must name them too. The scene's data moves into
// the world without a copy. Each call of next() decodes a file, or prepares a frame of a picture,
// or takes no longer than one of SceneParser's.
class SceneLoader {
public:
    // The files must outlive this.
    SceneLoader(ParsedScene scene, const SceneFiles& files, EarlyImages early = {});
    SceneLoader(SceneLoader&&) noexcept;
    SceneLoader& operator=(SceneLoader&&) noexcept;
    ~SceneLoader();

    // As those of SceneParser.
    bool next();
    double share() const;
    LoadedScene take();
    // Both, where a first picture is not waited for: null while work was left.
    std::unique_ptr<LoadedScene> nextOrTake();

private:
    struct Work;
    std::unique_ptr<Work> work_;  // null if the text has faults
    std::vector<Fault> faults_;   // of the text
};

LoadedScene loadScene(ParsedScene scene, const SceneFiles& files, EarlyImages early = {},
                      const Progress& progress = {});

// What a fault of an image has found: "\"brick.png\", which could not be read".
std::string imageFound(std::string_view name, std::string_view what);
inline constexpr std::string_view kUnreadImage = "which could not be read";

}  // namespace slicecast

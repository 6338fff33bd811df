// Makes scenes for searches and fuzzers, with all that the schema of scenes knows: the keys, what
// they may hold and how much of it come from assets/scene.schema.json, so that a new key takes part
// by itself.
//
//     SceneMaker maker(schemaText, pictures, 263);
//     std::string text = maker.fresh(random);              // a scene that need not load
//     text = maker.mended(text, "", faultsOf);             // one that loads, or ""
//     std::string other = maker.changed(text, random);     // the same with some changes
#pragma once

#include "base/random.h"
#include "slicecast/fault.h"

#include <rapidjson/document.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

inline constexpr std::size_t kMostSceneText = 200'000;  // bytes of a scene that is made

// Pictures that the scenes name.
struct ScenePictures {
    std::string wall;
    std::string seeThrough;
    std::string sheet;  // of a texture
    int sheetFrames = 2;
    std::string sprite;
    std::string walker;  // a sheet
    int walkerFrames = 2;
    std::string panorama;
};

class SceneMaker {
public:
    // The schema is valid; the widest map has so many tiles a side, at least 9.
    SceneMaker(std::string_view schema, ScenePictures pictures, int widest);

    // Text of a scene: a world of blocks, portals and objects, and then some changes.
    std::string fresh(Random& random) const;

    // The scene with some changes; itself if it is no JSON object or would become too long.
    std::string changed(const std::string& text, Random& random) const;

    // Until there are no faults, what they point at becomes what it is in the scene `before`, or
    // vanishes. Gives "" if that does not help.
    using FaultsOf = std::function<std::vector<Fault>(const std::string& text)>;
    std::string mended(std::string text, const std::string& before, const FaultsOf& faultsOf) const;

    // Counts the keys of a scene that has loaded. Those that were seldom met are tried more often,
    // and those that never were most.
    void count(const std::string& text);
    std::size_t keys() const { return keys_.size(); }
    // Those that no counted scene had, as "blueprint.gate.follows".
    std::vector<std::string> neverMet() const;

private:
    using Json = rapidjson::Value;
    class Change;

    // One way to read a schema, and what people are told about it.
    struct Way {
        const Json* schema = nullptr;
        std::string about;
    };
    struct Key {
        std::string name;
        long met = 0;
    };

    void addWays(const Json& schema, std::string about, std::vector<Way>& ways) const;
    std::vector<Way> waysOf(const Json& schema, const std::string& about = "") const;
    // The way that a value follows; without a schema if none fits.
    Way wayOf(const Json& value, const Json& schema, const std::string& about = "") const;
    // Of a member, null if the schema has none such.
    const Json* memberSchema(const Json& object, const Json& member) const;
    int addKeys(const Json& schema, const std::string& name);
    int weightOf(const Json& schema) const;
    void countIn(const Json& value, const Json& schema);

    rapidjson::Document schema_;
    ScenePictures pictures_;
    int widest_;
    std::map<const Json*, Key> keys_;             // by their schemas
    mutable std::map<const Json*, int> weights_;  // how many keys stand within
};

}  // namespace slicecast

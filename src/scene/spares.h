// What a scene has but does not use: textures, sprites and motions that nothing names, and
// characters of legends that no row has. Those who build worlds may mean to use it later.
#pragma once

#include "base/name_index.h"
#include "scene/json_tree.h"
#include "scene/names.h"
#include "world/world.h"

#include <string_view>
#include <utility>
#include <vector>

namespace slicecast {

struct Reading;

// Which names of which tables have been asked for.
class NameUses {
public:
    // The characters must outlive this.
    void note(const NameTable& table, std::string_view name);
    bool has(const NameTable& table, std::string_view name) const;

private:
    std::vector<std::pair<const NameTable*, NameIndex>> ofTables_;
};

// By BlueprintId: the blocks of the maps, and those that they were made from.
std::vector<bool> standingBlocks(const World& world);

// Adds an aim for each. `root` is the scene, which has been read without faults.
void findSpares(Reading& reading, JsonValue root, const NameUses& uses);

}  // namespace slicecast

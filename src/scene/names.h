// The names of a scene's textures, blueprints and maps; suggests the nearest one for an unknown
// name.
#pragma once

#include "base/name_index.h"
#include "base/nearest_name.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

// `; did you mean "brick"?`, or nothing.
std::string suggestion(std::string_view wanted, const std::vector<std::string_view>& names);

class NameTable {
public:
    // A known name keeps its number.
    void add(std::string_view name, std::uint16_t id);
    std::optional<std::uint16_t> find(std::string_view name) const;
    std::string suggestionFor(std::string_view wanted) const { return suggestion(wanted, order_); }

    // After names that could not be read, every unknown name counts as number 0.
    void takeAny() { takesAny_ = true; }

private:
    // Names are views into the scene's tree, which outlives the tables.
    NameIndex ids_;
    std::vector<std::string_view> order_;
    bool takesAny_ = false;
};

}  // namespace slicecast

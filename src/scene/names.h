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

class JsonValue;

// `; did you mean "brick"?`, or nothing.
std::string suggestion(std::string_view wanted, const std::vector<std::string_view>& names);

// Names that count as known although no table has them.
class MoreNames {
public:
    virtual ~MoreNames() = default;
    // Makes what the value, a text, names; nothing if there is no such name.
    virtual std::optional<std::uint16_t> bring(JsonValue value) = 0;
    virtual void list(std::vector<std::string_view>& names) const = 0;
};

class NameTable {
public:
    // A known name keeps its number.
    void add(std::string_view name, std::uint16_t id);
    std::optional<std::uint16_t> find(std::string_view name) const;
    std::string suggestionFor(std::string_view wanted) const;

    // Where to look for unknown names.
    void lookIn(MoreNames& more) {
        more_ = &more;
        awaitsMore_ = false;
    }
    MoreNames* more() const { return more_; }
    // Whether that is still to come: then an unknown name is no fault yet.
    void awaitMore() { awaitsMore_ = true; }
    bool awaitsMore() const { return awaitsMore_; }

    // After names that could not be read, every unknown name counts as number 0.
    void takeAny() { takesAny_ = true; }

private:
    // Names are views into the scene's tree, which outlives the tables.
    NameIndex ids_;
    std::vector<std::string_view> order_;
    MoreNames* more_ = nullptr;
    bool awaitsMore_ = false;
    bool takesAny_ = false;
};

}  // namespace slicecast

// Legends: which blueprint or texture a sign of a grid stands for (source_text.h).
#pragma once

#include "base/name_index.h"
#include "scene/checker.h"
#include "scene/names.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slicecast {

class Legend {
public:
    // '.' and ' ' have a meaning that no scene can change: what an empty cell is, or a floor's own
    // texture.
    Legend(std::uint16_t dot, std::uint16_t space);

    // The text of a sign must outlive the legend.
    void set(std::string_view sign, std::uint16_t id);
    std::optional<std::uint16_t> find(std::string_view sign) const;

    // After a faulty legend, unknown signs count as known, with number 0.
    void takeAny() { takesAny_ = true; }

    // What has been set, in that order.
    const std::vector<std::pair<std::string_view, std::uint16_t>>& entries() const {
        return entries_;
    }

    // `'#', '=', '.' or a space`, for messages.
    std::string characters() const;

private:
    static constexpr std::int32_t kNone = -1;
    std::int32_t entryOf(std::string_view sign) const;  // index into entries_

    std::uint16_t dot_;
    std::uint16_t space_;
    std::array<std::int32_t, 128> ascii_;  // index into entries_
    NameIndex others_;                     // the same
    std::vector<std::pair<std::string_view, std::uint16_t>> entries_;
    bool takesAny_ = false;
};

// Adds the members of a legend object, whose values are names out of `names`; `what` says of what:
// "blueprint" or "texture". Characters defined before get their new meaning. Without `names`, a
// member's number counts the members before it, and its value is not looked at.
void readLegend(Checker& checker, JsonValue value, const NameTable* names, const char* what,
                Legend& legend);

// The number of tiles of a grid.
struct GridSize {
    int width = 0;
    int depth = 0;
};

// Writes the number of each sign of a row to `ids`. Reports signs that the legend lacks, whose
// entries stay as they are, and rows that are not `width` signs long. With `spacesKeep`, the
// entries of spaces stay as well.
void readRow(Checker& checker, JsonValue value, int row, int width, const Legend& legend,
             std::vector<std::uint16_t>& ids, bool spacesKeep = false);

// The number of a text that is one sign of the legend. Reports what it is else, and returns 0.
std::uint16_t readSign(Checker& checker, JsonValue value, const Legend& legend);

}  // namespace slicecast

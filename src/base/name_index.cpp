#include "base/name_index.h"

namespace slicecast {

std::uint32_t NameIndex::add(std::string_view name, std::uint32_t number) {
    return numbers_.emplace(name, number).first->second;
}

std::optional<std::uint32_t> NameIndex::find(std::string_view name) const {
    const auto found = numbers_.find(name);
    return found != numbers_.end() ? std::optional(found->second) : std::nullopt;
}

}  // namespace slicecast

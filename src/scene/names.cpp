#include "scene/names.h"

#include "base/words.h"

namespace slicecast {

std::string suggestion(std::string_view wanted, const std::vector<std::string_view>& names) {
    const std::string_view nearest = nearestName(wanted, names);
    return nearest.empty() ? std::string() : words("; did you mean \"", nearest, "\"?");
}

std::string NameTable::suggestionFor(std::string_view wanted) const {
    std::vector<std::string_view> names = order_;
    if (more_ != nullptr) more_->list(names);
    return suggestion(wanted, names);
}

void NameTable::add(std::string_view name, std::uint16_t id) {
    if (ids_.find(name)) return;
    ids_.add(name, id);
    order_.push_back(name);
}

std::optional<std::uint16_t> NameTable::find(std::string_view name) const {
    if (const auto id = ids_.find(name)) return static_cast<std::uint16_t>(*id);
    if (takesAny_) return std::uint16_t{0};
    return std::nullopt;
}

}  // namespace slicecast

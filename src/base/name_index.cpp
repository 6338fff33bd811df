#include "base/name_index.h"

namespace slicecast {
namespace {

constexpr std::size_t kFirstPlaces = 16;

// FNV-1a.
std::uint32_t hashOf(std::string_view name) {
    std::uint32_t hash = 2166136261u;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash ^ (hash >> 15);
}

}  // namespace

// Where it stands, or would stand.
std::size_t NameIndex::placeOf(std::string_view name) const {
    const std::size_t mask = entries_.size() - 1;
    std::size_t place = hashOf(name) & mask;
    while (entries_[place].isTaken && entries_[place].name != name) place = (place + 1) & mask;
    return place;
}

void NameIndex::grow() {
    std::vector<Entry> before(entries_.empty() ? kFirstPlaces : 2 * entries_.size());
    before.swap(entries_);
    for (const Entry& entry : before) {
        if (entry.isTaken) entries_[placeOf(entry.name)] = entry;
    }
}

std::uint32_t NameIndex::add(std::string_view name, std::uint32_t number) {
    if (2 * count_ >= entries_.size()) grow();
    Entry& entry = entries_[placeOf(name)];
    if (!entry.isTaken) {
        entry = {name, number, true};
        ++count_;
    }
    return entry.number;
}

std::optional<std::uint32_t> NameIndex::find(std::string_view name) const {
    if (entries_.empty()) return std::nullopt;
    const Entry& entry = entries_[placeOf(name)];
    return entry.isTaken ? std::optional(entry.number) : std::nullopt;
}

}  // namespace slicecast

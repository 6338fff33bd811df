#include "base/name_index.h"

namespace slicecast {
namespace {

constexpr std::size_t kFirstPlaces = 16;
// Names that come together by chance are fewer. More were chosen to do so.
constexpr std::size_t kMostTogether = 64;

// FNV-1a.
std::uint32_t hashOf(std::string_view name, std::uint32_t basis) {
    std::uint32_t hash = 2166136261u + basis;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash ^ (hash >> 15);
}

}  // namespace

// Where it stands, or would stand.
std::size_t NameIndex::placeOf(std::string_view name) const {
    const std::size_t mask = entries_.size() - 1;
    std::size_t place = hashOf(name, basis_) & mask;
    while (entries_[place].isTaken && entries_[place].name != name) place = (place + 1) & mask;
    return place;
}

void NameIndex::rebuild(std::size_t places) {
    std::vector<Entry> before(places);
    before.swap(entries_);
    for (const Entry& entry : before) {
        if (entry.isTaken) entries_[placeOf(entry.name)] = entry;
    }
}

std::uint32_t NameIndex::add(std::string_view name, std::uint32_t number) {
    if (2 * count_ >= entries_.size())
        rebuild(entries_.empty() ? kFirstPlaces : 2 * entries_.size());
    std::size_t place = placeOf(name);
    const std::size_t mask = entries_.size() - 1;
    if (((place - hashOf(name, basis_)) & mask) > kMostTogether) {
        basis_ += 2654435769u;
        rebuild(entries_.size());
        place = placeOf(name);
    }
    Entry& entry = entries_[place];
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

// Finds numbers by names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace slicecast {

class NameIndex {
public:
    // Gives a new name this number, and returns the number of a known one. The characters must
    // outlive the index.
    std::uint32_t add(std::string_view name, std::uint32_t number);
    std::optional<std::uint32_t> find(std::string_view name) const;

private:
    struct Entry {
        std::string_view name;
        std::uint32_t number = 0;
        bool isTaken = false;
    };

    std::size_t placeOf(std::string_view name) const;
    void rebuild(std::size_t places);

    // A name stands at the place of its hash, or in the next free one after it. At least half of
    // the places are free.
    std::vector<Entry> entries_;  // as many as a power of two
    std::size_t count_ = 0;
    std::uint32_t basis_ = 0;  // of the hash; another one where many names have come together
};

}  // namespace slicecast

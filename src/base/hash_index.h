// Finds things of a vector by their keys: a hash table that holds their indices. Things and keys
// stay with those who use it.
//
//     std::uint32_t at = index.find(hash, [&](std::uint32_t i) { return things[i].key == key; });
//     if (at == HashIndex::kNone) {
//         things.push_back(...);
//         index.add(hash, [&](std::uint32_t i) { return hashOf(things[i].key); });
//     }
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

// Of a key's bits, those that differ most between similar keys, lowest.
inline std::uint64_t scattered(std::uint64_t key) {
    return key * 0x9e3779b97f4a7c15u >> 32;
}

class HashIndex {
public:
    static constexpr std::uint32_t kNone = 0xffffffff;

    // `slots`: at first, a power of two.
    explicit HashIndex(std::size_t slots = 16) : slots_(slots) {}

    // How many indices were added.
    std::uint32_t count() const { return count_; }
    std::size_t bytes() const { return slots_.size() * sizeof(std::uint32_t); }

    // Keeps its memory.
    void clear() {
        count_ = 0;
        slots_.assign(slots_.size(), 0);
    }

    // The first index with this hash of which isIt(index) is true, or kNone.
    template <typename IsIt>
    std::uint32_t find(std::uint64_t hash, IsIt&& isIt) const {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t slot = hash & mask; slots_[slot] != 0; slot = (slot + 1) & mask) {
            if (isIt(slots_[slot] - 1)) return slots_[slot] - 1;
        }
        return kNone;
    }

    // Adds the next index, count(). hashOf(index) is the hash of one that was added before.
    template <typename HashOf>
    void add(std::uint64_t hash, HashOf&& hashOf) {
        if (2 * (count_ + 1) > slots_.size()) {
            slots_.assign(2 * slots_.size(), 0);
            for (std::uint32_t i = 0; i < count_; ++i) put(hashOf(i), i);
        }
        put(hash, count_++);
    }

private:
    void put(std::uint64_t hash, std::uint32_t index) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t slot = hash & mask;
        while (slots_[slot] != 0) slot = (slot + 1) & mask;
        slots_[slot] = index + 1;
    }

    // With open addressing: an index + 1, 0 for none. At least half of them are free.
    std::vector<std::uint32_t> slots_;
    std::uint32_t count_ = 0;
};

}  // namespace slicecast

// Finds things of a vector by their keys: a hash table that holds their indices. Things and keys
// stay with those who use it.
//
//     std::uint32_t at = index.find(hash, [&](std::uint32_t i) { return things[i].key == key; });
//     if (at == HashIndex::kNone) {
//         index.add(hash);
//         things.push_back(...);
//     }
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

// A hash for a key. Similar keys get hashes that differ in their low bits.
inline std::uint32_t scattered(std::uint64_t key) {
    return static_cast<std::uint32_t>(key * 0x9e3779b97f4a7c15u >> 32);
}

class HashIndex {
public:
    static constexpr std::uint32_t kNone = 0xffffffff;

    // `slots`: at first, a power of two.
    explicit HashIndex(std::size_t slots = 16) : slots_(slots) {}

    // How many indices were added.
    std::uint32_t count() const { return count_; }
    std::size_t bytes() const { return slots_.size() * sizeof(Slot); }

    // Keeps its memory.
    void clear();

    // The first index with this hash of which isIt(index) is true, or kNone.
    template <typename IsIt>
    std::uint32_t find(std::uint32_t hash, IsIt&& isIt) const {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t i = hash & mask; slots_[i].next != 0; i = (i + 1) & mask) {
            const Slot& slot = slots_[i];
            if (slot.hash == hash && isIt(slot.next - 1)) return slot.next - 1;
        }
        return kNone;
    }

    // Adds the next index, count().
    void add(std::uint32_t hash);

private:
    struct Slot {
        std::uint32_t hash = 0;
        std::uint32_t next = 0;  // the index + 1, 0 for none
    };

    // With open addressing; at least half of them are free.
    std::vector<Slot> slots_;
    std::uint32_t count_ = 0;
};

}  // namespace slicecast

// Things that are made when first asked for by a key. Forgetting them all keeps their memory, so
// that the next ones need not allocate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace slicecast {

template <typename Key, typename Thing>
class KeyedPool {
public:
    void forgetAll() {
        used_ = 0;
        slots_.assign(slots_.size(), 0);
    }

    // The thing of a key, whose hash is given. A new one, which may have been another's before
    // forgetAll, is first given to `make`. It stays where it is.
    template <typename Make>
    Thing& find(const Key& key, std::uint64_t hash, Make&& make) {
        std::size_t slot = hash & (slots_.size() - 1);
        for (; slots_[slot] != 0; slot = (slot + 1) & (slots_.size() - 1)) {
            const Entry& entry = entries_[slots_[slot] - 1];
            if (entry.key == key) return *entry.thing;
        }
        if (used_ == entries_.size()) entries_.push_back({key, hash, std::make_unique<Thing>()});
        Entry& entry = entries_[used_++];
        entry.key = key;
        entry.hash = hash;
        slots_[slot] = static_cast<std::uint32_t>(used_);
        if (2 * used_ > slots_.size()) grow();
        Thing& thing = *entry.thing;
        make(thing);
        return thing;
    }

private:
    struct Entry {
        Key key;
        std::uint64_t hash;
        std::unique_ptr<Thing> thing;
    };

    // Not inlined: it is rare.
    __attribute__((noinline)) void grow() {
        slots_.assign(2 * slots_.size(), 0);
        for (std::size_t i = 0; i < used_; ++i) {
            std::size_t slot = entries_[i].hash & (slots_.size() - 1);
            while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = static_cast<std::uint32_t>(i + 1);
        }
    }

    std::vector<Entry> entries_;
    std::size_t used_ = 0;
    // A table with open addressing: index of an entry + 1, 0 for none. The size is a power of two.
    std::vector<std::uint32_t> slots_ = std::vector<std::uint32_t>(16);
};

}  // namespace slicecast

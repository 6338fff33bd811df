// Things that are made when first asked for by a key. Forgetting them all keeps their memory, so
// that the next ones need not allocate.
#pragma once

#include "base/hash_index.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace slicecast {

template <typename Key, typename Thing>
class KeyedPool {
public:
    void forgetAll() { index_.clear(); }

    // The thing of a key, whose hash is given. A new one, which may have been another's before
    // forgetAll, is first given to `make`. It stays where it is.
    template <typename Make>
    Thing& find(const Key& key, std::uint32_t hash, Make&& make) {
        const std::uint32_t known =
            index_.find(hash, [&](std::uint32_t i) { return entries_[i].key == key; });
        if (known != HashIndex::kNone) return *entries_[known].thing;
        if (index_.count() == entries_.size()) entries_.push_back({key, std::make_unique<Thing>()});
        Entry& entry = entries_[index_.count()];
        entry.key = key;
        index_.add(hash);
        make(*entry.thing);
        return *entry.thing;
    }

private:
    struct Entry {
        Key key;
        std::unique_ptr<Thing> thing;
    };
    std::vector<Entry> entries_;
    HashIndex index_;
};

}  // namespace slicecast

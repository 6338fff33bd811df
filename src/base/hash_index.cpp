#include "base/hash_index.h"

namespace slicecast {

void HashIndex::clear() {
    count_ = 0;
    slots_.assign(slots_.size(), {});
}

void HashIndex::add(std::uint32_t hash) {
    const auto put = [&](const Slot& added) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t i = added.hash & mask;
        while (slots_[i].next != 0) i = (i + 1) & mask;
        slots_[i] = added;
    };
    if (2 * (count_ + std::size_t{1}) > slots_.size()) {
        std::vector<Slot> old(2 * slots_.size());
        old.swap(slots_);
        for (const Slot& slot : old) {
            if (slot.next != 0) put(slot);
        }
    }
    put({hash, ++count_});
}

}  // namespace slicecast

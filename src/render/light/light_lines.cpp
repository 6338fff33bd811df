#include "render/light/light_lines.h"

#include "render/light/lit_texels.h"
#include "render/pixels/lanes.h"

#include <algorithm>

namespace slicecast {

// What is kept is at most twice what a whole picture needs, as in LitImages.
void LightLines::beginFrame() {
    if (mostKept_ == 0) mostKept_ = std::max(2 * lines_.size(), kLeastKept);
    if (lines_.size() > mostKept_) clear();
}

void LightLines::clear() {
    std::fill(entries_.begin(), entries_.end(), Entry{});
    count_ = 0;
    lines_.clear();
    mostKept_ = 0;
}

std::uint32_t LightLines::make(std::uint64_t key, std::uint32_t change, int levelBits,
                               const FaceNodes& nodes, std::uint32_t made) {
    Entry& entry = entryOf(key, levelBits);
    entry.change = change;
    if (entry.made == made) return entry.first;
    entry.made = made;
    LightLine* line = lines_.data() + entry.first;
    if (levelBits == 0) {
        const U16x8 middle = 128 * bytesInTurn(nodes.middle(), nodes.middle()) + 64;
        for (int i = 0; i < 4; ++i) storeVector(line + i, middle);
        return entry.first;
    }
    const int size = 1 << levelBits;
    for (int squareB = 0; squareB < 2; ++squareB) {
        for (int texel = 0; texel < size; ++texel, ++line) {
            const std::int32_t a = middleOf(texel, size);
            const auto weight = static_cast<std::uint16_t>((a & 32767) >> 8);
            const Pixel* const square =
                nodes.nodes.data() + FaceNodes::index(a >> 15, squareB, 0, 0);
            const U16x8 low = bytesInTurn(square[0], square[1]);
            const U16x8 high = bytesInTurn(square[2], square[3]);
            storeVector(line, 128 * low + 64 + weight * (high - low));
        }
    }
    return entry.first;
}

// Finds or adds an entry; `made` of a new one is kNone.
LightLines::Entry& LightLines::entryOf(std::uint64_t key, int levelBits) {
    const auto placeOf = [&](std::uint64_t wanted) -> Entry& {
        std::size_t slot = slotOf(wanted);
        while (entries_[slot].key != 0 && entries_[slot].key != wanted) slot = (slot + 1) & mask_;
        return entries_[slot];
    };
    Entry& found = placeOf(key);
    if (found.key != 0) return found;
    if (2 * (count_ + 1) > entries_.size()) {
        std::vector<Entry> old(2 * entries_.size());
        old.swap(entries_);
        mask_ = entries_.size() - 1;
        for (const Entry& entry : old) {
            if (entry.key != 0) placeOf(entry.key) = entry;
        }
    }
    ++count_;
    Entry& added = placeOf(key);
    added.key = key;
    added.first = static_cast<std::uint32_t>(lines_.size());
    lines_.resize(lines_.size() + (std::size_t{2} << std::max(levelBits, 1)));
    return added;
}

}  // namespace slicecast

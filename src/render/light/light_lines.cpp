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
    entries_.clear();
    index_.clear();
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
    const std::uint32_t known = indexOf(key);
    if (known != kNone) return entries_[known];
    index_.add(scattered(key));
    Entry& added = entries_.emplace_back();
    added.key = key;
    added.first = static_cast<std::uint32_t>(lines_.size());
    lines_.resize(lines_.size() + (std::size_t{2} << std::max(levelBits, 1)));
    return added;
}

}  // namespace slicecast

// The light of planes along their columns of texels, kept from frame to frame: the nodes as they
// are between those along the other axis. From them a texel's light is one step more.
#pragma once

#include "base/hash_index.h"
#include "render/light/light_samples.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

// Of the part of a column of texels that lies in one square: red, green, blue and alpha at its
// lower end along b and at its higher end, in turn; 128 times the light, plus 64.
struct alignas(16) LightLine {
    std::array<std::uint16_t, 8> ends{};
};

// A face's lines for a level of detail follow each other: those of the lower squares along b, by
// texel, then those of the higher ones. For a single texel there are four, all of its light.
class LightLines {
public:
    // Once before each frame. Forgets all if much is kept that no recent picture needs.
    void beginFrame();

    void clear();

    static std::uint64_t keyOf(const LitFaceAt& face, int levelBits) {
        return face.key() | static_cast<std::uint64_t>(levelBits) << 16 | 128;
    }
    static constexpr std::uint32_t kNone = HashIndex::kNone;

    // The index of the first line, if they have been asked for since the last change of the map's
    // light; kNone if not.
    std::uint32_t find(std::uint64_t key, std::uint32_t change) const {
        const std::uint32_t i = indexOf(key);
        return i != kNone && entries_[i].change == change ? entries_[i].first : kNone;
    }
    // The same for the first time since then: makes them unless the nodes are those that were
    // `made` at the same change as before.
    std::uint32_t make(std::uint64_t key, std::uint32_t change, int levelBits,
                       const FaceNodes& nodes, std::uint32_t made);

    // All lines; valid until the next call of make().
    const LightLine* all() const { return lines_.data(); }

    std::size_t kept() const { return lines_.size(); }

private:
    struct Entry {
        std::uint64_t key = 0;
        std::uint32_t first = 0;
        std::uint32_t change = 0;
        std::uint32_t made = kNone;
    };
    static constexpr std::size_t kLeastKept = 8192;  // lines

    std::uint32_t indexOf(std::uint64_t key) const {
        return index_.find(scattered(key), [&](std::uint32_t i) { return entries_[i].key == key; });
    }
    Entry& entryOf(std::uint64_t key, int levelBits);

    std::vector<Entry> entries_;
    HashIndex index_;  // of these, by key
    std::vector<LightLine> lines_;
    std::size_t mostKept_ = 0;  // 0: to be found by the next frame
};

}  // namespace slicecast

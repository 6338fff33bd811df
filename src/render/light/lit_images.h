// Lit texels that are kept from frame to frame: levels of a side's texture, times the side's
// light. Each is lit once, however often it is painted.
#pragma once

#include "base/hash_index.h"
#include "render/light/light_scene.h"
#include "render/light/lit_texels.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace slicecast {

// A level of detail on a side, of at most 64 texels: larger ones are lit as they are read. The
// texture may have moved along the side's axes.
struct LitLevel {
    LitFaceAt face;
    const TextureLevel& level;
    Coordinate shiftA;
    Coordinate shiftB;

    // Levels of one key take each other's place: those of other frames of a texture, or of a
    // texture that has moved. Never 0: no face has this bit.
    std::uint64_t key() const {
        return face.key() | static_cast<std::uint64_t>(level.bits) << 16 | 128;
    }
};
inline constexpr int kLitLevelBits = 6;

class LitImages {
public:
    // Once before each frame. Forgets all if much is kept that no recent picture needs. `changed`:
    // the light of some faces.
    void beginFrame(bool changed);

    void clear();

    // How much is kept, pixels.
    std::size_t kept() const { return kept_; }

    // The texels of a level that have been asked for since the light changed, in its order; else
    // null.
    const Pixel* find(const LitLevel& wanted) const {
        const std::uint32_t i = indexOf(wanted.key());
        if (i == HashIndex::kNone) return nullptr;
        const Image& image = images_[i];
        return image.change == change_ && image.shows(wanted) ? image.pixels : nullptr;
    }

    // What a side's light is made from. Two that are equal light a face equally.
    struct Source {
        std::uint32_t record = 0;
        std::uint32_t made = 0;

        friend bool operator==(const Source&, const Source&) = default;
    };
    // The same for the first time since then: lights them unless they are kept.
    const Pixel* make(const LitLevel& wanted, const FaceNodes& nodes, Source source);

private:
    struct Image {
        std::uint64_t key = 0;
        const Pixel* from = nullptr;
        Coordinate shiftA;
        Coordinate shiftB;
        std::uint32_t change = 0;
        Source source;
        Pixel* pixels = nullptr;

        bool shows(const LitLevel& wanted) const {
            return from == wanted.level.texels.data() && shiftA == wanted.shiftA &&
                   shiftB == wanted.shiftB;
        }
    };
    // Pixels are allocated in pieces of so many.
    static constexpr std::size_t kPiece = 16'384;
    static constexpr std::size_t kLeastKept = 32'768;  // pixels, and images are worth
    static constexpr std::size_t kWorth = 16;          // so many pixels each

    std::uint32_t indexOf(std::uint64_t key) const {
        return index_.find(scattered(key), [&](std::uint32_t i) { return images_[i].key == key; });
    }
    Image& imageOf(std::uint64_t key);
    Pixel* allocate(std::size_t pixels);

    std::vector<Image> images_;
    HashIndex index_;           // of these, by key
    std::uint32_t change_ = 0;  // of the light
    std::vector<std::unique_ptr<Pixel[]>> pieces_;
    std::size_t piece_ = 0;  // that is being filled
    std::size_t used_ = 0;   // of that
    std::size_t kept_ = 0;
    std::size_t mostKept_ = 0;  // 0: to be found by the next frame
};

}  // namespace slicecast

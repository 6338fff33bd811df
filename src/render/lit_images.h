// Lit texels that are kept from frame to frame: squares of a face's texture, times the face's
// light. Each is lit once, however often it is painted.
#pragma once

#include "render/light_scene.h"
#include "render/lit_texels.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace slicecast {

// A square of a level of detail on a face. The texture may have moved along the face's axes.
struct LitSquare {
    LitFaceAt face;
    const TextureLevel& level;
    std::uint32_t u = 0;  // of the square within the level, in squares
    std::uint32_t v = 0;
    Coordinate shiftA;
    Coordinate shiftB;

    int bits() const { return litSquareBits(level.bits); }
    // Squares of one key take each other's place: those of other frames of a texture, or of a
    // texture that has moved. Never 0: no face has this bit.
    std::uint64_t key() const {
        return face.key() | std::uint64_t{v << 4 | u} << 56 |
               static_cast<std::uint64_t>(level.bits) << 16 | 128;
    }
};

class LitImages {
public:
    // Once before each frame. Forgets all if much is kept that no recent picture needs. `changed`:
    // the light of some faces.
    void beginFrame(bool changed);

    void clear();

    // How much is kept, pixels.
    std::size_t kept() const { return kept_; }

    // The texels of a square that have been asked for since the light changed; else null. In the
    // order of the level's: (u, v) of the square at (u << bits) + v.
    const Pixel* find(const LitSquare& square) const {
        const std::uint64_t key = square.key();
        std::size_t slot = slotOf(key);
        while (images_[slot].key != key) {
            if (images_[slot].key == 0) return nullptr;
            slot = (slot + 1) & (images_.size() - 1);
        }
        const Image& image = images_[slot];
        return image.change == change_ && image.shows(square) ? image.pixels : nullptr;
    }

    // What a square's light is made from. Two that are equal light a face equally.
    struct Source {
        std::uint32_t record = 0;
        std::uint32_t made = 0;

        friend bool operator==(const Source&, const Source&) = default;
    };
    // The same for the first time since then: lights them unless they are kept.
    const Pixel* make(const LitSquare& square, const FaceNodes& nodes, Source source);

private:
    struct Image {
        std::uint64_t key = 0;  // 0: none
        const Pixel* from = nullptr;
        Coordinate shiftA;
        Coordinate shiftB;
        std::uint32_t change = 0;
        Source source;
        Pixel* pixels = nullptr;

        bool shows(const LitSquare& square) const {
            return from == square.level.texels.data() && shiftA == square.shiftA &&
                   shiftB == square.shiftB;
        }
    };
    // Pixels are allocated in pieces of so many.
    static constexpr std::size_t kPiece = 16'384;
    static constexpr std::size_t kLeastKept = 32'768;  // pixels, and images are worth
    static constexpr std::size_t kWorth = 16;          // so many pixels each

    std::size_t slotOf(std::uint64_t key) const {
        return static_cast<std::size_t>(key * 0x9e3779b97f4a7c15u >> 32) & (images_.size() - 1);
    }
    Image& imageOf(std::uint64_t key);
    Pixel* allocate(std::size_t pixels);

    std::vector<Image> images_ = std::vector<Image>(64);  // a hash table, at least half of it free
    std::size_t count_ = 0;                               // of images
    std::uint32_t change_ = 0;                            // of the light
    std::vector<std::unique_ptr<Pixel[]>> pieces_;
    std::size_t piece_ = 0;  // that is being filled
    std::size_t used_ = 0;   // of that
    std::size_t kept_ = 0;
    std::size_t mostKept_ = 0;  // 0: to be found by the next frame
};

}  // namespace slicecast

#include "render/light/lit_images.h"

#include <algorithm>

namespace slicecast {

// What is kept is at most twice what a whole picture needs, so that pictures like the last ones
// find all that they show. Pictures of another place then begin anew.
void LitImages::beginFrame(bool changed) {
    if (changed) ++change_;
    if (mostKept_ == 0) mostKept_ = std::max(2 * kept_, kLeastKept);
    if (kept_ > mostKept_) clear();
}

void LitImages::clear() {
    images_.clear();
    index_.clear();
    piece_ = 0;
    used_ = 0;
    kept_ = 0;
    mostKept_ = 0;
}

const Pixel* LitImages::make(const LitLevel& wanted, const FaceNodes& nodes, Source source) {
    const int bits = wanted.level.bits;
    Image& image = imageOf(wanted.key());
    image.change = change_;
    if (image.pixels == nullptr) {
        image.pixels = allocate(std::size_t{1} << (2 * bits));
    } else if (image.source == source && image.shows(wanted)) {
        return image.pixels;
    }
    image.from = wanted.level.texels.data();
    image.shiftA = wanted.shiftA;
    image.shiftB = wanted.shiftB;
    image.source = source;
    const int size = 1 << bits;
    const FaceTexels texels(wanted.level, wanted.face.face, wanted.shiftA, wanted.shiftB);
    for (int u = 0; u < size; ++u)
        lightColumn(image.pixels + (u << bits), u, 0, size, texels, nodes);
    return image.pixels;
}

LitImages::Image& LitImages::imageOf(std::uint64_t key) {
    const std::uint32_t known = indexOf(key);
    if (known != HashIndex::kNone) return images_[known];
    index_.add(scattered(key));
    kept_ += kWorth;
    Image& added = images_.emplace_back();
    added.key = key;
    return added;
}

Pixel* LitImages::allocate(std::size_t pixels) {
    kept_ += pixels;
    if (!pieces_.empty() && used_ + pixels > kPiece) {
        ++piece_;
        used_ = 0;
    }
    if (piece_ == pieces_.size()) pieces_.emplace_back(new Pixel[kPiece]);
    Pixel* const begin = pieces_[piece_].get() + used_;
    used_ += pixels;
    return begin;
}

}  // namespace slicecast

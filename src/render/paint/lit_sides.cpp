#include "render/paint/lit_sides.h"

namespace slicecast {
namespace {

// Reads a texel so that the memory near it is there when it is needed.
void readSoon(const Pixel* texel) {
#ifdef __wasm__
    asm volatile("" : : "r"(*texel));
#else
    __builtin_prefetch(texel);
#endif
}

}  // namespace

void LitSides::find(const ColumnSpans& column) {
    count_ = next_ = 0;
    for (const Span& span : column.spans) {
        if (count_ == found_.size()) return;
        if (span.what != FilledRows::What::side || span.layer || !isKept(span)) continue;
        const Pixel* const texels = texelsOf(span);
        found_[count_++] = texels;
        readSoon(texels + (span.column.start >> span.column.shift));
    }
}

bool LitSides::isKept(const Span& span) const {
    const TexelColumn& column = span.column;
    const FrameTexture& texture = frame_.textures[span.image];
    const Detail& detail = frame_.detail;
    return span.vista->lit != nullptr && !span.glow &&
           !detail.isSmooth(column.detail, column.depth, texture.size) &&
           texture.levels[column.detail].bits <= kLitLevelBits;
}

const Pixel* LitSides::of(const Span& span) {
    return next_ < count_ && !span.layer ? found_[next_++] : texelsOf(span);
}

const Pixel* LitSides::texelsOf(const Span& span) const {
    const TextureLevel& level = frame_.textures[span.image].levels[span.column.detail];
    const LitLevel shown = {faceOf(span), level, span.slide, span.rise};
    const Pixel* texels = span.vista->lit->knownTexels(shown);
    if (texels == nullptr) texels = span.vista->lit->makeTexels(shown);
    return texels + (span.column.texels - level.texels.data());
}

}  // namespace slicecast

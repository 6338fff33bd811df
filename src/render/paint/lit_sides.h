// The lit texels of a slice's sides, found before one of them is painted, so that many reads of
// memory wait together.
#pragma once

#include "render/spans/slice_spans.h"
#include "render/view/frame.h"

#include <array>
#include <cstddef>

namespace slicecast {

// Where a side's light is.
inline LitFaceAt faceOf(const Span& side) {
    return {side.tiles.fromX, side.tiles.fromY, side.level, static_cast<LitFace>(side.face)};
}

class LitSides {
public:
    // The frame must outlive this.
    explicit LitSides(const Frame& frame) : frame_(frame) {}

    // Finds the texels of a column's first opaque sides.
    void find(const ColumnSpans& column);
    // Whether a side's texels are kept with the baked light on them.
    bool isKept(const Span& span) const;
    // The lit texels of a side's column, if they are kept. Opaque sides are asked for in their
    // order.
    const Pixel* of(const Span& span);

private:
    const Pixel* texelsOf(const Span& span) const;

    const Frame& frame_;
    std::array<const Pixel*, 32> found_;
    std::size_t count_ = 0;
    std::size_t next_ = 0;
};

}  // namespace slicecast

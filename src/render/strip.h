// A strip of slices: columns in memory that stays in the cache, and their transfer into the rows of
// a picture.
//
// Columns written directly into a picture whose rows are a few kilobytes apart fall on a handful of
// cache sets and cost five to ten times as much; a strip of 16 columns is one cache line of each
// row.
// row.
#pragma once

#include "slicecast/picture.h"

#include <vector>

namespace slicecast {

inline constexpr int kStripColumns = 16;

class Strip {
public:
    // Allocates columns of `height` rows.
    void resize(int height);

    Pixel* column(int index) {
        return pixels_.data() + static_cast<std::ptrdiff_t>(index) * stride_;
    }

    // Writes the first `columns` columns into the picture, starting at column `x`.
    void copyTo(const Picture& picture, int x, int columns) const;

private:
    int height_ = 0;
    int stride_ = 0;  // pixels from one column to the next
    std::vector<Pixel> pixels_;
};

}  // namespace slicecast

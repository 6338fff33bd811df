// A strip of slices: columns in memory that stays in the cache, and their transfer into the rows of
// a picture.
//
// Writing columns directly into a picture costs five to ten times as much: its rows are a few
// kilobytes apart, so a column's pixels fall on a handful of cache sets. In a row, the 16 columns
// of a strip are one cache line.
#pragma once

#include "slicecast/picture.h"

#include <vector>

namespace slicecast {

// #region strip
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
// #endregion

}  // namespace slicecast

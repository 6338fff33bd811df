// Cuts see-through sides and objects into blended rows, opaque rows and holes.
#pragma once

#include "render/pixels/column_fill.h"
#include "world/texel_runs.h"

#include <algorithm>
#include <cstdint>

namespace slicecast {

// Rows that ripples may need although something opaque is before them (see ripples.h): so many
// beside the ends of opaque runs, below the horizon.
struct CutMargin {
    int rows = 0;
    int firstFallingRow = 0;

    // The first row of a run, and the one behind its last, without the margin.
    int behindFirst(int first) const { return first > firstFallingRow ? first + rows : first; }
    int beforeLast(int last) const {
        return last > firstFallingRow ? std::max(last - rows, std::min(last, firstFallingRow))
                                      : last;
    }
};

// Cuts the rows [first, last) of a column of texels, whose runs begin with `run`. Calls add(column,
// first, last, true) for blended and add(column, first, last, false) for opaque rows, in order;
// leaves out holes. Each column starts at the first of its rows. The rows of opaque runs in the
// margin count as blended.
template <typename Add>
void cutTexels(const TexelColumn& column, const TexelRun* run, int first, int last,
               const CutMargin& margin, Add&& add) {
    // The fewest rows for which a piece of its own, and the search, are worth their cost
    constexpr int kWorthAPiece = 12;
    constexpr int kWorthALook = 32;
    if (last - first < kWorthALook) return add(column, first, last, true);
    const auto give = [&](int from, int to, bool layer) {
        TexelColumn piece = column;
        piece.start += static_cast<std::uint64_t>(from - first) * column.step;
        add(piece, from, to, layer);
    };
    const auto count = static_cast<std::uint64_t>(last - first);
    int blended = first;  // the first row that is blended or in too short a run
    for (int row = first; row < last; ++run) {
        const std::uint64_t border = std::uint64_t{run->end} << column.shift;
        if (border <= column.start) continue;
        const std::uint64_t steps =
            column.step == 0 ? count : (border - column.start + column.step - 1) / column.step;
        const int end = first + static_cast<int>(std::min(steps, count));
        const bool isOpaque = run->coverage == Coverage::opaque;
        const int from = isOpaque ? margin.behindFirst(row) : row;
        const int to = isOpaque ? margin.beforeLast(end) : end;
        if (run->coverage != Coverage::blended && to - from >= kWorthAPiece) {
            if (blended < from) give(blended, from, true);
            if (isOpaque) give(from, to, false);
            blended = to;
        }
        row = end;
    }
    if (blended < last) give(blended, last, true);
}

// The same for a column without see-through texels.
template <typename Add>
void cutOpaque(const TexelColumn& column, int first, int last, const CutMargin& margin, Add&& add) {
    const int from = margin.behindFirst(first);
    const int to = margin.beforeLast(last);
    if (from >= to) return add(column, first, last, true);
    const auto give = [&](int row, int end, bool layer) {
        TexelColumn piece = column;
        piece.start += static_cast<std::uint64_t>(row - first) * column.step;
        add(piece, row, end, layer);
    };
    if (first < from) give(first, from, true);
    give(from, to, false);
    if (to < last) give(to, last, true);
}

}  // namespace slicecast

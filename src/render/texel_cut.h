// Cuts see-through sides and objects into blended rows, opaque rows and holes.
#pragma once

#include "render/column_fill.h"
#include "world/texel_runs.h"

#include <algorithm>
#include <cstdint>

namespace slicecast {

// Cuts the rows [first, last) of a column of texels, whose runs begin with `run`. Calls add(column,
// first, last, true) for blended and add(column, first, last, false) for opaque rows, in order;
// leaves out holes. Each column starts at the first of its rows.
template <typename Add>
void cutTexels(const TexelColumn& column, const TexelRun* run, int first, int last, Add&& add) {
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
        if (run->coverage != Coverage::blended && end - row >= kWorthAPiece) {
            if (blended < row) give(blended, row, true);
            if (run->coverage == Coverage::opaque) give(row, end, false);
            blended = end;
        }
        row = end;
    }
    if (blended < last) give(blended, last, true);
}

}  // namespace slicecast

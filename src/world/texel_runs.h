// Runs of texels in the columns of a see-through picture: holes, which show nothing, and opaque
// ones, which hide everything behind them. Drawing a column skips holes, and what opaque runs hide.
#pragma once

#include "slicecast/colour.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

enum class Coverage : std::uint8_t { hole, opaque, blended };

// The texels from the end of the run before up to `end`.
struct TexelRun {
    std::uint16_t end = 0;
    Coverage coverage = Coverage::blended;
};

class TexelRuns {
public:
    TexelRuns() = default;
    // Of consecutive columns of `height` texels each, 1 to 65535.
    TexelRuns(const std::vector<Pixel>& columns, int height);

    // The runs of column u, from the top.
    const TexelRun* of(int u) const { return runs_.data() + starts_[static_cast<std::size_t>(u)]; }

private:
    std::vector<TexelRun> runs_;
    std::vector<std::uint32_t> starts_;
};

}  // namespace slicecast

// Runs of texels in the columns of a see-through picture: holes, which show nothing, and opaque
// ones, behind which nothing is seen. Who draws a column may leave out the former and forget what
// lies behind the latter.
#pragma once

#include "slicecast/colour.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

enum class Coverage : std::uint8_t { hole, opaque, blended };

// The texels before `end`, behind those of the run before.
struct TexelRun {
    std::uint16_t end = 0;
    Coverage coverage = Coverage::blended;
};

class TexelRuns {
public:
    TexelRuns() = default;
    // Of columns `height` texels long, 1 to 65535, one after another.
    TexelRuns(const std::vector<Pixel>& columns, int height);

    // The runs of column u, from the top.
    const TexelRun* of(int u) const { return runs_.data() + starts_[static_cast<std::size_t>(u)]; }

private:
    std::vector<TexelRun> runs_;
    std::vector<std::uint32_t> starts_;
};

}  // namespace slicecast

#include "world/texel_runs.h"

namespace slicecast {
namespace {

Coverage coverageOf(Pixel texel) {
    const Pixel alpha = texel >> 24;
    return alpha == 0 ? Coverage::hole : alpha == 255 ? Coverage::opaque : Coverage::blended;
}

}  // namespace

TexelRuns::TexelRuns(const std::vector<Pixel>& columns, int height) {
    const auto length = static_cast<std::size_t>(height);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Coverage coverage = coverageOf(columns[i]);
        const bool isFirst = i % length == 0;
        if (isFirst) starts_.push_back(static_cast<std::uint32_t>(runs_.size()));
        if (isFirst || runs_.back().coverage != coverage) runs_.push_back({0, coverage});
        runs_.back().end = static_cast<std::uint16_t>(i % length + 1);
    }
}

}  // namespace slicecast

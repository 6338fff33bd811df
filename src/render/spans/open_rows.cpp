#include "render/spans/open_rows.h"

#include <algorithm>

namespace slicecast {

// #region take
const std::vector<OpenRows::Run>& OpenRows::take(int first, int last) {
    taken_.clear();
    if (!mayHold(first, last)) return taken_;
    for (std::size_t i = 0; i < runs_.size();) {
        const Run run = runs_[i];
        if (run.first >= last) break;
        if (run.last <= first) {
            ++i;
            continue;
        }
        const Run taken = {std::max(run.first, first), std::min(run.last, last)};
        taken_.push_back(taken);
        const bool restAbove = run.first < taken.first;
        const bool restBelow = run.last > taken.last;
        const auto place = runs_.begin() + static_cast<std::ptrdiff_t>(i);
        if (restAbove && restBelow) {
            runs_[i].last = taken.first;
            runs_.insert(place + 1, Run{taken.last, run.last});
            break;
        }
        if (restAbove) {
            runs_[i].last = taken.first;
            ++i;
        } else if (restBelow) {
            runs_[i].first = taken.last;
            break;
        } else {
            runs_.erase(place);
        }
    }
    findEnds();
    return taken_;
}
// #endregion

const std::vector<OpenRows::Run>& OpenRows::within(int first, int last) {
    within_.clear();
    if (!mayHold(first, last)) return within_;
    for (const Run& run : runs_) {
        if (run.first >= last) break;
        if (run.last > first)
            within_.push_back({std::max(run.first, first), std::min(run.last, last)});
    }
    return within_;
}

}  // namespace slicecast

// The rows of a slice that are still empty: a few runs, sorted from the top.
#pragma once

#include <cstddef>
#include <vector>

namespace slicecast {

class OpenRows {
public:
    struct Run {
        int first;
        int last;  // one past the end
    };

    // Opens exactly these rows of a slice, sorted from the top. The number of runs never exceeds
    // half the rows, so nothing is allocated after the first slice of a height.
    void openOnly(const std::vector<Run>& rows, int height) {
        runs_.reserve(static_cast<std::size_t>(height) / 2 + 2);
        within_.reserve(static_cast<std::size_t>(height) / 2 + 2);
        runs_.assign(rows.begin(), rows.end());
        findEnds();
    }

    // Opens no run, one, or two, in the existing memory.
    void closeAll() {
        runs_.clear();
        findEnds();
    }
    void open(Run only) {
        runs_.assign(1, only);
        findEnds();
    }
    void open(Run upper, Run lower) {
        runs_.assign({upper, lower});
        findEnds();
    }

    const std::vector<Run>& runs() const { return runs_; }

    bool none() const { return first_ >= last_; }
    int first() const { return first_; }
    int last() const { return last_; }

    // Whether any of the rows [first, last) may be open, judged by the first and last open row.
    bool mayHold(int first, int last) const {
        return first < last && last > first_ && first < last_;
    }

    // #region take
    // Closes the rows [first, last) and calls fill(first, last) for each run that was open.
    template <typename Fill>
    void take(int first, int last, Fill&& fill) {
        if (!mayHold(first, last)) return;
        for (std::size_t i = 0; i < runs_.size();) {
            const Run run = runs_[i];
            if (run.first >= last) break;
            if (run.last <= first) {
                ++i;
                continue;
            }
            const int from = run.first < first ? first : run.first;
            const int to = run.last > last ? last : run.last;
            fill(from, to);
            const bool restAbove = run.first < from;
            const bool restBelow = run.last > to;
            if (restAbove && restBelow) {
                runs_[i].last = from;
                runs_.insert(runs_.begin() + static_cast<std::ptrdiff_t>(i) + 1, Run{to, run.last});
                break;
            }
            if (restAbove) {
                runs_[i].last = from;
                ++i;
            } else if (restBelow) {
                runs_[i].first = to;
                break;
            } else {
                runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
        findEnds();
    }
    // #endregion

    // Calls fn(first, last) for each run of open rows within [first, last); closes none.
    template <typename Fn>
    void each(int first, int last, Fn&& fn) const {
        if (!mayHold(first, last)) return;
        for (const Run& run : runs_) {
            if (run.first >= last) break;
            if (run.last > first)
                fn(run.first < first ? first : run.first, run.last > last ? last : run.last);
        }
    }

    // The same as a list, valid until the next call; rows may be closed meanwhile.
    const std::vector<Run>& within(int first, int last) {
        within_.clear();
        each(first, last, [&](int from, int to) { within_.push_back({from, to}); });
        return within_;
    }

private:
    void findEnds() {
        first_ = runs_.empty() ? 0 : runs_.front().first;
        last_ = runs_.empty() ? 0 : runs_.back().last;
    }

    std::vector<Run> runs_;
    std::vector<Run> within_;
    int first_ = 0;
    int last_ = 0;
};

}  // namespace slicecast

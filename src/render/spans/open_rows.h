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
        taken_.reserve(static_cast<std::size_t>(height) / 2 + 2);
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

    // Closes the rows [first, last). Returns those of them that were open, from the top; valid
    // until the next call.
    const std::vector<Run>& take(int first, int last);
    // The open rows within [first, last), valid until the next call; closes none.
    const std::vector<Run>& within(int first, int last);

private:
    void findEnds() {
        first_ = runs_.empty() ? 0 : runs_.front().first;
        last_ = runs_.empty() ? 0 : runs_.back().last;
    }

    std::vector<Run> runs_;
    std::vector<Run> taken_;
    std::vector<Run> within_;
    int first_ = 0;
    int last_ = 0;
};

}  // namespace slicecast

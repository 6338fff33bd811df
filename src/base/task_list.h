// Work in small tasks, so that a page can do something else in between.
//
//     TaskList tasks;
//     tasks.add([&] { read(text); });
//     tasks.add([&] { for (Map& map : maps) tasks.add([&] { prepare(map); }); });
//     while (tasks.doNext()) ...
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace slicecast {

class TaskList {
public:
    using Task = std::function<void()>;

    // Tasks are done in the order in which they are added; those that a task adds come right after
    // it, before all others.
    void add(Task task) { added_.push_back(std::move(task)); }

    // A task that is done again as long as it returns true.
    void repeat(std::function<bool()> task) {
        add([this, task = std::move(task)]() mutable {
            if (task()) repeat(std::move(task));
        });
    }

    // Does the next task. False if there was none.
    bool doNext() {
        for (; !added_.empty(); added_.pop_back()) left_.push_back(std::move(added_.back()));
        if (left_.empty()) return false;
        Task task = std::move(left_.back());
        left_.pop_back();
        ++done_;
        task();
        const std::size_t known = done_ + left_.size() + added_.size();
        share_ = std::max(share_, static_cast<double>(done_) / static_cast<double>(known));
        return true;
    }

    void doAll() {
        while (doNext()) {
        }
    }

    // The share of the known tasks that are done, growing from 0 to 1.
    double share() const { return share_; }

private:
    std::vector<Task> left_;   // the next one at the end
    std::vector<Task> added_;  // since the last task began, in order
    std::size_t done_ = 0;
    double share_ = 0.0;
};

}  // namespace slicecast

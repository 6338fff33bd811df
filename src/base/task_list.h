// Work in small tasks, so that a page can do something else in between.
//
//     TaskList tasks;
//     tasks.add<&Reader::readText>(reader);           // reader.readText()
//     tasks.add<&Reader::readMap>(reader, 3);         // reader.readMap(3)
//     tasks.add<startObjects>(world);                 // startObjects(world)
//     while (tasks.doNext()) ...
//
// What a task is done with must outlive the list's use.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace slicecast {

class TaskList {
public:
    // Tasks are done in the order in which they are added; those that a task adds come right after
    // it, before all others. A task that returns true is then done again.
    template <auto kWork, typename Owner>
    void add(Owner& owner, std::size_t number = 0) {
        added_.push_back({&run<kWork, Owner>, &owner, number});
    }

    // Does the next task. False if there was none.
    bool doNext() {
        for (; !added_.empty(); added_.pop_back()) left_.push_back(added_.back());
        if (left_.empty()) return false;
        const Task task = left_.back();
        left_.pop_back();
        if (task.run(task.owner, task.number)) added_.push_back(task);
        ++done_;
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
    struct Task {
        bool (*run)(void* owner, std::size_t number);
        void* owner;
        std::size_t number;
    };

    template <auto kWork, typename Owner>
    static bool run(void* owner, std::size_t number) {
        const auto work = [&] {
            Owner& its = *static_cast<Owner*>(owner);
            if constexpr (std::is_invocable_v<decltype(kWork), Owner&, std::size_t>)
                return std::invoke(kWork, its, number);
            else
                return std::invoke(kWork, its);
        };
        if constexpr (std::is_same_v<decltype(work()), bool>) {
            return work();
        } else {
            work();
            return false;
        }
    }

    std::vector<Task> left_;   // the next one at the end
    std::vector<Task> added_;  // since the last task began, in order
    std::size_t done_ = 0;
    double share_ = 0.0;
};

}  // namespace slicecast

// A crew of threads. They start once, sleep between jobs, and end with the crew.
#pragma once

#ifndef __EMSCRIPTEN__

#include "render/crew.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace slicecast {

inline constexpr int kMostThreads = 64;  // more would not draw a picture faster

// The number of threads that this machine runs at once, if known; at most kMostThreads.
int threadsOfMachine();

class ThreadCrew : public Crew {
public:
    // `threads` includes the calling thread. The crew is smaller if the system cannot start as
    // many.
    explicit ThreadCrew(int threads);
    ~ThreadCrew() override;
    ThreadCrew(const ThreadCrew&) = delete;
    ThreadCrew& operator=(const ThreadCrew&) = delete;

    int hands() const override { return static_cast<int>(threads_.size()) + 1; }

    // Must not be called by two threads at once, nor by a job.
    void work(const std::function<void(int)>& job) override;

private:
    void serve(int hand);

    std::mutex mutex_;  // guards all of the following but `threads_`
    std::condition_variable begin_;
    std::condition_variable end_;
    const std::function<void(int)>* job_ = nullptr;
    std::uint64_t jobs_ = 0;  // begun so far
    int busy_ = 0;            // threads that are still on the last job
    bool isOver_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace slicecast

#endif

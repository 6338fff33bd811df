// A crew of threads. They are started once, sleep between the jobs, and end with the crew.
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

inline constexpr int kMostThreads = 64;  // more than draw a picture faster

// How many this machine runs at the same time, as far as that is known; at most kMostThreads.
int threadsOfMachine();

class ThreadCrew : public Crew {
public:
    // The calling thread is one of them. There are fewer where the system starts no more.
    explicit ThreadCrew(int threads);
    ~ThreadCrew() override;
    ThreadCrew(const ThreadCrew&) = delete;
    ThreadCrew& operator=(const ThreadCrew&) = delete;

    int hands() const override { return static_cast<int>(threads_.size()) + 1; }

    // Not by two threads at the same time, nor by a job.
    void work(const std::function<void(int)>& job) override;

private:
    void serve(int hand);

    std::mutex mutex_;  // of all that follows but the threads
    std::condition_variable begin_;
    std::condition_variable end_;
    const std::function<void(int)>* job_ = nullptr;
    std::uint64_t jobs_ = 0;  // begun so far
    int busy_ = 0;            // threads that have not done the last one
    bool isOver_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace slicecast

#endif

#include "app/thread_crew.h"

#ifndef __EMSCRIPTEN__

#include <algorithm>
#include <system_error>

namespace slicecast {

int threadsOfMachine() {
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMostThreads);
}

ThreadCrew::ThreadCrew(int threads) {
    const int others = std::clamp(threads, 1, kMostThreads) - 1;
    threads_.reserve(static_cast<std::size_t>(others));
    try {
        for (int hand = 1; hand <= others; ++hand)
            threads_.emplace_back([this, hand] { serve(hand); });
    } catch (const std::system_error&) {
        // Works with the threads that have started.
    }
}

ThreadCrew::~ThreadCrew() {
    {
        const std::lock_guard lock(mutex_);
        isOver_ = true;
    }
    begin_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void ThreadCrew::work(const std::function<void(int)>& job) {
    {
        const std::lock_guard lock(mutex_);
        job_ = &job;
        busy_ = static_cast<int>(threads_.size());
        ++jobs_;
    }
    begin_.notify_all();
    job(0);
    std::unique_lock lock(mutex_);
    end_.wait(lock, [this] { return busy_ == 0; });
}

void ThreadCrew::serve(int hand) {
    std::uint64_t done = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
        begin_.wait(lock, [&] { return isOver_ || jobs_ > done; });
        if (isOver_) return;
        done = jobs_;
        const std::function<void(int)>& job = *job_;
        lock.unlock();
        job(hand);
        lock.lock();
        if (--busy_ == 0) end_.notify_one();
    }
}

}  // namespace slicecast

#endif

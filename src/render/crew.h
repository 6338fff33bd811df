// Hands that work at the same time. The engine knows no threads; who has some lends them as a crew
// (app/thread_crew.h).
#pragma once

#include <functional>

namespace slicecast {

class Crew {
public:
    virtual ~Crew() = default;

    // At least 1: whoever calls has a hand too.
    virtual int hands() const = 0;

    // Every hand does the job once, told which one it is: 0 to hands() - 1. Returns when all have.
    virtual void work(const std::function<void(int)>& job) = 0;
};

}  // namespace slicecast

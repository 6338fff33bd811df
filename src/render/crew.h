// A crew of hands that work in parallel. The engine knows no threads; the program provides them as
// a crew (app/thread_crew.h).
#pragma once

#include <functional>

namespace slicecast {

class Crew {
public:
    virtual ~Crew() = default;

    // At least 1, including the calling hand.
    virtual int hands() const = 0;

    // Calls job(hand) once for each hand, 0 to hands() - 1. Returns when all are done.
    virtual void work(const std::function<void(int)>& job) = 0;
};

}  // namespace slicecast

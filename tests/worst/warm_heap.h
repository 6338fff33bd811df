// Memory that a program has never touched costs some microseconds a page where it runs in a virtual
// machine, several times what the work with it costs. That is the machine's and comes once; so the
// programs that measure touch their memory first, and keep it.
#pragma once

#include <malloc.h>
#include <cstdlib>
#include <cstring>

namespace slicecast {

inline void warmHeap() {
    constexpr std::size_t kBytes = std::size_t{256} << 20;
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    void* const memory = std::malloc(kBytes);
    if (memory == nullptr) std::abort();
    std::memset(memory, 1, kBytes);
    asm volatile("" : : "r"(memory) : "memory");  // else g++ leaves all of it out
    std::free(memory);
}

}  // namespace slicecast

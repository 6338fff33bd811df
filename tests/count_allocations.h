// Counts what a program allocates. Included by one file of a test program, for it replaces the
// operator new of the whole.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace slicecast {

inline long allocations = 0;

}  // namespace slicecast

void* operator new(std::size_t size) {
    ++slicecast::allocations;
    if (void* memory = std::malloc(size)) return memory;
    std::abort();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

// Counts what a program allocates. Included by one file of a test program, for it replaces the
// operator new of the whole.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace slicecast {

inline long allocations = 0;

}  // namespace slicecast

// Not inlined: g++ would take free() for the wrong partner of the library's operator new.
__attribute__((noinline)) void* operator new(std::size_t size) {
    ++slicecast::allocations;
    if (void* memory = std::malloc(size)) return memory;
    std::abort();
}
__attribute__((noinline)) void operator delete(void* memory) noexcept {
    std::free(memory);
}
__attribute__((noinline)) void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

// Copies and fills memory by WebAssembly's own instructions, because the small C library goes byte
// by byte. This file is not part of the link-time optimisation, which would treat code compiled for
// these instructions as a multi-threaded program.
#ifdef __wasm_bulk_memory__

#include <cstddef>

extern "C" {

void* memcpy(void* to, const void* from, std::size_t bytes) {
    return __builtin_memcpy(to, from, bytes);
}
void* memmove(void* to, const void* from, std::size_t bytes) {
    return __builtin_memmove(to, from, bytes);
}
void* memset(void* to, int byte, std::size_t bytes) {
    return __builtin_memset(to, byte, bytes);
}

}  // extern "C"

#endif

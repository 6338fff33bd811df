// Copying and filling by the machine's own instructions, where WebAssembly has them: the small C
// library goes byte by byte. These functions stay out of the optimisation of the whole, which takes
// what it compiles with them for a program of several threads.
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

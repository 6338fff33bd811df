// Any bytes as a PNG file: read twice, with the memory before full of other bytes. Memory that
// nobody wrote would make two different pictures.
#include "base/image.h"

#include <sanitizer/allocator_interface.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>

using namespace slicecast;

namespace {

int filling = -1;  // the byte that new memory is full of; -1 leaves it

void fillNew(const volatile void* memory, std::size_t size) {
    if (filling >= 0) std::memset(const_cast<void*>(memory), filling, size);
}
void leaveOld(const volatile void*) {}

// Leaves the byte all over the stack that the decoder will use.
__attribute__((noinline)) void fillStack(int byte) {
    char memory[256 << 10];
    std::memset(memory, byte, sizeof memory);
    asm volatile("" : : "r"(memory) : "memory");  // or the compiler leaves it out
}

DecodedImage decodedWith(int byte, std::span<const std::uint8_t> bytes) {
    constexpr int kMost = 20;  // pixels a side: some of the pictures that it begins with have more
    fillStack(byte);
    filling = byte;
    DecodedImage decoded = decodePng(bytes, kMost, kMost);
    filling = -1;
    const Image& image = decoded.image;
    if (decoded.fault.empty() == image.empty()) std::abort();
    if (image.width > kMost || image.height > kMost ||
        image.pixels.size() !=
            static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
        std::abort();
    // A reason, and nothing else
    if (decoded.fault.find("()") != std::string::npos) std::abort();
    for (const char c : decoded.fault) {
        if (c < ' ' || c > '~') std::abort();
    }
    return decoded;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const bool isHooked = __sanitizer_install_malloc_and_free_hooks(fillNew, leaveOld) != 0;
    if (!isHooked) std::abort();
    const DecodedImage decoded = decodedWith(0x5a, {data, size});
    const DecodedImage again = decodedWith(0xa5, {data, size});
    if (decoded.fault != again.fault || decoded.image.pixels != again.image.pixels) std::abort();
    return 0;
}

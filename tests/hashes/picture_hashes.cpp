// Prints one line per view: its name and the hash of its picture. Builds by different compilers must print the same.
//
//     picture-hashes ASSETS_FOLDER

#include "base/angle.h"

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace {

// 64-bit FNV-1a.
std::uint64_t hashOf(const void* bytes, std::size_t count) {
    const auto* at = static_cast<const unsigned char*>(bytes);
    std::uint64_t hash = 14695981039346656037u;
    for (std::size_t i = 0; i < count; ++i) hash = (hash ^ at[i]) * 1099511628211u;
    return hash;
}

}  // namespace

int main(int, char**) {
    static double sines[3600];
    for (int i = 0; i < 3600; ++i) sines[i] = slicecast::sinDegrees(i * 0.1) + slicecast::atanDegrees(i * 0.01);
    std::printf("angles %016" PRIx64 "\n", hashOf(sines, sizeof sines));
    return 0;
}

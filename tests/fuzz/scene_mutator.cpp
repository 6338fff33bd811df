// How fuzzers change a scene: its bytes, or its keys and values as the schema has them.
#include "fuzz/fuzzed_scene.h"

#include <cstring>
#include <string>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
    using namespace slicecast;
    Random random(seed);
    if (random.oneIn(2)) return LLVMFuzzerMutate(data, size, most);
    const std::string before(reinterpret_cast<const char*>(data), size);
    std::string text = sceneMaker().changed(before, random);
    // Mostly one that loads; faults have to be met too
    if (!random.oneIn(8)) text = sceneMaker().mended(text, before, faultsOf);
    if (text.empty() || text == before || text.size() > most)
        return LLVMFuzzerMutate(data, size, most);
    std::memcpy(data, text.data(), text.size());
    return text.size();
}

// Judges a renderer that was broken on purpose, until the judge notices. Exit status 0 if it does.
// With the argument "sound" the renderer is whole: exit status 0 if the judge notices nothing.
#include "suite.h"

#include <cstdio>
#include <string_view>

int main(int argc, char** argv) {
    using namespace slicecast::judge;
    const bool sound = argc > 1 && std::string_view(argv[1]) == "sound";
    // Most faults show in the first few pictures; some need a rare meeting of blocks.
    constexpr int kBatch = 20;
    const int batches = sound ? 20 : 600;
    // The share of excused pixels counts only from this batch on: in few pictures it says little.
    constexpr int kBatchesForShare = 5;
    Verdict random;
    Verdict ties;
    Verdict along;
    Verdict large;
    const auto share = [&] {
        return static_cast<double>(random.excused) / static_cast<double>(random.pixels);
    };
    int batch = 0;
    const auto noticed = [&] {
        return random.unexcused > 0 || ties.unexcused > 0 || random.crowded > 0 ||
               along.unexcused > 0 || large.unexcused > 0 ||
               (batch >= kBatchesForShare && share() > kExcusedShareOfSuite);
    };
    for (; batch < batches && !noticed(); ++batch) {
        random.add(judgeAll(randomScene, static_cast<std::uint64_t>(1000 + batch * kBatch), kBatch,
                            kSmallSizes));
        random.add(judgeAll(wideLandScene, static_cast<std::uint64_t>(1 + batch * kBatch),
                            kBatch / 4, kSmallSizes));
        along.add(judgeAll(alongBorderScene, static_cast<std::uint64_t>(1 + batch * kBatch),
                           kBatch / 4, kOddSizes));
        large.add(judgeAll(largeTextureScene, static_cast<std::uint64_t>(121 + batch * kBatch),
                           kBatch / 10, kSmallSizes));
        // The first seeds are such that rare faults show early
        ties.add(judgeAll(tieScene, static_cast<std::uint64_t>(2601 + batch * kBatch), kBatch,
                          kSmallSizes));
    }
    std::printf(
        "batch %d: %lld unexcused pixels, %lld along borders, %lld of large textures, %lld where "
        "pictures were made to tie; %.4f %% of %lld excused, %lld pictures with too many\n",
        batch, static_cast<long long>(random.unexcused), static_cast<long long>(along.unexcused),
        static_cast<long long>(large.unexcused), static_cast<long long>(ties.unexcused),
        100.0 * share(), static_cast<long long>(random.pixels),
        static_cast<long long>(random.crowded));
    return noticed() != sound ? 0 : 1;
}

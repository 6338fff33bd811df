// Judges a renderer that was broken on purpose, until the judge notices.
//
//     mutant_NAME [KIND SEED]             the picture of this kind and seed comes first
//     mutant_none sound [KIND SEED] ...   the renderer is whole; all of these pictures are judged
//
// Prints the kind and the seed of the picture that shows the fault. Exit status 0 if the judge
// notices a fault, or with "sound" if it notices none.
#include "suite.h"
#include "works.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <span>
#include <string_view>

namespace {

using namespace slicecast::judge;

// Most faults show in the first few pictures; some need a rare meeting of blocks.
constexpr int kBatch = 20;
constexpr int kBatches = 600;
constexpr int kBatchesIfSound = 20;
// The share of excused pixels counts only from this batch on: in few pictures it says little.
constexpr int kBatchesForShare = 5;

struct Kind {
    std::string_view name;
    MakeScene make;
    std::span<const Size> sizes;
    std::uint64_t first;  // seed of the first batch; the next batch begins kBatch seeds later
    int count;            // pictures of a batch
    bool isUsual;         // its excused pixels are counted
};
constexpr Kind kKinds[] = {{"random", randomScene, kSmallSizes, 1000, kBatch, true},
                           {"wide", wideLandScene, kSmallSizes, 1, kBatch / 4, true},
                           {"along", alongBorderScene, kOddSizes, 1, kBatch / 4, false},
                           {"large", largeTextureScene, kSmallSizes, 121, kBatch / 10, false},
                           {"crowd", crowdedScene, kCrowdSizes, 1, kBatch / 10, false},
                           {"times", timesScene, kSmallSizes, 1, kBatch / 4, true},
                           {"works", worksScene, kSmallSizes, 1, kBatch / 4, true},
                           {"tie", tieScene, kSmallSizes, 2601, kBatch, false}};

struct Search {
    slicecast::Renderer renderer;
    Verdict usual;

    // Whether the picture of this seed shows a fault.
    bool shows(const Kind& kind, std::uint64_t seed) {
        const Verdict verdict = judgeOne(renderer, kind.make, seed, kind.sizes);
        if (kind.isUsual) usual.add(verdict);
        if (verdict.unexcused == 0 && (!kind.isUsual || verdict.crowded == 0)) return false;
        std::printf("%.*s %llu shows it: %lld unexcused pixels, %lld excused\n",
                    static_cast<int>(kind.name.size()), kind.name.data(),
                    static_cast<unsigned long long>(seed),
                    static_cast<long long>(verdict.unexcused),
                    static_cast<long long>(verdict.excused));
        return true;
    }

    bool isAnyIn(int batch) {
        for (const Kind& kind : kKinds) {
            const std::uint64_t first = kind.first + static_cast<std::uint64_t>(batch * kBatch);
            for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(kind.count);
                 ++seed) {
                if (shows(kind, seed)) return true;
            }
        }
        const double share = static_cast<double>(usual.excused) / static_cast<double>(usual.pixels);
        if (batch + 1 < kBatchesForShare || share <= kExcusedShareOfSuite) return false;
        std::printf("batches 0 to %d show it: %.4f %% of the pixels are excused\n", batch,
                    100.0 * share);
        return true;
    }
};

}  // namespace

int main(int argc, char** argv) {
    const bool sound = argc > 1 && std::string_view(argv[1]) == "sound";
    Search search;
    bool isNoticed = false;
    for (int i = sound ? 2 : 1; i < argc && !isNoticed; i += 2) {
        const Kind* kind = std::ranges::find(kKinds, std::string_view(argv[i]), &Kind::name);
        if (kind == std::end(kKinds) || i + 1 == argc) {
            std::fprintf(stderr, "\"%s\": expected a kind of scene, and a seed after it\n",
                         argv[i]);
            return 1;
        }
        isNoticed = search.shows(*kind, std::strtoull(argv[i + 1], nullptr, 10));
    }
    const int batches = sound ? kBatchesIfSound : kBatches;
    for (int batch = 0; batch < batches && !isNoticed; ++batch) isNoticed = search.isAnyIn(batch);
    if (!isNoticed) std::printf("no picture shows a fault\n");
    return isNoticed != sound ? 0 : 1;
}

// Judges a renderer that was broken on purpose. Exit status 0 if the judge noticed (with "sound" as an argument: if it did not).
#include "suite.h"

#include <cstdio>
#include <string_view>

int main(int argc, char** argv) {
    using namespace slicecast::judge;
    const bool sound = argc > 1 && std::string_view(argv[1]) == "sound";
    const Verdict random = judgeAll(randomScene, 1000, 400, kSmallSizes);
    const Verdict ties = judgeAll(tieScene, 1, 400, kSmallSizes);
    const double excused = static_cast<double>(random.excused) / static_cast<double>(random.pixels);
    const bool noticed = random.unexcused > 0 || ties.unexcused > 0 || random.crowded > 0 || excused > kExcusedShareOfSuite;
    std::printf("%lld unexcused pixels, %lld where pictures were made to tie; %.4f %% excused, %lld pictures with too many\n",
                static_cast<long long>(random.unexcused), static_cast<long long>(ties.unexcused), 100.0 * excused, static_cast<long long>(random.crowded));
    return noticed != sound ? 0 : 1;
}

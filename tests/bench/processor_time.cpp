#include "processor_time.h"

#include <ctime>

#ifdef __EMSCRIPTEN__
#include <emscripten.h>
#endif

namespace slicecast {

#ifdef __EMSCRIPTEN__
EM_JS(double, secondsUsed, (), {
    const usage = process.cpuUsage();
    return (usage.user + usage.system) * 1e-6;
})
EM_JS(double, secondsPassed, (), { return performance.now() * 1e-3; })

double processorSeconds() {
    return secondsUsed();
}

double passingSeconds() {
    return secondsPassed();
}
#else
namespace {

double clockSeconds(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

double processorSeconds() {
    return clockSeconds(CLOCK_PROCESS_CPUTIME_ID);
}

double passingSeconds() {
    return clockSeconds(CLOCK_MONOTONIC);
}
#endif

}  // namespace slicecast

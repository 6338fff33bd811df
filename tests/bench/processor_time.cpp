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

double processorSeconds() {
    return secondsUsed();
}
#else
double processorSeconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}
#endif

}  // namespace slicecast

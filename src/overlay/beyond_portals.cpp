#include "overlay/beyond_portals.h"

#include <algorithm>

namespace slicecast {

Beyond beyondPortals(const SliceTrace& trace, const World& world, int eyeMap, int row, int most) {
    Beyond beyond = {eyeMap, 0};
    for (int passed = 0; passed < most; ++passed) {
        const auto next =
            std::find_if(trace.portals.begin(), trace.portals.end(), [&](const PassedPortal& each) {
                return each.portals == passed && each.first <= row && row < each.last;
            });
        if (next == trace.portals.end()) break;
        const Portal& portal = world.portals[next->portal];
        beyond = {portal.toMap, beyond.levels + portal.levels};
    }
    return beyond;
}

}  // namespace slicecast

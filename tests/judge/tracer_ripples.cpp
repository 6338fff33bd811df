// Ripples: a mirror shows the reflection of another row of its column.
#include "tracer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace slicecast::judge {
namespace {

// From -4096 to 4096; the phase has a period of 256.
int wave(int phase) {
    const int at = ((phase % 256) + 256) % 256;
    const int f = at % 128;
    return at < 128 ? f * (128 - f) : -f * (128 - f);
}

const Sight* mirrorIn(const std::vector<Sight>& sights) {
    for (const Sight& sight : sights) {
        if (sight.mirror > 0) return &sight;
    }
    return nullptr;
}

bool isSamePlane(const Sight& a, const Sight& b) {
    return a.map == b.map && a.turn == b.turn && a.waves.over == b.waves.over &&
           a.waves.placeX == b.waves.placeX && a.waves.placeY == b.waves.placeY &&
           a.waves.placeLevels == b.waves.placeLevels;
}

}  // namespace

int Tracer::shiftOf(const Sight::Waves& waves) const {
    const int step = static_cast<int>(world_.steps % 1024);
    const auto phase = [&](int x, int y, int t) { return x * waves.x + y * waves.y + t * step; };
    const int w = (2 * wave(phase(5, 3, 8) >> 3) + wave(phase(-4, 9, 8) >> 2) +
                   wave(phase(11, -6, 10) >> 2)) >>
                  5;
    const double perUnit = waves.offset * waves.offset / (waves.over * distance_);
    const double shift = std::floor(perUnit * (w * waves.ripples) / 262144.0 + 0.5);
    const double most = view_.height / 24;
    return static_cast<int>(std::clamp(shift, -most, most));
}

void Tracer::ripple(double x, double y, std::vector<Sight>& sights, Notes& notes) const {
    const Sight* const mirror = mirrorIn(sights);
    if (mirror == nullptr || mirror->waves.ripples == 0) return;
    const int shift = shiftOf(mirror->waves);
    const int way = shift < 0 ? -1 : 1;
    std::vector<Sight> next;
    std::vector<Sight> shown;
    Notes unread;
    int moved = 0;
    for (; moved != shift; moved += way) {
        const double row = std::floor(y) + moved + way;
        if (row < 0.0 || row >= view_.height) break;
        follow(x, y + moved + way, next, unread);
        const Sight* const other = mirrorIn(next);
        if (other == nullptr || !isSamePlane(*mirror, *other)) break;
        shown.assign(next.begin() + (other - next.data()) + 1, next.end());
    }
    notes.set(static_cast<std::size_t>(Note::rippledStop), moved != shift);
    notes.set(static_cast<std::size_t>(Note::rippledMirror), moved != 0);
    if (moved == 0) return;
    sights.resize(static_cast<std::size_t>(mirror - sights.data()) + 1);
    sights.insert(sights.end(), shown.begin(), shown.end());
}

}  // namespace slicecast::judge

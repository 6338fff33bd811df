// Measures the phases of a frame, and its replay: painting the same spans without a walk. No walk,
// however fast, makes a frame shorter than its replay.
//
// A frame is drawn as Renderer::draw does it: for each strip of 16 columns all spans are found,
// then painted, then the strip is copied. The clock is read in between. So the replay finds the
// caches as a real frame does. Two simpler replays did not. If all spans of the picture are painted
// at the end, they have left the cache (14 % longer for the glassworks in WebAssembly). If one
// strip is painted over and over, all its texels are there (15 % shorter).
#pragma once

#include "render/frame.h"
#include "render/strip.h"
#include "render/strip_walk.h"
#include "slicecast/picture.h"
#include "world/world.h"

#include <vector>

namespace slicecast {

// Seconds of a frame.
struct Phases {
    double setUp = 0.0;  // what all slices share: vistas, tables
    double walk = 0.0;
    double paint = 0.0;
    double copy = 0.0;  // of the strips into the picture

    double sum() const { return setUp + walk + paint + copy; }
    double replay() const { return paint + copy; }
    Phases& operator+=(const Phases& other);
    Phases operator/(double by) const { return {setUp / by, walk / by, paint / by, copy / by}; }
};

class PhasedFrame {
public:
    PhasedFrame(World world, const Eye& eye, const RenderOptions& options);

    // Draws the whole picture. Time in which other programs ran does not count.
    Phases draw(const Picture& picture);

private:
    const World world_;
    const Eye eye_;
    const RenderOptions options_;
    double secondsOfReading_ = 1.0;  // the clock; the least that was seen
    FrameMemory memory_;
    StripScratch strips_;
    std::vector<Pixel> reflected_;
    Strip strip_;
    FrameReport report_;
};

}  // namespace slicecast

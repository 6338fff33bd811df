// How the time of a frame falls on its phases, and its replay: the same spans painted without a
// walk, which no faster walk gets below.
//
// A frame is drawn as Renderer::draw does it: of each strip of 16 columns all spans are found
// first, then all are painted, then the strip is copied. A clock is read between. So the replay
// finds the caches as a real frame does. Spans of a whole picture that are painted later have left
// the cache (the glassworks took 14 % longer in WebAssembly), and a strip painted over and over
// finds all its texels there (15 % less).
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

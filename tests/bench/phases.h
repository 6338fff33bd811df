// Measures the phases of a frame, and its replay: painting the same spans without a walk. No walk,
// however fast, makes a frame shorter than its replay.
//
// A frame is drawn as Renderer::draw does it: for each strip of 16 columns all spans are found,
// then painted, then the strip is copied. The clock is read in between. So the replay finds the
// caches as a real frame does. Two simpler replays did not. If all spans of the picture are painted
// at the end, they have left the cache (14 % longer for the glassworks in WebAssembly). If one
// strip is painted over and over, all its texels are there (15 % shorter).
#pragma once

#include "render/pixels/strip.h"
#include "render/strips/strip_walk.h"
#include "render/view/frame.h"
#include "session/session.h"
#include "slicecast/picture.h"

#include <vector>

namespace slicecast {

// Seconds of a frame.
struct Phases {
    double setUp = 0.0;  // what all slices share: vistas, tables
    double walk = 0.0;
    double paint = 0.0;
    double copy = 0.0;  // of the strips into the picture

    double sum() const { return setUp + walk + paint + copy; }
    Phases operator/(double by) const { return {setUp / by, walk / by, paint / by, copy / by}; }
};

class PhasedFrame {
public:
    // The session must outlive this.
    explicit PhasedFrame(Session& session) : session_(session) {}

    // Draws the picture as the session does after its last step, without overlays. Time in which
    // other programs ran does not count.
    Phases draw(const Picture& picture);

private:
    Session& session_;
    double secondsOfReading_ = 1.0;  // the clock; the least that was seen
    FrameMemory memory_;
    StripScratch strips_;
    std::vector<Pixel> reflected_;
    Strip strip_;
    FrameReport report_;
};

}  // namespace slicecast

// The walk of a view without the painting: frame after frame the same spans are found, and nothing
// is done with them. The rest of a view's time is painting, which no faster walk makes shorter.
#pragma once

#include "render/frame.h"
#include "render/open_rows.h"
#include "render/slice_spans.h"
#include "world/world.h"

namespace slicecast {

class WalkAlone {
public:
    // The world outlives it.
    WalkAlone(const World& world, const Eye& eye, const RenderOptions& options);

    // Finds the spans of all columns of such a picture.
    void walk(int width, int height);

private:
    const World& world_;
    const Eye eye_;
    const RenderOptions options_;
    FrameMemory memory_;
    OpenRows open_;
    SliceSpans spans_;
    FrameReport report_;
};

}  // namespace slicecast

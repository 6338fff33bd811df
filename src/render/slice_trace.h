// Tells of a slice what its walk has found: tiles, blocks, spans, portals, mirrors.
#pragma once

#include "render/frame.h"
#include "render/slice_spans.h"
#include "render/trace.h"

namespace slicecast {

// Into an empty trace; what is asked of it (watchedRow, asksReflection) stands in it before.
void traceSlice(const Frame& frame, const SliceSpans& slice, SliceTrace& trace);

}  // namespace slicecast

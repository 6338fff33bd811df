// Lists what the walk of a slice has found: tiles, blocks, spans, portals, mirrors.
#pragma once

#include "render/spans/slice_spans.h"
#include "render/trace.h"
#include "render/view/frame.h"

namespace slicecast {

// Fills a trace that is empty but for watchedRow and asksReflection, which the caller has set.
void traceSlice(const Frame& frame, const SliceSpans& slice, SliceTrace& trace);

}  // namespace slicecast

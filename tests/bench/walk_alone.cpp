#include "walk_alone.h"

#include "render/slice_walk.h"

namespace slicecast {

WalkAlone::WalkAlone(const World& world, const Eye& eye, const RenderOptions& options)
    : world_(world), eye_(eye), options_(options) {}

void WalkAlone::walk(int width, int height) {
    const Frame frame(world_, eye_, options_, width, height, memory_);
    SliceWalk walk(frame, open_, report_);
    for (int column = 0; column < width; ++column) walk.find(column, spans_);
}

}  // namespace slicecast

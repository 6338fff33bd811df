// The limit for the benchmark of the play page, as WebAssembly of its own: the engine, which every
// page loads, does without it. web/play/limit.js is its other side.

#include "../limit_kernel.h"

#include <memory>
#include <vector>

#include <emscripten.h>

namespace {

std::unique_ptr<slicecast::LimitKernel> kernel;
std::vector<slicecast::Pixel> frame;

}  // namespace

extern "C" {

// From now on frames of that size are drawn, a multiple of 16 pixels wide.
EMSCRIPTEN_KEEPALIVE void setSize(int width, int height) {
    kernel = std::make_unique<slicecast::LimitKernel>(width, height);
    frame.resize(static_cast<std::size_t>(width) * height);
}

EMSCRIPTEN_KEEPALIVE void drawFrames(int count) {
    for (int i = 0; i < count; ++i) kernel->draw(frame.data());
}
}

// Draws one picture with all hands of a crew; the result has the same bytes as with one renderer.
//
//     hand 0   strip 0      strip 3 ...        each free hand takes the next strip, so that
//     hand 1   strip 1   strip 2   strip 4     expensive parts of the picture are shared
//
// Each hand has its own renderer, because the tables of a frame are filled while drawing. Without a
// crew, a single renderer draws as usual.
#pragma once

#include "render/crew.h"
#include "render/renderer.h"

#include <functional>
#include <vector>

namespace slicecast {

class CrewRenderer {
public:
    CrewRenderer() : renderers_(1) {}

    // The crew for all further pictures; null for none. It must outlive this, or be removed first.
    void setCrew(Crew* crew) { crew_ = crew; }

    // The same as in Renderer.
    bool draw(const World& world, const Eye& eye, const RenderOptions& options,
              const Picture& picture, int firstColumn = 0);
    int drawSome(const World& world, const Eye& eye, const RenderOptions& options,
                 const Picture& picture, int firstColumn);
    const FrameReport& report() const { return report_; }
    LitMaps& lit() { return renderers_.front().lit(); }
    SliceTrace trace(const World& world, const Eye& eye, const RenderOptions& options,
                     const ColumnRequest& request) {
        return renderers_.front().trace(world, eye, options, request);
    }
    void trace(const World& world, const Eye& eye, const RenderOptions& options,
               const TraceRequest& request, const std::function<void(SliceTrace&)>& take) {
        renderers_.front().trace(world, eye, options, request, take);
    }

private:
    Crew* crew_ = nullptr;
    std::vector<Renderer> renderers_;  // one per hand
    FrameReport report_;
};

// The renderer of a session. A page has no threads, so its program leaves the crew out.
#ifdef __EMSCRIPTEN__
using SessionRenderer = Renderer;
#else
using SessionRenderer = CrewRenderer;
#endif

}  // namespace slicecast

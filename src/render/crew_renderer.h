// A renderer that draws one picture with all the hands of a crew: the same bytes as one renderer.
//
//     hand 0   strip 0      strip 3 ...        whoever is ready takes the next strip, so a dear part
//     hand 1   strip 1   strip 2   strip 4     of the picture is shared, wherever it lies
//
// Each hand has a renderer of its own, because the tables of a frame are filled while it draws.
// Without a crew there is one renderer, which draws as it would by itself.
#pragma once

#include "render/crew.h"
#include "render/renderer.h"

#include <functional>
#include <vector>

namespace slicecast {

class CrewRenderer {
public:
    CrewRenderer() : renderers_(1) {}

    // From now on; null for none. The crew must outlive this, or be taken away before its end.
    void setCrew(Crew* crew) { crew_ = crew; }

    // As Renderer has them.
    bool draw(const World& world, const Eye& eye, const RenderOptions& options,
              const Picture& picture, int firstColumn = 0);
    const FrameReport& report() const { return report_; }
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
    std::vector<Renderer> renderers_;  // by hand
    FrameReport report_;
};

// What a session draws with. A page has no threads, and carries nothing of them.
#ifdef __EMSCRIPTEN__
using SessionRenderer = Renderer;
#else
using SessionRenderer = CrewRenderer;
#endif

}  // namespace slicecast

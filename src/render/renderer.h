// The fast renderer: draws what an eye sees of a world into a picture.
//
// What is drawn is defined per pixel. For a picture of W x H pixels with W / 2 and H / 2 as real
// numbers:
//
//     d       = (W / 2) / tan(fov / 2)               distance to the projection plane, in pixels
//     horizon = H / 2 + look * H                     row of the horizon
//     k(px)   = (px + 0.5 - W / 2) / d               sideways slope of column px
//     s(py)   = (horizon - (py + 0.5)) / d           upward slope of row py
//     ray     = eye + t * (forward + k * right + s * up),   t > 0
//
// Every pixel shows the nearest thing that its ray meets; t is the perpendicular depth, so there is
// no fish eye and no correction for one. web/docs/picture.md holds the rest (ties,
// textures, light), and tests/judge a slow tracer that is written from it.
#pragma once

#include "render/eye.h"
#include "render/options.h"
#include "render/trace.h"
#include "slicecast/picture.h"
#include "world/world.h"

#include <functional>
#include <memory>

namespace slicecast {

// Holds the scratch memory of a picture size; use one per picture that is drawn again and again.
// Not to be shared between threads.
class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    // Draws the picture, all of it or from one column on. Returns false and leaves the picture
    // alone if the eye is not above the floor, its map does not exist, the field of view or look is
    // not within its limits, or the picture is empty or larger than kMaxPictureSide.
    bool draw(const World& world, const Eye& eye, const RenderOptions& options,
              const Picture& picture, int firstColumn = 0);

    // Draws those strips of such a picture that begin at the columns which `next` gives, until it
    // gives one beyond the picture; each ends before the next multiple of kStripColumns. So several
    // renderers can draw one picture at the same time. Refuses what draw refuses, and asks for no
    // strip then.
    bool drawStrips(const World& world, const Eye& eye, const RenderOptions& options,
                    const Picture& picture, const std::function<int()>& next);

    // What the last draw did.
    const FrameReport& report() const;

    // Everything that one column of such a picture does, drawn nowhere. An invalid eye or column
    // gives an empty trace.
    SliceTrace trace(const World& world, const Eye& eye, const RenderOptions& options,
                     const ColumnRequest& request);

    // The same for many columns, one after another: what they share is worked out once.
    void trace(const World& world, const Eye& eye, const RenderOptions& options,
               const TraceRequest& request, const std::function<void(SliceTrace&)>& take);

private:
    void traceInto(const World& world, const Eye& eye, const RenderOptions& options,
                   const TraceRequest& request, SliceTrace& trace,
                   const std::function<void(SliceTrace&)>& take);

    struct Scratch;
    struct Strips;
    std::unique_ptr<Scratch> scratch_;
};

}  // namespace slicecast

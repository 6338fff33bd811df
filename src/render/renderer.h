// The fast renderer: draws what an eye sees of a world into a picture.
//
// The picture is defined per pixel. For W x H pixels, with W / 2 and H / 2 as real numbers:
//
//     d       = (W / 2) / tan(fov / 2)               distance to the projection plane, in pixels
//     horizon = H / 2 + look * H                     row of the horizon
//     k(px)   = (px + 0.5 - W / 2) / d               sideways slope of column px
//     s(py)   = (horizon - (py + 0.5)) / d           upward slope of row py
//     ray     = eye + t * (forward + k * right + s * up),   t > 0
//
// Every pixel shows the nearest thing that its ray meets. t is the perpendicular depth, so there is
// no fish eye to correct. web/docs/picture.md has the rest (ties, textures, light), and tests/judge
// a slow tracer written from it.
#pragma once

#include "render/eye.h"
#include "render/light/lit_maps.h"
#include "render/options.h"
#include "render/trace.h"
#include "slicecast/picture.h"
#include "world/world.h"

#include <functional>
#include <memory>

namespace slicecast {

// Holds the scratch memory for a picture size; keep one for pictures that are drawn repeatedly.
// Must not be shared between threads.
class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    // Draws the picture, all of it or from one column on. Returns false and changes nothing if
    //
    //   - the eye is not above the floor, or its map does not exist
    //   - the field of view or the look is outside its limits
    //   - the picture is empty or larger than kMaxPictureSide
    bool draw(const World& world, const Eye& eye, const RenderOptions& options,
              const Picture& picture, int firstColumn = 0);

    // Draws some strips of a picture, from a column on: few enough to take milliseconds, and only
    // those for which options.lightWork leaves room for light where none was known. Returns the
    // column where the next call has to go on, the picture's width when it is whole, or -1 for what
    // draw refuses.
    int drawSome(const World& world, const Eye& eye, const RenderOptions& options,
                 const Picture& picture, int firstColumn);

    // Draws strips of a picture: those that start at the columns returned by `next`, until it
    // returns one beyond the picture; each ends before the next multiple of kStripColumns. So
    // several renderers can draw one picture at the same time. Refuses what draw refuses; then it
    // never calls `next`.
    bool drawStrips(const World& world, const Eye& eye, const RenderOptions& options,
                    const Picture& picture, const std::function<int()>& next);

    // The work of the last draw.
    const FrameReport& report() const;

    // What is known of baked light, for whoever draws the same world in another way.
    LitMaps& lit();

    // Traces one column of such a picture without drawing. Empty for an invalid eye or column.
    SliceTrace trace(const World& world, const Eye& eye, const RenderOptions& options,
                     const ColumnRequest& request);

    // The same for many columns in turn; values that they share are computed once.
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

// The two stages of one slice, each by itself: the walk that finds spans, and the painter.
#pragma once

#include "render/paint/slice_paint.h"
#include "render/strips/strip_walk.h"
#include "render/view/frame.h"
#include "world/world.h"

#include <span>
#include <vector>

namespace slicecast::known {

// A frame of a picture. World and spans must not outlive it, nor it them.
class SliceStage {
public:
    SliceStage(const World& world, const Eye& eye, int width, int height,
               const RenderOptions& options = {.fovDegrees = 90.0})
        : eye_(eye), options_(options), frame_(world, eye_, options_, width, height, memory_) {}

    const SliceSpans& find(int column) {
        StripWalk(frame_, slice_, report_, StripWalk::SeeThrough::whole).find(column, 1);
        return slice_.found[0];
    }

    // Of the columns [first, first + count), at most 16.
    std::span<const SliceSpans> findTogether(int first, int count) {
        StripWalk(frame_, strip_, report_).find(first, count);
        return {strip_.found.data(), static_cast<std::size_t>(count)};
    }

    std::vector<Pixel> paint(const SliceSpans& spans, Pixel before = 0) {
        std::vector<Pixel> pixels(static_cast<std::size_t>(vistas().projection().height), before);
        SlicePainter(frame_, reflected_, report_).paint(spans, pixels.data());
        return pixels;
    }

    const Frame& frame() const { return frame_; }
    Vista& ofEye() { return vistas().ofEye(); }
    Vistas& vistas() { return memory_.vistas; }
    const FrameReport& report() const { return report_; }

private:
    Eye eye_;
    RenderOptions options_;
    FrameMemory memory_;
    Frame frame_;
    FrameReport report_;
    StripScratch slice_;
    StripScratch strip_;
    std::vector<Pixel> reflected_;
};

}  // namespace slicecast::known

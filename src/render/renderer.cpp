#include "render/renderer.h"

#include "render/ask/slice_trace.h"
#include "render/paint/slice_paint.h"
#include "render/pixels/strip.h"
#include "render/strips/strip_walk.h"
#include "render/view/frame.h"

#include <algorithm>
#include <optional>

namespace slicecast {

struct Renderer::Scratch {
    FrameMemory memory;
    StripScratch strips;
    std::vector<Pixel> reflected;
    Strip strip;
    FrameReport report;
};

Renderer::Renderer() : scratch_(std::make_unique<Scratch>()) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

namespace {

// All comparisons also refuse NaN.
bool canDraw(const World& world, const Eye& eye, const RenderOptions& options, int width,
             int height) {
    return isAboveFloor(eye) && eye.map >= 0 && eye.map < static_cast<int>(world.maps.size()) &&
           options.fovDegrees >= kMinFovDegrees && options.fovDegrees <= kMaxFovDegrees &&
           eye.look >= -kMaxLook && eye.look <= kMaxLook &&
           eye.headingDegrees - eye.headingDegrees == 0.0 && options.detailThreshold > 0.0 &&
           options.mirrors >= 0.0 && options.mirrors <= kMaxMirrors && isPictureSize(width, height);
}

bool canDraw(const World& world, const Eye& eye, const RenderOptions& options,
             const Picture& picture) {
    return canDraw(world, eye, options, picture.width, picture.height) && picture.pixels &&
           picture.pitch >= picture.width;
}

}  // namespace

// Draws the strips of one picture.
struct Renderer::Strips {
    Strips(const World& world, const Eye& eye, const RenderOptions& options, const Picture& shown,
           Scratch& memory)
        : scratch(memory),
          picture(shown),
          frame(world, eye, options, shown.width, shown.height, memory.memory),
          walk(frame, memory.strips, memory.report),
          painter(frame, memory.reflected, memory.report) {
        memory.strip.resize(shown.height);
    }

    // Draws up to the next multiple of kStripColumns. Returns the number of columns.
    int draw(int x) {
        frame.lit.beginStrip();
        const int columns = std::min(kStripColumns - x % kStripColumns, picture.width - x);
        walk.find(x, columns);
        for (int c = 0; c < columns; ++c)
            painter.paint(scratch.strips.found[static_cast<std::size_t>(c)],
                          scratch.strip.column(c));
        scratch.strip.copyTo(picture, x, columns);
        scratch.report.lightWork = frame.lit.work();
        scratch.report.lateLight = frame.lit.allowance().late;
        scratch.report.unlit = frame.lit.allowance().unlit;
        return columns;
    }

    Scratch& scratch;
    const Picture& picture;
    const Frame frame;
    StripWalk walk;
    SlicePainter painter;
};

bool Renderer::draw(const World& world, const Eye& eye, const RenderOptions& options,
                    const Picture& picture, int firstColumn) {
    if (!canDraw(world, eye, options, picture)) return false;
    scratch_->report = {};
    Strips strips(world, eye, options, picture, *scratch_);
    for (int x = std::max(0, firstColumn); x < picture.width;) x += strips.draw(x);
    return true;
}

int Renderer::drawSome(const World& world, const Eye& eye, const RenderOptions& options,
                       const Picture& picture, int firstColumn) {
    if (!canDraw(world, eye, options, picture)) return -1;
    constexpr int kColumns = 4 * kStripColumns;
    int x = std::max(0, firstColumn);
    if (x == 0) scratch_->report = {};
    Strips strips(world, eye, options, picture, *scratch_);
    for (const int end = std::min(x + kColumns, picture.width); x < end;) {
        const FrameReport before = scratch_->report;
        const int columns = strips.draw(x);
        if (strips.frame.lit.allowance().unlit > 0) {
            scratch_->report = before;
            scratch_->report.lightWork = strips.frame.lit.work();
            return x;
        }
        x += columns;
    }
    return x;
}

bool Renderer::drawStrips(const World& world, const Eye& eye, const RenderOptions& options,
                          const Picture& picture, const std::function<int()>& next) {
    if (!canDraw(world, eye, options, picture)) return false;
    scratch_->report = {};
    // Without a strip left, skip the preparation
    int x = next();
    if (x >= picture.width) return true;
    Strips strips(world, eye, options, picture, *scratch_);
    for (; x < picture.width; x = next()) strips.draw(x);
    return true;
}

LitMaps& Renderer::lit() {
    return scratch_->memory.lit;
}

const FrameReport& Renderer::report() const {
    return scratch_->report;
}

SliceTrace Renderer::trace(const World& world, const Eye& eye, const RenderOptions& options,
                           const ColumnRequest& request) {
    SliceTrace one;
    const auto [width, height, column, watchedRow] = request;
    traceInto(world, eye, options, {width, height, {&column, 1}, watchedRow}, one,
              [](SliceTrace&) {});
    return one;
}

void Renderer::trace(const World& world, const Eye& eye, const RenderOptions& options,
                     const TraceRequest& request, const std::function<void(SliceTrace&)>& take) {
    SliceTrace trace;
    traceInto(world, eye, options, request, trace, take);
}

// Traces the columns in turn and reuses the trace's memory.
void Renderer::traceInto(const World& world, const Eye& eye, const RenderOptions& options,
                         const TraceRequest& request, SliceTrace& trace,
                         const std::function<void(SliceTrace&)>& take) {
    const auto [width, height, columns, watchedRow, reflections] = request;
    trace.watchedRow = watchedRow;
    trace.asksReflection = reflections;
    const bool canTrace = canDraw(world, eye, options, width, height);
    Scratch& s = *scratch_;
    std::optional<Frame> frame;
    std::optional<StripWalk> walk;
    FrameReport report;
    if (canTrace) {
        frame.emplace(world, eye, options, width, height, s.memory);
        walk.emplace(*frame, s.strips, report, StripWalk::SeeThrough::whole);
    }
    for (const int column : columns) {
        trace.clear();
        if (canTrace && column >= 0 && column < width) {
            walk->find(column, 1, reflections);
            traceSlice(*frame, s.strips.found[0], trace);
        }
        take(trace);
    }
}

}  // namespace slicecast

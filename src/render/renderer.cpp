#include "render/renderer.h"

#include "base/sort.h"
#include "render/frame.h"
#include "render/slice.h"
#include "render/strip.h"

#include <algorithm>
#include <optional>
#include <tuple>

namespace slicecast {

struct Renderer::Scratch {
    std::vector<FrameTexture> textures;
    Vistas vistas;
    SliceMemory slice;
    Strip strip;
    FrameReport report;
};

Renderer::Renderer() : scratch_(std::make_unique<Scratch>()) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

namespace {

// Written so that NaN is refused too.
bool canDraw(const World& world, const Eye& eye, const RenderOptions& options, int width,
             int height) {
    return isAboveFloor(eye) && eye.map >= 0 && eye.map < static_cast<int>(world.maps.size()) &&
           options.fovDegrees >= kMinFovDegrees && options.fovDegrees <= kMaxFovDegrees &&
           eye.look >= -kMaxLook && eye.look <= kMaxLook &&
           eye.headingDegrees - eye.headingDegrees == 0.0 && options.detailThreshold > 0.0 &&
           options.mirrors >= 0.0 && options.mirrors <= kMaxMirrors && width > 0 && height > 0 &&
           width <= kMaxPictureSide && height <= kMaxPictureSide;
}

// Gives the blocks their rows, from the top, and the planes theirs.
void shareOut(SliceTrace& trace) {
    for (const FilledRows& rows : trace.filled) {
        if (rows.hit >= 0) trace.hits[static_cast<std::size_t>(rows.hit)].filled.push_back(rows);
        if (rows.hit < 0 && rows.object < 0) trace.planes.push_back(rows);
    }
    for (Hit& hit : trace.hits) {
        if (hit.filled.size() < 2) continue;
        mergeSort(hit.filled, [](const FilledRows& a, const FilledRows& b) {
            return std::tie(a.first, a.last, a.what, a.face) <
                   std::tie(b.first, b.last, b.what, b.face);
        });
    }
}

}  // namespace

bool Renderer::draw(const World& world, const Eye& eye, const RenderOptions& options,
                    const Picture& picture, int firstColumn) {
    if (!canDraw(world, eye, options, picture.width, picture.height) || !picture.pixels ||
        picture.pitch < picture.width)
        return false;
    Scratch& s = *scratch_;
    s.report = {};
    s.strip.resize(picture.height);
    const Frame frame(world, eye, options, picture.width, picture.height, s.textures, s.vistas);
    Slice slice(frame, s.slice, s.report);
    int columns = 0;
    for (int x = std::max(0, firstColumn); x < picture.width; x += columns) {
        columns = std::min(kStripColumns - x % kStripColumns, picture.width - x);
        for (int c = 0; c < columns; ++c) slice.draw(x + c, s.strip.column(c), nullptr);
        s.strip.copyTo(picture, x, columns);
    }
    return true;
}

const FrameReport& Renderer::report() const {
    return scratch_->report;
}

SliceTrace Renderer::trace(const World& world, const Eye& eye, const RenderOptions& options,
                           int width, int height, int column, int watchedRow) {
    SliceTrace one;
    traceInto(world, eye, options, {width, height, {&column, 1}, watchedRow}, one,
              [](SliceTrace&) {});
    return one;
}

void Renderer::trace(const World& world, const Eye& eye, const RenderOptions& options,
                     const TraceRequest& request, const std::function<void(SliceTrace&)>& take) {
    SliceTrace trace;
    traceInto(world, eye, options, request, trace, take);
}

// Each column in turn, in the memory of the one before.
void Renderer::traceInto(const World& world, const Eye& eye, const RenderOptions& options,
                         const TraceRequest& request, SliceTrace& trace,
                         const std::function<void(SliceTrace&)>& take) {
    const auto [width, height, columns, watchedRow, reflections] = request;
    trace.watchedRow = watchedRow;
    trace.asksReflection = reflections;
    const bool canTrace = canDraw(world, eye, options, width, height);
    Scratch& s = *scratch_;
    std::optional<Frame> frame;
    std::optional<Slice> slice;
    FrameReport report;
    if (canTrace) {
        s.strip.resize(height);
        frame.emplace(world, eye, options, width, height, s.textures, s.vistas);
        slice.emplace(*frame, s.slice, report);
    }
    for (const int column : columns) {
        trace.clear();
        if (canTrace && column >= 0 && column < width) {
            slice->draw(column, s.strip.column(0), &trace);
            shareOut(trace);
            for (SliceTrace& reflection : trace.reflection) shareOut(reflection);
        }
        take(trace);
    }
}

}  // namespace slicecast

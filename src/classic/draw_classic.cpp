#include "classic/draw_classic.h"

#include "classic/column.h"
#include "classic/trace_column.h"

#include <algorithm>
#include <vector>

namespace slicecast {
namespace {

// All comparisons also refuse NaN.
bool canSee(const World& world, const Eye& eye, const RenderOptions& options) {
    return isAboveFloor(eye) && eye.map >= 0 && eye.map < static_cast<int>(world.maps.size()) &&
           options.fovDegrees >= kMinFovDegrees && options.fovDegrees <= kMaxFovDegrees &&
           eye.look >= -kMaxLook && eye.look <= kMaxLook &&
           eye.headingDegrees - eye.headingDegrees == 0.0;
}

bool areInRange(const ClassicOptions& classic) {
    return classic.stepSize >= kLeastMarchStep && classic.stepSize <= kGreatestMarchStep &&
           classic.reach >= kLeastMarchReach && classic.reach <= kGreatestMarchReach &&
           classic.sineSteps >= 0 && classic.sineSteps <= kMostSineSteps &&
           classic.pixelSize >= 1 && classic.pixelSize <= kMostPixelSize;
}

}  // namespace

std::optional<FrameReport> drawClassic(const World& world, const Eye& eye,
                                       const RenderOptions& options, const ClassicOptions& classic,
                                       LitMaps& lit, const Picture& picture, int columns) {
    if (!canSee(world, eye, options) || !areInRange(classic) ||
        !isPictureSize(picture.width, picture.height) || picture.pixels == nullptr ||
        picture.pitch < picture.width)
        return std::nullopt;
    const int size = classic.pixelSize;
    const int end = std::min(columns, picture.width);
    lit.beginFrame(world, options);
    classic::Column column(world, eye, options, classic, lit, picture.width, picture.height);
    for (int left = 0; left < end; left += size) {
        lit.beginStrip();
        const std::vector<Pixel>& colours = column.draw(left + size / 2.0);
        const int right = std::min(left + size, end);
        for (int y = 0; y < picture.height; ++y)
            std::fill(picture.row(y) + left, picture.row(y) + right,
                      colours[static_cast<std::size_t>(y / size)]);
    }
    FrameReport report = column.report();
    report.lightWork = lit.work();
    report.lateLight = lit.allowance().late;
    report.unlit = lit.allowance().unlit;
    return report;
}

SliceTrace traceClassic(const World& world, const Eye& eye, const RenderOptions& options,
                        const ClassicOptions& classic, LitMaps& lit, const ColumnRequest& request) {
    const auto [width, height, column, watchedRow] = request;
    if (!canSee(world, eye, options) || !areInRange(classic) || !isPictureSize(width, height) ||
        column < 0 || column >= width)
        return {};
    const int size = classic.pixelSize;
    lit.beginFrame(world, options);
    classic::Column drawn(world, eye, options, classic, lit, width, height);
    const int first = column / size * size;
    drawn.draw(first + size / 2.0);
    SliceTrace trace = classic::traceOf(drawn, world, height, watchedRow);
    trace.column = column;
    return trace;
}

}  // namespace slicecast

#include "phases.h"

#include "processor_time.h"
#include "render/paint/slice_paint.h"

#include <algorithm>
#include <utility>

namespace slicecast {
namespace {

double secondsOfReading() {
    constexpr int kReadings = 32;
    const double begin = passingSeconds();
    for (int i = 1; i < kReadings; ++i) passingSeconds();
    return (passingSeconds() - begin) / kReadings;
}

}  // namespace

Phases PhasedFrame::draw(const Picture& picture) {
    // The light that the session has worked out
    std::swap(memory_.lit, session_.renderer().lit());
    // An engine of WebAssembly reads it sooner once it has compiled it.
    secondsOfReading_ = std::min(secondsOfReading_, secondsOfReading());
    Phases phases;
    const double processorBegin = processorSeconds();
    const double begin = passingSeconds();
    double last = begin;
    const auto end = [&](double& phase) {
        const double now = passingSeconds();
        phase += now - last - secondsOfReading_;
        last = now;
    };

    const Eye eye = session_.eye();
    strip_.resize(picture.height);
    const RenderOptions options = renderOptions(session_.options(), picture.width, picture.height);
    const Frame frame(session_.world(), eye, options, picture.width, picture.height, memory_);
    StripWalk walk(frame, strips_, report_);
    SlicePainter painter(frame, reflected_, report_);
    end(phases.setUp);
    for (int x = 0; x < picture.width; x += kStripColumns) {
        frame.lit.beginStrip();
        const int columns = std::min(kStripColumns, picture.width - x);
        walk.find(x, columns);
        end(phases.walk);
        for (int c = 0; c < columns; ++c)
            painter.paint(strips_.found[static_cast<std::size_t>(c)], strip_.column(c));
        end(phases.paint);
        strip_.copyTo(picture, x, columns);
        end(phases.copy);
    }

    std::swap(memory_.lit, session_.renderer().lit());
    const double ours = (processorSeconds() - processorBegin) / (last - begin);
    return phases / std::max(1.0, 1.0 / ours);
}

}  // namespace slicecast

#include "phases.h"

#include "processor_time.h"
#include "render/slice_paint.h"

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

Phases& Phases::operator+=(const Phases& other) {
    setUp += other.setUp;
    walk += other.walk;
    paint += other.paint;
    copy += other.copy;
    return *this;
}

PhasedFrame::PhasedFrame(World world, const Eye& eye, const RenderOptions& options)
    : world_(std::move(world)), eye_(eye), options_(options) {}

Phases PhasedFrame::draw(const Picture& picture) {
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

    strip_.resize(picture.height);
    const Frame frame(world_, eye_, options_, picture.width, picture.height, memory_);
    StripWalk walk(frame, strips_, report_);
    SlicePainter painter(frame, reflected_, report_);
    end(phases.setUp);
    for (int x = 0; x < picture.width; x += kStripColumns) {
        const int columns = std::min(kStripColumns, picture.width - x);
        walk.find(x, columns);
        end(phases.walk);
        for (int c = 0; c < columns; ++c)
            painter.paint(strips_.found[static_cast<std::size_t>(c)], strip_.column(c));
        end(phases.paint);
        strip_.copyTo(picture, x, columns);
        end(phases.copy);
    }

    const double ours = (processorSeconds() - processorBegin) / (last - begin);
    return phases / std::max(1.0, 1.0 / ours);
}

}  // namespace slicecast

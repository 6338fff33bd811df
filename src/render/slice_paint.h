// Fills the rows of a slice from its spans. What stands in the world is nothing to the painter: it
// knows textures, light and rows.
#pragma once

#include "render/column_fill.h"
#include "render/frame.h"
#include "render/slice_spans.h"

#include <cstdint>
#include <vector>

namespace slicecast {

class PlanePoints;

class SlicePainter {
public:
    // All three outlive the painter; `reflected` is room for a column.
    SlicePainter(const Frame& frame, std::vector<Pixel>& reflected, FrameReport& report)
        : frame_(frame), reflected_(reflected), report_(report) {}

    // Fills all rows that the spans hold into `pixels`, one after another.
    void paint(const SliceSpans& slice, Pixel* pixels);

private:
    // Neighbouring rows of one plane that several spans of a walk hold.
    struct PlaneRun {
        PlaneLook* look = nullptr;
        Vista* vista = nullptr;
        TileRange tiles;
        int part = 0;
        int first = -1;  // no rows where `first` is `last`
        int last = -1;
    };

    void paintOpaque(const ColumnSpans& column);
    void paintLayers(const ColumnSpans& column);
    void paintReflection(const SliceSpans& slice);
    void paintTexels(const Span& span, Lay lay);
    void paintTexelsFromWater(const Span& span, Lay lay);
    void paintSky(const Span& span);
    void gather(const Span& span);
    void paintGathered(PlaneRun& run);
    void paintPlane(const PlaneRun& run, Lay lay);
    void paintPlaneByRows(const PlaneRun& run, int first, int last, const PlanePoints& points,
                          Lay lay);
    void count(int first, int last) {
        ++report_.spansDrawn;
        report_.rowsFilled += last - first;
    }

    const Frame& frame_;
    std::vector<Pixel>& reflected_;
    FrameReport& report_;

    int column_ = 0;
    Pixel* pixels_ = nullptr;
    const std::uint8_t* waterFogs_ = nullptr;  // see Vistas; null too for what mirrors show
    PlaneRun falling_;                         // of a plane below the eye
    PlaneRun rising_;                          // of a plane above it
};

}  // namespace slicecast

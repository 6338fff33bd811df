// Fills the rows of a slice from its spans. The painter knows textures, light and rows, but nothing
// of the world.
#pragma once

#include "render/paint/lit_sides.h"
#include "render/pixels/column_fill.h"
#include "render/spans/plane_points.h"
#include "render/spans/slice_spans.h"
#include "render/view/frame.h"

#include <cstdint>
#include <vector>

namespace slicecast {

class SlicePainter {
public:
    // All three must outlive the painter; `reflected` is scratch memory for a column.
    SlicePainter(const Frame& frame, std::vector<Pixel>& reflected, FrameReport& report)
        : frame_(frame), reflected_(reflected), report_(report), sides_(frame) {}

    // Fills all rows of the spans into `pixels`.
    void paint(const SliceSpans& slice, Pixel* pixels);

private:
    // Adjacent rows of one plane from several spans of a walk.
    struct PlaneRun {
        PlaneLook* look = nullptr;
        Vista* vista = nullptr;
        TileRange tiles;
        int part = 0;
        int first = -1;  // no rows if `first` equals `last`
        int last = -1;
        int level = kNoLevel;  // of a block's face, over one tile
        Face face = Face::top;

        bool isLit() const { return vista->lit != nullptr && !look->plane.glow; }
    };
    static PlaneRun runOf(const Span& span) {
        return {span.look,  span.vista, span.tiles, span.part,
                span.first, span.last,  span.level, span.face};
    }

    void paintOpaque(const ColumnSpans& column);
    void paintLayers(const ColumnSpans& column);
    void paintReflection(const SliceSpans& slice);
    void blendRipples(const SliceSpans& slice);  // ripples.cpp
    void paintTexels(const Span& span, Lay lay);
    void paintTexelsFromWater(const Span& span, TexelColumn column, Lay lay);
    void paintSky(const Span& span);
    void gather(const Span& span);
    void paintGathered(PlaneRun& run);
    void paintPlane(const PlaneRun& run, Lay lay);
    void paintPlaneRows(const PlaneRun& run, int first, int last, const PlanePoints& points,
                        Lay lay);
    void paintLitRows(const PlaneRun& run, int first, int last, const PlanePoints& points, Lay lay);
    // lit_rows.cpp
    const Pixel* fetchLitRows(const PlaneRun& run, int first, int last, const TextureLevel& level,
                              const PlaneLine& line, const double* inverseOffsets) const;
    static std::uint32_t linesOf(const PlaneRun& run, int levelBits, std::uint32_t tileX,
                                 std::uint32_t tileY);
    Pixel texelAt(const PlaneRun& run, const TextureLevel& level,
                  const PlanePoints::Point& point) const;
    // smooth_paint.cpp: the same where texels are blended
    bool isSmooth(const Span& span) const {
        return frame_.detail.smooth && span.what == FilledRows::What::side &&
               frame_.detail.isSmooth(span.column.detail, span.column.depth,
                                      frame_.textures[span.image].size);
    }
    TexelColumn smoothColumn(const Span& span) const;
    const Pixel* fetchSmoothRows(const PlaneRun& run, int first, int last, const PlaneLine& line,
                                 const double* inverseOffsets) const;
    Pixel smoothTexelAt(const PlaneRun& run, const PlanePoints::Point& point) const;
    struct ShownTexels;
    TexelColumn litColumn(const Span& span);
    TexelColumn litObject(const Span& span);
    void paintPlaneByRows(const PlaneRun& run, int first, int last, const PlanePoints& points,
                          Lay lay);
    void paintSlope(const Span& span, Lay lay);  // slope_paint.cpp
    void paintSlopeRows(const Span& span, Pixel* pixels, int rows, const PlaneRows& shades,
                        PlaneShade shade, Lay lay);
    void count(int first, int last) {
        ++report_.spansDrawn;
        report_.rowsFilled += last - first;
    }

    const Frame& frame_;
    std::vector<Pixel>& reflected_;
    FrameReport& report_;

    int column_ = 0;
    Pixel* pixels_ = nullptr;
    const std::uint8_t* waterFogs_ = nullptr;  // see Vistas; null for reflections too
    LitSides sides_;
    PlaneRun falling_;  // of a plane below the eye
    PlaneRun rising_;   // of a plane above it
};

}  // namespace slicecast

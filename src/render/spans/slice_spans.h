// What one screen column shows, as plain data: rows, and what fills them. A walk (strip_walk.h)
// makes it without drawing, the painter (slice_paint.h) fills rows from it without knowing the
// world, and a trace (slice_trace.h) lists it.
//
// Spans are in the order in which the walk has found them: front to back. Opaque spans close their
// rows: no two of them share one. Layers are seen through: they are blended over the background,
// farthest first.
#pragma once

#include "render/pixels/column_fill.h"
#include "render/spans/parts.h"
#include "render/trace.h"
#include "render/view/plane_looks.h"
#include "world/blueprint.h"
#include "world/texture.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

// The tiles over which a plane's rows lie: one or several in a row.
struct TileRange {
    int fromX = 0;  // nearest to the eye
    int fromY = 0;
    int toX = 0;
    int toY = 0;
    bool endless = false;  // continues forever in the ray's direction
};

inline constexpr int kNoLevel = -1;  // for spans of no block

// How a column sees a sloped plane: see sloped_plane.h.
struct SpanSlope {
    double height = 0.0;   // above the eye, units; not 0
    double horizon = 0.0;  // row

    friend bool operator==(const SpanSlope&, const SpanSlope&) = default;
};

// Rows [first, last) of a slice. Sides and objects have a column of texels, planes have a look;
// members that a kind of span does not have are undefined (see SpanList).
struct Span {
    FilledRows::What what = FilledRows::What::haze;
    Face face = Face::top;  // of a block
    bool layer = false;
    bool glow = false;  // of a side: it has no baked light
    int first = 0;
    int last = 0;
    int level = kNoLevel;     // of the block
    int object = -1;          // index into Map::objects
    int part = 0;             // the walk that has found it: index into ColumnSpans::parts
    int portals = 0;          // passed before
    std::uint32_t along = 0;  // of a side: where it is in its tile, east or south, in 1/2^32
    Vista* vista = nullptr;   // the map as seen from that part
    TileRange tiles;  // of a plane; for a block's face its tile; unused for sky, haze and objects
    TextureId image = kNoTexture;  // of sides; for objects the sprite
    TexelColumn column;            // of sides and objects
    Coordinate rise;               // of sides: CellBlueprint::textureRise
    Coordinate slide;              // of sides: textureEast or textureSouth, along the side
    PlaneLook* look = nullptr;     // of planes
    SpanSlope slope;               // of sloped ones
};

// Rows that reflect something.
struct MirrorSpan {
    int part = 0;           // the walk whose rays met the mirror
    std::int32_t rise = 0;  // of the mirror above that part's viewpoint, 1/65536 units
    int first = 0;
    int last = 0;
    std::uint32_t strength = 0;  // 1 to 255
    int ripples = 0;             // see ripples.h
};

// Rows whose rays went through a portal.
struct PortalSpan {
    PortalId portal = kNoPortal;
    int portals = 0;     // passed before
    double depth = 0.0;  // see PassedPortal
    int first = 0;
    int last = 0;
};

// The most layers of one column, and of what its mirrors show; farther ones are left out. They
// bound the time of a frame before a field of glass: when a column is full, its walk passes what
// could only add layers. The shipped scenes have at most 91 and 28. A side whose texture splits it
// into two spans counts once.
inline constexpr std::size_t kMaxLayers = 128;
inline constexpr std::size_t kMaxReflectedLayers = 64;

// A list that keeps its memory. Added spans hold old values: each kind uses only a part of the
// members, and clearing all of them would take too long, dozens of times per slice.
class SpanList {
public:
    SpanList() = default;
    SpanList(const SpanList&) = delete;
    SpanList& operator=(const SpanList&) = delete;

    void clear() { end_ = spans_.data(); }
    // Valid until the next add().
    Span& add() {
        if (end_ == room_) grow();
        return *end_++;
    }
    std::size_t count() const { return static_cast<std::size_t>(end_ - spans_.data()); }
    Span& operator[](std::size_t i) { return spans_[i]; }
    const Span* begin() const { return spans_.data(); }
    const Span* end() const { return end_; }

private:
    void grow() {
        const std::size_t used = count();
        spans_.resize(2 * used + 64);
        end_ = spans_.data() + used;
        room_ = spans_.data() + spans_.size();
    }

    std::vector<Span> spans_;
    Span* end_ = nullptr;   // one past the last used one
    Span* room_ = nullptr;  // one past the last allocated one
};

// The results for a column's rays. Memory is kept from slice to slice.
struct ColumnSpans {
    explicit ColumnSpans(std::size_t most) : mostLayers(most) {}

    SpanList spans;
    std::vector<MirrorSpan> mirrors;
    std::vector<PortalSpan> portals;
    Parts parts;  // the walks
    std::size_t layers = 0;
    std::size_t mostLayers;

    bool isFull() const { return layers == mostLayers; }

    void clear() {
        spans.clear();
        mirrors.clear();
        portals.clear();
        parts.clear();
        layers = 0;
    }
};

struct SliceSpans {
    int column = 0;
    ColumnSpans upright{kMaxLayers};
    ColumnSpans reflected{kMaxReflectedLayers};  // by mirrors; its rows are upside down: vista.h
};

}  // namespace slicecast

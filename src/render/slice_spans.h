// What one screen column shows, as plain data: rows, and what fills them. A walk (slice_walk.h)
// makes it without drawing anything, the painter (slice_paint.h) fills rows from it without knowing
// the world, a trace (slice_trace.h) tells of it.
//
// Spans stand in the order in which the walk has found them, which is front to back. Those that are
// no layers close their rows: no two of them share one. Layers are seen through: they are laid over
// what stands behind them, the farthest first.
#pragma once

#include "render/column_fill.h"
#include "render/parts.h"
#include "render/plane_looks.h"
#include "render/trace.h"
#include "world/blueprint.h"
#include "world/texture.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

// The tiles over which a plane's rows lie: one, or several in a row.
struct TileRange {
    int fromX = 0;  // nearest to the eye
    int fromY = 0;
    int toX = 0;
    int toY = 0;
    bool endless = false;  // goes on in the ray's direction for ever
};

inline constexpr int kNoLevel = -1;  // of what belongs to no block

// Rows [first, last) of a slice. Sides and objects have a column of texels, and planes a look;
// what a kind of span does not have holds anything (see SpanList).
struct Span {
    FilledRows::What what = FilledRows::What::haze;
    Face face = Face::top;  // of a block
    bool layer = false;
    int first = 0;
    int last = 0;
    int level = kNoLevel;          // of the block
    int object = -1;               // index into Map::objects
    int part = 0;                  // index of the walk that has found it, into ColumnSpans::parts
    int portals = 0;               // passed before
    Vista* vista = nullptr;        // the map as it is seen from there
    TileRange tiles;               // of a plane; of a block its own; none of sky, haze and objects
    TextureId image = kNoTexture;  // of sides; of objects the sprite
    TexelColumn column;            // of sides and objects
    PlaneLook* look = nullptr;     // of planes
};

// Rows that show something in a mirror.
struct MirrorSpan {
    int part = 0;           // whose rays met the mirror
    std::int32_t rise = 0;  // of the mirror above that part's viewpoint, 1/65536 units
    int first = 0;
    int last = 0;
    std::uint32_t strength = 0;  // 1 to 255
};

// Rows whose rays went through a portal.
struct PortalSpan {
    PortalId portal = kNoPortal;
    int portals = 0;     // passed before
    double depth = 0.0;  // see PassedPortal
    int first = 0;
    int last = 0;
};

// At most this many layers of one column are seen; the farthest beyond are left out. A side that
// its texture falls into two spans is one.
inline constexpr std::size_t kMaxLayers = 4096;

// A list that keeps its memory. What is added holds what stood there before: each span uses a part
// of the members only, and clearing them all would take its time, dozens of times a slice.
class SpanList {
public:
    SpanList() = default;
    SpanList(const SpanList&) = delete;
    SpanList& operator=(const SpanList&) = delete;

    void clear() { end_ = spans_.data(); }
    // Valid until the next one is added.
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
    Span* end_ = nullptr;   // one past the last that is used
    Span* room_ = nullptr;  // one past the last that is there
};

// What is found on the way of a column's rays. Memory is kept from slice to slice.
struct ColumnSpans {
    SpanList spans;
    std::vector<MirrorSpan> mirrors;
    std::vector<PortalSpan> portals;
    Parts parts;  // the walks
    std::size_t layers = 0;

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
    ColumnSpans upright;
    ColumnSpans reflected;  // what shows in mirrors; its rows are upside down (see vista.h)
};

}  // namespace slicecast

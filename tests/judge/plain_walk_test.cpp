// The two walks before random worlds: row by row they must find the same. The plain one is what the
// fast one is held against, as pictures take it, sixteen columns at once, and as traces do, each by
// itself.
#include "draw.h"
#include "random_scene.h"
#include "suite.h"

#include "plain_walk.h"
#include "raw_span_text.h"
#include "render/slice_stage.h"
#include "sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace slicecast::judge {
namespace {

using What = FilledRows::What;

constexpr int kShare = kSanitized ? 10 : 1;

// What one row shows.
struct Row {
    const Span* opaque = nullptr;
    std::vector<const Span*> layers;         // front to back
    std::vector<const PortalSpan*> portals;  // in the order in which they are passed
    std::vector<const MirrorSpan*> mirrors;
};

std::uint32_t alphaOf(const Span& span, int row) {
    const std::uint64_t position =
        span.column.start + static_cast<std::uint64_t>(row - span.first) * span.column.step;
    return span.column.texels[position >> span.column.shift] >> 24;
}

// Removes the layers that show nothing in a row, and all that lie behind an opaque texel.
void forgetHidden(Row& row, int number) {
    std::vector<const Span*> seen;
    for (const Span* layer : row.layers) {
        const std::uint32_t alpha = hasTexelColumn(*layer) ? alphaOf(*layer, number) : 128;
        if (alpha == 0) continue;
        if (alpha < 255) {
            seen.push_back(layer);
            continue;
        }
        row.opaque = layer;
        break;
    }
    row.layers = std::move(seen);
    if (row.opaque == nullptr || !hasTexelColumn(*row.opaque)) return;
    row.mirrors.clear();
    std::erase_if(row.portals,
                  [&](const PortalSpan* span) { return span->portals >= row.opaque->portals; });
}

std::vector<Row> rowsOf(const ColumnSpans& column, int height) {
    std::vector<Row> rows(static_cast<std::size_t>(height));
    const auto each = [&](const auto& span, auto fn) {
        for (int row = span.first; row < span.last; ++row) fn(rows[static_cast<std::size_t>(row)]);
    };
    for (const Span& span : column.spans) {
        each(span, [&](Row& row) {
            if (span.layer) {
                row.layers.push_back(&span);
            } else {
                EXPECT_EQ(row.opaque, nullptr) << "two opaque spans share a row";
                row.opaque = &span;
            }
        });
    }
    for (const PortalSpan& span : column.portals)
        each(span, [&](Row& row) { row.portals.push_back(&span); });
    for (const MirrorSpan& span : column.mirrors)
        each(span, [&](Row& row) { row.mirrors.push_back(&span); });
    for (int row = 0; row < height; ++row) forgetHidden(rows[static_cast<std::size_t>(row)], row);
    return rows;
}

std::int64_t positionAt(const Span& span, int row) {
    return static_cast<std::int64_t>(span.column.start) +
           (row - span.first) * static_cast<std::int64_t>(span.column.step);
}

// Whether the one tile of the plain walk's span is among those of the fast one's.
bool covers(const TileRange& fast, const TileRange& plain, GroundDirection ray) {
    const auto holds = [&](int from, int to, int tile, double direction) {
        if (fast.endless && direction > 0.0) return tile >= from;
        if (fast.endless && direction < 0.0) return tile <= from;
        return std::min(from, to) <= tile && tile <= std::max(from, to);
    };
    return holds(fast.fromX, fast.toX, plain.fromX, ray.x) &&
           holds(fast.fromY, fast.toY, plain.fromY, ray.y);
}

// How far the texel positions of a row may lie apart if the two walks begin or end the span in
// different rows, as for layers that are cut. Steps are rounded once a row. They are also shortened
// if the last row would lie beyond the block by more than the margin of positions, 2^14 of 2^48.
std::int64_t mayBeApart(const Span& span, int rows) {
    return rows + 2 + (span.what == What::side ? std::int64_t{1} << 14 : 0);
}

// Whether a side's texture may begin anew in the first row, or behind the last: the texture of what
// moves does. Then the rows may be a piece of more, which each walk counts from a row of its own.
bool mayBePiece(const Span& span) {
    constexpr std::int64_t kEnd = std::int64_t{1} << kTexturePositionBits;
    return span.what == What::side &&
           (span.column.start < span.column.step || positionAt(span, span.last) >= kEnd);
}

bool isSameColumn(const Span& fast, const Span& plain, int row) {
    const TexelColumn& a = fast.column;
    const TexelColumn& b = plain.column;
    if (a.texels != b.texels || a.shift != b.shift || a.detail != b.detail ||
        a.factor != b.factor || a.fog != b.fog || a.depth != b.depth)
        return false;
    const std::int64_t apart = std::abs(positionAt(fast, row) - positionAt(plain, row));
    if (fast.first == plain.first && fast.last == plain.last && !plain.layer && !mayBePiece(fast) &&
        !mayBePiece(plain))
        return apart == 0;
    return apart <= mayBeApart(fast, row);
}

bool isSame(const Span& fast, const Span& plain, int row, int column) {
    if (fast.what != plain.what || fast.vista != plain.vista || fast.portals != plain.portals ||
        fast.level != plain.level || fast.object != plain.object)
        return false;
    if (fast.level != kNoLevel && fast.face != plain.face) return false;
    if (isPlane(fast))
        return fast.look == plain.look && (!fast.look->plane.sloped || fast.slope == plain.slope) &&
               covers(fast.tiles, plain.tiles, fast.vista->ray(column));
    if (!hasTexelColumn(fast)) return true;
    if (fast.what == What::side && !covers(fast.tiles, plain.tiles, {})) return false;
    return fast.image == plain.image && isSameColumn(fast, plain, row);
}

template <typename Things, typename Equal>
bool areAll(const Things& a, const Things& b, Equal equal) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), equal);
}

bool isSameRow(const Row& fast, const Row& plain, int row, int column) {
    const auto span = [&](const Span* a, const Span* b) { return isSame(*a, *b, row, column); };
    if ((fast.opaque == nullptr) != (plain.opaque == nullptr) ||
        (fast.opaque != nullptr && !span(fast.opaque, plain.opaque)))
        return false;
    return areAll(fast.layers, plain.layers, span) &&
           areAll(fast.portals, plain.portals,
                  [](const PortalSpan* a, const PortalSpan* b) {
                      return a->portal == b->portal && a->portals == b->portals &&
                             a->depth == b->depth;
                  }) &&
           areAll(fast.mirrors, plain.mirrors, [](const MirrorSpan* a, const MirrorSpan* b) {
               return a->rise == b->rise && a->strength == b->strength && a->ripples == b->ripples;
           });
}

// A row's spans, front to back.
std::string textOf(const Row& row) {
    std::string text;
    for (const Span* layer : row.layers) text += "    " + slicecast::textOf(*layer) + "\n";
    text += "    " + (row.opaque ? slicecast::textOf(*row.opaque) : std::string("nothing")) + "\n";
    for (const PortalSpan* span : row.portals)
        appendFormatted(text, "    through portal %d, after %d others, at depth %g\n",
                        static_cast<int>(span->portal), span->portals, span->depth);
    for (const MirrorSpan* span : row.mirrors)
        appendFormatted(text, "    mirror with strength %u at a rise of %d\n", span->strength,
                        span->rise);
    return text;
}

// Tells of the first row that differs; empty if none does.
std::string difference(const std::vector<Row>& fast, const std::vector<Row>& plain, int column) {
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const auto row = static_cast<int>(i);
        if (!isSameRow(fast[i], plain[i], row, column))
            return "row " + std::to_string(row) + " differs\n  one walk:\n" + textOf(fast[i]) +
                   "  the other:\n" + textOf(plain[i]);
    }
    return {};
}

// What is found in mirrors, which stands upside down, and is seen in rows that show a mirror.
std::vector<Row> mirroredRows(const ColumnSpans& reflected, const std::vector<Row>& upright) {
    const std::size_t height = upright.size();
    std::vector<Row> rows = rowsOf(reflected, static_cast<int>(height));
    for (std::size_t i = 0; i < height; ++i) {
        if (upright[height - 1 - i].mirrors.empty()) rows[i] = {};
    }
    return rows;
}

constexpr int kMostTold = 3;  // differences: one shows enough

// What both have found, and how often.
struct Sum {
    int worlds = 0;
    int columns = 0;
    int full = 0;  // of them, not compared
    std::int64_t rows = 0;
    int differences = 0;
    std::int64_t pixelsApart = 0;
    std::map<std::string, std::int64_t> seen;  // rows of each kind

    void add(const ColumnSpans& column, const char* prefix) {
        for (const Span& span : column.spans) {
            const std::string name = std::string(prefix) + (span.layer ? "layer " : "") +
                                     nameOf(span.what) +
                                     (span.portals > 0 ? " behind portals" : "");
            seen[name] += span.last - span.first;
        }
    }
};

class Walks {
public:
    Walks(const Scene& scene, std::string name, Sum& sum)
        : view_(scene.view),
          name_(std::move(name)),
          sum_(sum),
          stage_(scene.world, eyeOf(view_), view_.width, view_.height, optionsOf(view_)) {}

    void compareAll() {
        ++sum_.worlds;
        OpenRows open;
        PlainWalk plain(stage_.frame(), open);
        SliceSpans plainSpans;
        for (int first = 0; first < view_.width; first += kLanes) {
            const std::span<const SliceSpans> together =
                stage_.findTogether(first, std::min(kLanes, view_.width - first));
            for (const SliceSpans& fast : together) {
                plain.find(fast.column, plainSpans);
                compare(fast, plainSpans);
                compare(stage_.find(fast.column), plainSpans);
                sum_.add(plainSpans.upright, "");
                sum_.add(plainSpans.reflected, "mirrored ");
            }
        }
    }

private:
    void compare(const SliceSpans& fast, const SliceSpans& plain) {
        ++sum_.columns;
        // Only the fast walk closes rows behind opaque texels, and so is full later
        if (plain.upright.isFull() || plain.reflected.isFull()) {
            ++sum_.full;
            return;
        }
        sum_.rows += view_.height;
        const std::vector<Row> fastRows = rowsOf(fast.upright, view_.height);
        const std::vector<Row> plainRows = rowsOf(plain.upright, view_.height);
        std::string apart = difference(fastRows, plainRows, fast.column);
        if (apart.empty()) {
            apart = difference(mirroredRows(fast.reflected, fastRows),
                               mirroredRows(plain.reflected, plainRows), fast.column);
            if (!apart.empty()) apart = "in mirrors: " + apart;
        }
        if (!apart.empty()) return complain(apart, fast, plain);
        const std::vector<Pixel> fastPixels = stage_.paint(fast);
        const std::vector<Pixel> plainPixels = stage_.paint(plain);
        for (int y = 0; y < view_.height; ++y) {
            const auto i = static_cast<std::size_t>(y);
            if (fastPixels[i] == plainPixels[i]) continue;
            ++sum_.pixelsApart;
            complain("the pixel of row " + std::to_string(y) + " differs\n", fast, plain);
        }
    }

    void complain(const std::string& apart, const SliceSpans& fast, const SliceSpans& plain) {
        if (++sum_.differences > kMostTold) return;
        ADD_FAILURE() << name_ << ", column " << fast.column << ", " << apart
                      << "all that one walk has found: " << slicecast::textOf(fast)
                      << "all that the other has found: " << slicecast::textOf(plain);
    }

    const View& view_;
    std::string name_;
    Sum& sum_;
    known::SliceStage stage_;
};

template <typename Sizes>
Sum compareAll(MakeScene make, const char* what, const Sizes& sizes, int count) {
    Sum sum;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(count); ++seed) {
        const Size size = sizes[seed % sizes.size()];
        const Scene scene = make(seed, size.width, size.height);
        Walks(scene, std::string(what) + " " + std::to_string(seed), sum).compareAll();
    }
    std::printf(
        "%s: %d worlds, %d columns, %lld rows; %d differences, %lld of them in pixels alone\n",
        what, sum.worlds, sum.columns, static_cast<long long>(sum.rows), sum.differences,
        static_cast<long long>(sum.pixelsApart));
    // A share of the worlds may be one that has many.
    if (kShare == 1) {
        EXPECT_LE(sum.full, sum.columns / 500) << "columns are full of layers";
    }
    return sum;
}

TEST(PlainWalk, FindsWhatTheFastOneFinds) {
    Sum sum = compareAll(randomScene, "random scenes", kSmallSizes, 1500 / kShare);
    EXPECT_EQ(sum.differences, 0);
    // What is never seen is not compared; a share of the worlds does not hold all.
    if (kShare > 1) return;
    for (const char* kind :
         {"side", "roof", "underside", "floor", "ceiling", "sky", "haze", "layer side",
          "layer roof", "layer underside", "layer ceiling", "layer object"}) {
        EXPECT_GE(sum.seen[kind], 20'000) << kind;
        EXPECT_GE(sum.seen[std::string(kind) + " behind portals"], 1'000) << kind;
    }
    for (const char* kind : {"side", "underside", "ceiling", "sky", "layer side", "layer roof",
                             "layer underside", "layer ceiling", "layer object"})
        EXPECT_GE(sum.seen[std::string("mirrored ") + kind], 5'000) << kind;
}

TEST(PlainWalk, FindsTheSameWhereRaysMeetEdgesExactly) {
    const Sum sum = compareAll(tieScene, "scenes made to tie", kSmallSizes, 800 / kShare);
    EXPECT_EQ(sum.differences, 0);
}

// In wide pictures strips are narrow: their columns mostly come through the same tiles.
constexpr std::array kWideSizes = {Size{200, 40}, Size{333, 60}, Size{640, 30}};

TEST(PlainWalk, FindsTheSameInWidePictures) {
    EXPECT_EQ(compareAll(randomScene, "wide random scenes", kWideSizes, 150 / kShare).differences,
              0);
    EXPECT_EQ(compareAll(tieScene, "wide scenes made to tie", kWideSizes, 150 / kShare).differences,
              0);
}

TEST(PlainWalk, FindsTheSameOverWideLand) {
    EXPECT_EQ(compareAll(wideLandScene, "wide land", kSmallSizes, 400 / kShare).differences, 0);
    EXPECT_EQ(compareAll(wideLandScene, "wide land, wide", kWideSizes, 150 / kShare).differences,
              0);
}

}  // namespace
}  // namespace slicecast::judge

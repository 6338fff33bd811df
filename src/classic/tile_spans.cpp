#include "classic/tile_spans.h"

#include <cmath>
#include <limits>

namespace slicecast::classic {
namespace {

// The next border on one axis.
struct Borders {
    double speed = 0.0;  // along the axis, with its sign
    double distance = 0.0;
    int step = 0;

    Borders(double eye, int tile, double direction) : speed(direction) {
        step = direction > 0.0 ? 1 : direction < 0.0 ? -1 : 0;
        distance = step > 0 ? tile + 1 - eye : eye - tile;
    }
    double along() const {
        return step == 0 ? std::numeric_limits<double>::infinity() : distance / std::fabs(speed);
    }
};

int tileOf(double position) {
    return static_cast<int>(std::floor(position));
}

// True if the grid has no further tile along an axis.
bool isPast(int tile, int end, double direction) {
    return tile < 0 ? direction <= 0.0 : tile >= end && direction >= 0.0;
}

// The side of its tile that a point is closest to.
Face nearestSide(double fromMiddleX, double fromMiddleY) {
    if (std::fabs(fromMiddleX) > std::fabs(fromMiddleY))
        return fromMiddleX < 0.0 ? Face::west : Face::east;
    return fromMiddleY < 0.0 ? Face::north : Face::south;
}

// Cuts off what of a span lies before an edge, or behind it.
void enterAt(TileSpan& span, double along, Face face) {
    if (along <= span.enter) return;
    span.enter = along;
    span.entered = face;
    span.first = false;
}
void leaveAt(TileSpan& span, double along, Face face) {
    if (along >= span.leave) return;
    span.leave = along;
    span.left = face;
}

// An axis of a plan: what lies between `low` and `high` of the tile.
struct PlanAxis {
    Coordinate low;
    Coordinate high;
    Face lowFace = Face::west;
    Face highFace = Face::east;
};

// Cuts a span at the edges within its tile. False if the line passes beside the plan.
bool cutAt(const PlanAxis& axis, double from, double direction, TileSpan& span) {
    if (direction == 0.0) return axis.low.value() <= from && from < axis.high.value();
    const auto cut = [&](Coordinate edge, Face face, bool entering) {
        const double along = (edge.value() - from) / direction;
        entering ? enterAt(span, along, face) : leaveAt(span, along, face);
    };
    if (axis.low.raw > 0) cut(axis.low, axis.lowFace, direction > 0.0);
    if (axis.high < tileEdge(1)) cut(axis.high, axis.highFace, direction < 0.0);
    return true;
}

}  // namespace

std::optional<TileSpan> spanOver(const Plan& plan, const View& view, const ColumnRay& ray,
                                 const TileSpan& tile) {
    if (plan.isWhole()) return tile;
    TileSpan span = tile;
    const double x = view.eyeX - tile.x;
    const double y = view.eyeY - tile.y;
    if (!cutAt({plan.west, plan.east, Face::west, Face::east}, x, ray.x, span) ||
        !cutAt({plan.north, plan.south, Face::north, Face::south}, y, ray.y, span))
        return std::nullopt;
    if (plan.half != Half::none) {
        // How far the eye is on the half's side of the cut, and how fast the line goes there
        const bool isFalling = isCutFalling(plan.half);
        const double sign = isEastern(plan.half) ? 1.0 : -1.0;
        const double inside = sign * (isFalling ? x - y : x + y - 1.0);
        const double inwards = sign * (isFalling ? ray.x - ray.y : ray.x + ray.y);
        if (inwards == 0.0 && inside <= 0.0) return std::nullopt;
        if (inwards > 0.0) enterAt(span, -inside / inwards, cutFace(plan.half));
        if (inwards < 0.0) leaveAt(span, -inside / inwards, cutFace(plan.half));
    }
    if (span.enter >= span.leave) return std::nullopt;
    return span;
}

std::int64_t walkTiles(const Map& map, const View& view, const ColumnRay& ray,
                       const TileStart& start, std::vector<TileSpan>& spans) {
    spans.clear();
    TileSpan span;
    span.x = start.x;
    span.y = start.y;
    span.enter = start.along;
    span.first = true;
    Borders x(view.eyeX, span.x, ray.x);
    Borders y(view.eyeY, span.y, ray.y);
    std::int64_t samples = 0;
    while (!isPast(span.x, map.width, ray.x) && !isPast(span.y, map.depth, ray.y)) {
        ++samples;
        // At a corner an eastward border comes first, because the eye counts as slightly further
        // east
        const bool alongX = x.along() < y.along() || (x.along() == y.along() && x.step > 0);
        Borders& next = alongX ? x : y;
        span.leave = next.along();
        span.left = alongX ? (next.step > 0 ? Face::east : Face::west)
                           : (next.step > 0 ? Face::south : Face::north);
        if (map.contains(span.x, span.y)) spans.push_back(span);

        span.enter = span.leave;
        span.entered = alongX ? (next.step > 0 ? Face::west : Face::east)
                              : (next.step > 0 ? Face::north : Face::south);
        span.first = false;
        (alongX ? span.x : span.y) += next.step;
        next.distance += 1.0;
    }
    return samples;
}

std::int64_t marchTiles(const Map& map, const View& view, const ColumnRay& ray,
                        const TileStart& start, const ClassicOptions& classic,
                        std::vector<TileSpan>& spans) {
    spans.clear();
    TileSpan span;
    span.x = start.x;
    span.y = start.y;
    span.enter = start.along;
    span.first = true;
    std::int64_t samples = 0;
    // #region march
    const auto strides = static_cast<std::int64_t>(classic.reach / classic.stepSize);
    const auto begun = static_cast<std::int64_t>(start.along * ray.length / classic.stepSize);
    for (std::int64_t stride = begun + 1; stride <= strides; ++stride) {
        ++samples;
        const double along = static_cast<double>(stride) * classic.stepSize / ray.length;
        const double x = view.eyeX + along * ray.x;
        const double y = view.eyeY + along * ray.y;
        const int tileX = tileOf(x);
        const int tileY = tileOf(y);
        if (tileX == span.x && tileY == span.y) continue;
        span.leave = along;
        span.left = nearestSide(x - span.x - 0.5, y - span.y - 0.5);
        if (map.contains(span.x, span.y)) spans.push_back(span);
        if (isPast(tileX, map.width, ray.x) || isPast(tileY, map.depth, ray.y)) return samples;

        span = {tileX,      tileY, along,
                along,      false, nearestSide(x - tileX - 0.5, y - tileY - 0.5),
                Face::north};
    }
    // #endregion
    span.leave = static_cast<double>(strides) * classic.stepSize / ray.length;
    if (map.contains(span.x, span.y)) spans.push_back(span);
    return samples;
}

}  // namespace slicecast::classic

#include "render/ask/slice_trace.h"

#include "base/sort.h"
#include "render/light/lit_texels.h"
#include "render/paint/lit_planes.h"
#include "render/spans/plan_walk.h"
#include "render/spans/plane_points.h"
#include "render/spans/ripples.h"
#include "render/spans/sloped_plane.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace slicecast {
namespace {

using What = FilledRows::What;

bool hasTexels(What what) {
    return what == What::side || what == What::object;
}

bool isPlane(What what) {
    return !hasTexels(what) && what != What::sky && what != What::haze;
}

// Traces the upright column, or the upside down one.
class Tracer {
public:
    Tracer(const Frame& frame, int column, const ColumnSpans& found, bool isUpright,
           SliceTrace& trace)
        : frame_(frame),
          column_(column),
          found_(found),
          waterFogs_(isUpright ? frame.vistas.waterFogs() : nullptr),
          trace_(trace) {}

    void trace() {
        for (std::size_t i = 0; i < found_.parts.count(); ++i) {
            firstHits_.push_back(trace_.hits.size());
            addPart(found_.parts[i]);
        }
        firstHits_.push_back(trace_.hits.size());
        for (const Span& span : found_.spans) addRun(span);
        putLayersFirst();
        for (const PortalSpan& span : found_.portals)
            trace_.portals.push_back(
                {span.portal, span.portals, span.depth, span.first, span.last});
        for (const MirrorSpan& span : found_.mirrors) {
            const Viewpoint& from =
                found_.parts[static_cast<std::size_t>(span.part)].vista->viewpoint;
            trace_.mirrors.push_back({from.map,
                                      static_cast<int>(span.strength),
                                      {from.z + span.rise},
                                      span.first,
                                      span.last});
        }
    }

private:
    // Rows of floor that go on behind an object were found before it, as one run.
    void putLayersFirst() {
        std::vector<SeenPoint>& seen = trace_.seen;
        const auto opaque = std::find_if(seen.begin(), seen.end(), [this](const SeenPoint& point) {
            return !trace_.filled[static_cast<std::size_t>(point.run)].layer;
        });
        if (opaque != seen.end()) std::rotate(opaque, opaque + 1, seen.end());
    }

    // Repeats the walk of a part to list its tiles and the blocks in them.
    void addPart(const Part& part) {
        const Vista& vista = *part.vista;
        GridWalk walk = part.walk;
        for (int tile = 0; tile < part.tiles; ++tile) {
            if (tile > 0) walk.advance();
            if (!vista.map->contains(walk.tileX, walk.tileY)) continue;
            addTile(part, walk);
            if (part.endsInPortal && tile == part.tiles - 1) return;
            std::uint32_t levels =
                vista.map->occupied[vista.map->tileIndex(walk.tileX, walk.tileY)];
            for (; levels != 0; levels &= levels - 1) addHit(part, walk, std::countr_zero(levels));
        }
    }

    void addTile(const Part& part, const GridWalk& walk) {
        const Crossing border = walk.enter();
        trace_.tiles.push_back({part.vista->viewpoint.map, walk.tileX, walk.tileY,
                                walk.entered * part.vista->projection->distance, part.portals,
                                walk.hasEntered(), border.alongX, walk.entered, border.distance,
                                border.speed, walk.nextAlongX(), walk.nextAlongY()});
    }

    void addHit(const Part& part, const GridWalk& walk, int level) {
        const Vista& vista = *part.vista;
        const Projection& projection = *vista.projection;
        const GroundDirection ray = vista.ray(column_);
        const BlueprintId id = vista.map->cell(walk.tileX, walk.tileY, level);
        const CellBlueprint& blueprint = frame_.world->blueprints[id];
        const PlanPassage passage = PlanWalk(walk, vista.viewpoint, ray).passage(blueprint.plan);
        if (!passage.isMet) return;
        const Crossing enter = passage.enter.inner ? passage.enter : walk.enter();
        const Crossing leave = passage.leave.inner ? passage.leave : walk.leave();
        Hit& hit = trace_.hits.emplace_back();
        hit.map = vista.viewpoint.map;
        hit.portals = part.portals;
        hit.tileX = walk.tileX;
        hit.tileY = walk.tileY;
        hit.level = level;
        hit.blueprint = id;
        hit.entered = enter.along > 0.0;
        hit.face = enteredFace(enter);
        hit.depth = enter.along * projection.distance;
        hit.backDepth = leave.along * projection.distance;
        hit.x = vista.viewpoint.tileX() + vista.viewpoint.fractionX() + ray.x * enter.along;
        hit.y = vista.viewpoint.tileY() + vista.viewpoint.fractionY() + ray.y * enter.along;
        hit.rawDepth = enter.along * std::sqrt(ray.x * ray.x + ray.y * ray.y);
        hit.bottom = tileEdge(level) + blueprint.bottom;
        hit.top = tileEdge(level) + blueprint.top;
        // Height above the eye, as it was over the eye and as it rises
        const auto rowOf = [&](double rise, double perDepth, double depth) {
            const double there = rise + (perDepth != 0.0 ? perDepth * depth : 0.0);
            return there == 0.0 ? projection.horizon : projection.rowOf(there, depth);
        };
        double top = Coordinate{hit.top.raw - vista.viewpoint.z}.value();
        double bottom = Coordinate{hit.bottom.raw - vista.viewpoint.z}.value();
        const auto rise = [&](const Slant& slant, double& height, double& perDepth) {
            if (slant.isLevel()) return;
            const SlopedPlane plane(blueprint.slopes, slant, walk.tileX, walk.tileY,
                                    tileEdge(level).raw - vista.viewpoint.z, vista.viewpoint, ray,
                                    projection);
            height = plane.height;
            perDepth = plane.rise * (plane.alongX ? ray.x : ray.y) / projection.distance;
        };
        rise(blueprint.slopes.top, top, hit.topSlope);
        rise(blueprint.slopes.bottom, bottom, hit.bottomSlope);
        hit.topFrontRow = rowOf(top, hit.topSlope, hit.depth);
        hit.bottomFrontRow = rowOf(bottom, hit.bottomSlope, hit.depth);
        hit.topBackRow = rowOf(top, hit.topSlope, hit.backDepth);
        hit.bottomBackRow = rowOf(bottom, hit.bottomSlope, hit.backDepth);
    }

    int hitOf(const Span& span) const {
        if (span.level == kNoLevel) return -1;
        const auto part = static_cast<std::size_t>(span.part);
        for (std::size_t i = firstHits_[part]; i < firstHits_[part + 1]; ++i) {
            const Hit& hit = trace_.hits[i];
            if (hit.tileX == span.tiles.fromX && hit.tileY == span.tiles.fromY &&
                hit.level == span.level)
                return static_cast<int>(i);
        }
        return -1;
    }

    void addRun(const Span& span) {
        FilledRows rows;
        rows.what = span.what;
        rows.face = span.face;
        rows.first = span.first;
        rows.last = span.last;
        rows.map = span.vista->viewpoint.map;
        rows.portals = span.portals;
        rows.hit = hitOf(span);
        rows.layer = span.layer;
        if (span.what == What::object) {
            rows.object = static_cast<int>(trace_.objects.size());
            trace_.objects.push_back(
                {rows.map, span.portals, span.object, span.column.depth, span.first, span.last});
            rows.side = shownSide(span);
        }
        const bool isWatched = span.first <= trace_.watchedRow && trace_.watchedRow < span.last;
        if (isWatched) {
            SeenPoint& point = trace_.seen.emplace_back();
            point.run = static_cast<int>(trace_.filled.size());
            point.texel.depth = std::numeric_limits<double>::infinity();
        }
        if (hasTexels(span.what)) {
            setTexels(span, rows, isWatched);
        } else if (isPlane(span.what)) {
            setPlaneTexels(span, rows, isWatched);
        }
        trace_.filled.push_back(rows);
    }

    void setTexels(const Span& span, FilledRows& rows, bool isWatched) {
        const TexelColumn& column = span.column;
        rows.texture = span.image;
        const auto texelAt = [&](int row) {
            const std::uint64_t position =
                column.start + static_cast<std::uint64_t>(row - span.first) * column.step;
            TracedTexel texel;
            texel.depth = column.depth;
            texel.detail = column.detail;
            texel.u = columnNumber(span);
            texel.v = static_cast<int>(position >> column.shift);
            texel.baked = bakedLight(span, texel);
            texel.light = column.factor;
            texel.fog = fogIn(row, column.fog);
            return texel;
        };
        rows.top = texelAt(span.first);
        rows.bottom = texelAt(span.last - 1);
        if (isWatched) setPoint(span, texelAt(trace_.watchedRow));
        rows.rowsOfDetail[static_cast<std::size_t>(column.detail)] =
            static_cast<std::uint16_t>(span.last - span.first);
    }

    // Of a side's texel, or of an object.
    LightColour bakedLight(const Span& span, const TracedTexel& texel) const {
        const LightColour none = TracedTexel().baked;
        if (span.vista->lit == nullptr) return none;
        if (span.what == What::object) {
            const auto object = static_cast<std::size_t>(span.object);
            return span.vista->map->objects[object].glow ? none
                                                         : span.vista->lit->ofObject(span.object);
        }
        const auto face = static_cast<LitFace>(span.face);
        const FaceNodes* const nodes =
            span.glow
                ? nullptr
                : span.vista->lit->nodesOf({span.tiles.fromX, span.tiles.fromY, span.level, face});
        if (nodes == nullptr) return none;
        const int size =
            frame_.textures[span.image].levels[static_cast<std::size_t>(texel.detail)].size;
        const bool reversed = face == LitFace::north || face == LitFace::east;
        const int down = (middleOf(texel.v, size) - span.rise.raw) & 65535;
        const int along = middleOf(reversed ? size - 1 - texel.u : texel.u, size);
        return lightAt(*nodes, (along + span.slide.raw) & 65535, std::min(65535, 65536 - down));
    }

    // Above the eye's water, fog is limited to that of the way to the surface.
    std::uint32_t fogIn(int row, std::uint32_t fog) const {
        return waterFogs_ == nullptr ? fog : std::min<std::uint32_t>(fog, waterFogs_[row]);
    }

    ObjectSide shownSide(const Span& span) const {
        const Vista& vista = *found_.parts[static_cast<std::size_t>(span.part)].vista;
        const Viewpoint& from = vista.viewpoint;
        const Object& object = vista.map->objects[static_cast<std::size_t>(span.object)];
        return sideTowards(object, from.x - object.x.raw, from.y - object.y.raw);
    }

    const SharedVector<SpriteLevel>& shownLevels(const Span& span) const {
        return frame_.world->sprites[span.image].levelsAt(frame_.world->steps, shownSide(span));
    }

    // The index of the column of texels, from the left.
    int columnNumber(const Span& span) const {
        const auto detail = static_cast<std::size_t>(span.column.detail);
        if (span.what == What::object) {
            const SpriteLevel& level = shownLevels(span)[detail];
            return static_cast<int>((span.column.texels - level.texels.data()) / level.height);
        }
        const TextureLevel& level = frame_.textures[span.image].levels[detail];
        return static_cast<int>((span.column.texels - level.texels.data()) >> level.bits);
    }

    void setPlaneTexels(const Span& span, FilledRows& rows, bool isWatched) {
        const Plane& plane = span.look->plane;
        const Vista& vista = *span.vista;
        const FrameTexture& texture = frame_.textures[plane.texture];
        const double height = plane.sloped ? std::fabs(span.slope.height) : span.look->height;
        const PlanePoints points(vista, vista.ray(column_), height, plane.southReversed,
                                 span.tiles);
        const auto inverseAt = [&](int row) {
            return plane.sloped ? 1.0 / std::fabs(span.slope.horizon - (row + 0.5))
                                : vista.inverseOffsets[row];
        };
        const auto depthAt = [&](int row) {
            return height * vista.projection->distance * inverseAt(row);
        };
        const auto detailAt = [&](int row) {
            return frame_.detail.levelAt(depthAt(row), texture.size, texture.last);
        };
        const auto texelAt = [&](int row) {
            const double inverse = inverseAt(row);
            const double depth = depthAt(row);
            const int detail = detailAt(row);
            const TextureLevel& shown = texture.levels[detail];
            const PlanePoints::Point point = points.at(inverse);
            const auto v = static_cast<int>(texelIn(point.south, plane.south, shown.bits));
            const Shade shade = vista.lighting.at(depth, plane.light, plane.glow);
            TracedTexel texel;
            texel.depth = depth;
            texel.detail = detail;
            texel.u = static_cast<int>(texelIn(point.east, plane.east, shown.bits));
            texel.v = plane.southReversed ? shown.size - 1 - v : v;
            if (vista.lit != nullptr && !plane.glow) {
                texel.baked = lightAt(planeNodes(span, point.tileX, point.tileY),
                                      (middleOf(texel.u, shown.size) + plane.east.raw) & 65535,
                                      (middleOf(v, shown.size) + plane.south.raw) & 65535);
            }
            texel.light = shade.factor;
            texel.fog = fogIn(row, shade.fog);
            return texel;
        };
        rows.texture = plane.texture;
        rows.top = texelAt(span.first);
        rows.bottom = texelAt(span.last - 1);
        if (isWatched) setPoint(span, texelAt(trace_.watchedRow));
        for (int row = span.first; row < span.last; ++row)
            ++rows.rowsOfDetail[static_cast<std::size_t>(detailAt(row))];
    }

    // The point that the watched row shows.
    void setPoint(const Span& span, const TracedTexel& texel) {
        const Vista& vista = *span.vista;
        const GroundDirection ray = vista.ray(column_);
        const double along = texel.depth / vista.projection->distance;
        SeenPoint& point = trace_.seen.back();
        point.texel = texel;
        point.x = vista.viewpoint.tileX() + vista.viewpoint.fractionX() + ray.x * along;
        point.y = vista.viewpoint.tileY() + vista.viewpoint.fractionY() + ray.y * along;
        point.z = Coordinate{vista.viewpoint.z}.value() +
                  vista.projection->upwardSlope(trace_.watchedRow) * texel.depth;
    }

    const Frame& frame_;
    const int column_;
    const ColumnSpans& found_;
    const std::uint8_t* const waterFogs_;
    SliceTrace& trace_;
    std::vector<std::size_t> firstHits_;  // of each part, then the end
};

// Turns the trace of a reflection upright.
void turnUpright(SliceTrace& trace, int height) {
    const auto turn = [height](auto& rows) {
        rows.first = height - std::exchange(rows.last, height - rows.first);
    };
    if (trace.watchedRow >= 0) trace.watchedRow = height - 1 - trace.watchedRow;
    for (FilledRows& rows : trace.filled) {
        turn(rows);
        std::swap(rows.top, rows.bottom);
    }
    for (SeenObject& object : trace.objects) turn(object);
    for (PassedPortal& portal : trace.portals) turn(portal);
    for (Hit& hit : trace.hits) {
        for (double* row :
             {&hit.topFrontRow, &hit.bottomFrontRow, &hit.topBackRow, &hit.bottomBackRow})
            *row = height - *row;
    }
}

// Distributes the rows to their blocks, sorted from the top, and to the planes.
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

// The row whose reflection a row shows, if it shows one.
int reflectedRow(const Frame& frame, const SliceSpans& slice, int row) {
    findMirrorPlanes(frame, slice.upright);
    for (const MirrorSpan& span : slice.upright.mirrors) {
        if (span.ripples > 0 && span.first <= row && row < span.last)
            return findRippledRows(frame, slice.column, slice.upright, span)[row];
    }
    return row;
}

}  // namespace

void traceSlice(const Frame& frame, const SliceSpans& slice, SliceTrace& trace) {
    const Vista& own = frame.vistas.ofEye();
    const Projection& projection = *own.projection;
    const GroundDirection ray = own.ray(slice.column);
    trace.column = slice.column;
    trace.rayX = ray.x / projection.distance;
    trace.rayY = ray.y / projection.distance;
    trace.horizonRow = projection.horizon;
    trace.projectionDistance = projection.distance;
    Tracer(frame, slice.column, slice.upright, true, trace).trace();
    shareOut(trace);
    if (!trace.asksReflection || slice.upright.mirrors.empty()) return;
    SliceTrace& reflection = trace.reflection.emplace_back();
    reflection.column = slice.column;
    reflection.rayX = trace.rayX;
    reflection.rayY = trace.rayY;
    reflection.horizonRow = trace.horizonRow;
    reflection.projectionDistance = trace.projectionDistance;
    if (trace.watchedRow >= 0)
        reflection.watchedRow =
            projection.height - 1 - reflectedRow(frame, slice, trace.watchedRow);
    Tracer(frame, slice.column, slice.reflected, false, reflection).trace();
    turnUpright(reflection, projection.height);
    shareOut(reflection);
}

}  // namespace slicecast

// What a slice tells of itself, for those who ask.
#include "render/slice.h"

#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace slicecast {

FilledRows& Slice::traceRun(int level, FilledRows::What what, Face face, int first, int last,
                            TextureId texture, bool layer) {
    FilledRows rows;
    rows.what = what;
    rows.face = face;
    rows.first = first;
    rows.last = last;
    rows.map = vista_->viewpoint.map;
    rows.portals = portals_;
    rows.layer = layer;
    rows.texture = texture;
    if (level != kNoLevel)
        rows.hit = static_cast<int>(trace_->hits.size()) - std::popcount(tracedLevels_ >> level);
    if (watches(first, last)) {
        SeenPoint& point = trace_->seen.emplace_back();
        point.run = static_cast<int>(trace_->filled.size());
        point.texel.depth = std::numeric_limits<double>::infinity();
    }
    trace_->filled.push_back(rows);
    return trace_->filled.back();
}

// The point that the watched row shows of the run that has just been told.
void Slice::tracePoint(const TracedTexel& texel) {
    SeenPoint& point = trace_->seen.back();
    const double along = texel.depth / projection_->distance;
    point.texel = texel;
    point.x = eyeTileX_ + eyeFractionX_ + ray_.x * along;
    point.y = eyeTileY_ + eyeFractionY_ + ray_.y * along;
    point.z = eyeHeight_ + projection_->upwardSlope(trace_->watchedRow) * texel.depth;
}

// What is no side: the rows of a plane have just been gathered.
void Slice::traceRows(int level, FilledRows::What what, Face face, int first, int last) {
    if (what == FilledRows::What::sky || what == FilledRows::What::haze) {
        traceRun(level, what, face, first, last, kNoTexture, false);
    } else {
        tracePlane(level, what, face,
                   falling_.first <= first && last <= falling_.last ? falling_ : rising_, first,
                   last, false);
    }
}

void Slice::tracePlane(int level, FilledRows::What what, Face face, const PlaneRun& run, int first,
                       int last, bool layer) {
    const Plane& plane = run.plane;
    FilledRows& traced = traceRun(level, what, face, first, last, plane.texture, layer);
    const FrameTexture& texture = frame_.textures[plane.texture];
    const double distance = Coordinate{plane.rise < 0 ? -plane.rise : plane.rise}.value();
    const PlaneLine line = {eyeFractionX_, eyeFractionY_, distance * ray_.x, distance * ray_.y,
                            plane.southReversed};
    const TileBox box = boxAround(run);
    const auto texelAt = [&](int row) {
        const double inverse = vista_->inverseOffsets[row];
        const double depth = distance * projection_->distance * inverse;
        const int detail = frame_.detail.levelAt(depth, texture.size, texture.last);
        const TextureLevel& shown = texture.levels[detail];
        const PlanePoint point = planePoint(line, box, inverse);
        const int v = static_cast<int>(std::uint64_t{point.south} >> (32 - shown.bits));
        const Shade shade = vista_->lighting.at(depth, plane.light, plane.glow);
        return TracedTexel{depth,
                           detail,
                           static_cast<int>(std::uint64_t{point.east} >> (32 - shown.bits)),
                           plane.southReversed ? shown.size - 1 - v : v,
                           shade.factor,
                           shade.fog};
    };
    traced.top = texelAt(first);
    traced.bottom = texelAt(last - 1);
    if (watches(first, last)) tracePoint(texelAt(trace_->watchedRow));
    for (int row = first; row < last; ++row) {
        ++traced.rowsOfDetail[static_cast<std::size_t>(
            frame_.detail.levelAt(distance * projection_->distance * vista_->inverseOffsets[row],
                                  texture.size, texture.last))];
    }
}

// An object's column of texels, `u` of it; positions as drawObject counts them.
void Slice::traceObject(const FrameObject& object, int u, std::uint64_t start, std::uint64_t step,
                        int first, int last) {
    const SpriteId sprite = map_->objects[static_cast<std::size_t>(object.index)].sprite;
    FilledRows& rows =
        traceRun(kNoLevel, FilledRows::What::object, Face::top, first, last, sprite, true);
    rows.object = static_cast<int>(trace_->objects.size());
    const int detail = static_cast<int>(
        object.level - frame_.world->sprites[sprite].levelsAt(frame_.world->seconds).data());
    const auto texelAt = [&](int row) {
        return TracedTexel{
            object.depth,
            detail,
            u,
            static_cast<int>((start + static_cast<std::uint64_t>(row - first) * step) >> 32),
            object.factor,
            fogOf(object.fog, row)};
    };
    rows.top = texelAt(first);
    rows.bottom = texelAt(last - 1);
    if (watches(first, last)) tracePoint(texelAt(trace_->watchedRow));
    rows.rowsOfDetail[static_cast<std::size_t>(detail)] = static_cast<std::uint16_t>(last - first);
    trace_->objects.push_back(
        {vista_->viewpoint.map, portals_, object.index, object.depth, first, last});
}

SliceTrace& Slice::traceReflection() {
    SliceTrace& reflection = trace_->reflection.emplace_back();
    reflection.column = column_;
    reflection.rayX = trace_->rayX;
    reflection.rayY = trace_->rayY;
    reflection.horizonRow = trace_->horizonRow;
    reflection.projectionDistance = trace_->projectionDistance;
    // The column stands upside down until turnUpright.
    if (trace_->watchedRow >= 0)
        reflection.watchedRow = frame_.vistas.projection().height - 1 - trace_->watchedRow;
    return reflection;
}

// Of what was drawn upside down.
void Slice::turnUpright(SliceTrace& trace, int height) {
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

// The walk itself goes on with its own numbers only; it is walked again up to here.
void Slice::traceTile(int x, int y, double along) {
    while (tracedWalk_.tileX != x || tracedWalk_.tileY != y || tracedWalk_.entered != along)
        tracedWalk_.advance();
    const Crossing border = tracedWalk_.enter();
    trace_->tiles.push_back({vista_->viewpoint.map, x, y, along * projection_->distance, portals_,
                             tracedWalk_.hasEntered(), border.alongX, along, border.distance,
                             border.speed, tracedWalk_.nextAlongX(), tracedWalk_.nextAlongY()});
}

void Slice::traceBlocks(std::uint32_t levels) {
    tracedLevels_ = levels;
    for (std::uint32_t rest = levels; rest != 0; rest &= rest - 1)
        traceBlock(blockAt(std::countr_zero(rest)));
}

void Slice::traceBlock(const Block& block) {
    Hit hit;
    hit.map = vista_->viewpoint.map;
    hit.portals = portals_;
    hit.tileX = walk_.tileX;
    hit.tileY = walk_.tileY;
    hit.level = block.level;
    hit.blueprint = map_->cell(walk_.tileX, walk_.tileY, block.level);
    hit.entered = enter_.along > 0.0;
    hit.face = enteredFace(enter_);
    hit.depth = enter_.along * projection_->distance;
    hit.backDepth = leave_.along * projection_->distance;
    hit.x = eyeTileX_ + eyeFractionX_ + ray_.x * enter_.along;
    hit.y = eyeTileY_ + eyeFractionY_ + ray_.y * enter_.along;
    hit.rawDepth = enter_.along * std::sqrt(ray_.x * ray_.x + ray_.y * ray_.y);
    hit.bottom = tileEdge(block.level) + block.blueprint->bottom;
    hit.top = tileEdge(block.level) + block.blueprint->top;
    const auto rowOf = [&](std::int32_t rise, double depth) {
        return rise == 0 ? projection_->horizon
                         : projection_->rowOf(Coordinate{rise}.value(), depth);
    };
    hit.topFrontRow = rowOf(block.top, hit.depth);
    hit.bottomFrontRow = rowOf(block.bottom, hit.depth);
    hit.topBackRow = rowOf(block.top, hit.backDepth);
    hit.bottomBackRow = rowOf(block.bottom, hit.backDepth);
    trace_->hits.push_back(std::move(hit));
}

}  // namespace slicecast

#include "classic/trace_column.h"

#include "base/sort.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace slicecast::classic {
namespace {

// Runs without a texture, sky and haze, come last.
double nearestOf(const FilledRows& rows) {
    return rows.texture == kNoTexture ? std::numeric_limits<double>::infinity()
                                      : std::min(rows.top.depth, rows.bottom.depth);
}

class TraceMaker {
public:
    TraceMaker(const Column& column, const World& world, int pictureHeight, int watchedRow)
        : column_(column),
          world_(world),
          pictureHeight_(pictureHeight),
          watchedRow_(watchedRow),
          firstHits_(column.partsUsed()) {}

    SliceTrace make() {
        begin(*column_.parts()[0], upright_.trace);
        for (std::size_t i = 0; i < column_.partsUsed(); ++i) {
            const Part& part = *column_.parts()[i];
            SliceTrace& trace = of(part).trace;
            firstHits_[i] = trace.hits.size();
            addTiles(part, trace);
            addHits(part, trace);
        }
        for (int row = 0; row < column_.rows().rows; ++row) addRow(row);
        if (!reflected_.trace.filled.empty()) {
            begin(*column_.parts()[0], reflected_.trace);
            finish(reflected_.trace);
            upright_.trace.reflection.push_back(reflected_.trace);
        }
        finish(upright_.trace);
        return upright_.trace;
    }

private:
    // The direct view, or that in mirrors; `marks` has the first mark of each run.
    struct Account {
        SliceTrace trace;
        std::vector<Mark> marks;
    };

    Account& of(const Part& part) { return part.isMirrored() ? reflected_ : upright_; }

    void begin(const Part& part, SliceTrace& trace) const {
        trace.watchedRow = watchedRow_;
        trace.rayX = part.ray.x / part.ray.depthPerAlong;
        trace.rayY = part.ray.y / part.ray.depthPerAlong;
        trace.horizonRow = part.view.horizon;
        trace.projectionDistance = part.view.distance;
    }

    void addTiles(const Part& part, SliceTrace& trace) const {
        const double unit = part.ray.depthPerAlong /
                            part.view.distance;  // from the ray's `along` to that of the trace
        const auto next = [&](double eye, int tile, double direction) {
            if (direction == 0.0) return std::numeric_limits<double>::infinity();
            return (direction > 0.0 ? tile + 1 - eye : tile - eye) / direction * unit;
        };
        for (const TileSpan& span : part.spans) {
            const bool alongX = span.entered == Face::west || span.entered == Face::east;
            const double speed = std::fabs(alongX ? part.ray.x : part.ray.y);
            trace.tiles.push_back({part.map, span.x, span.y, span.enter * part.ray.depthPerAlong,
                                   part.portals, !span.first, alongX, span.enter * unit,
                                   span.enter * speed, speed / unit,
                                   next(part.view.eyeX, span.x, part.ray.x),
                                   next(part.view.eyeY, span.y, part.ray.y)});
        }
    }

    void addHits(const Part& part, SliceTrace& trace) const {
        const Map& map = world_.maps[static_cast<std::size_t>(part.map)];
        for (const BlockMet& block : part.blocks) {
            const TileSpan& span = block.span;
            Hit hit;
            hit.map = part.map;
            hit.portals = part.portals;
            hit.tileX = span.x;
            hit.tileY = span.y;
            hit.level = block.level;
            hit.blueprint = map.cell(span.x, span.y, block.level);
            hit.entered = !span.first;
            hit.face = span.entered;
            hit.depth = span.enter * part.ray.depthPerAlong;
            hit.backDepth = span.leave * part.ray.depthPerAlong;
            hit.x = part.view.eyeX + part.ray.x * span.enter;
            hit.y = part.view.eyeY + part.ray.y * span.enter;
            hit.rawDepth = span.enter * part.ray.length;
            hit.bottom = toCoordinate(block.bottom + part.view.storey);
            hit.top = toCoordinate(block.top + part.view.storey);
            hit.bottomSlope = block.bottomPlane.climb / part.ray.depthPerAlong;
            hit.topSlope = block.topPlane.climb / part.ray.depthPerAlong;
            hit.topFrontRow = part.view.rowOf(block.topPlane.at(span.enter), hit.depth);
            hit.bottomFrontRow = part.view.rowOf(block.bottomPlane.at(span.enter), hit.depth);
            hit.topBackRow = part.view.rowOf(block.topPlane.at(span.leave), hit.backDepth);
            hit.bottomBackRow = part.view.rowOf(block.bottomPlane.at(span.leave), hit.backDepth);
            trace.hits.push_back(hit);
        }
    }

    void addRow(int row) {
        const std::vector<Mark>& marks = column_.marks(row);
        const int first = row * column_.rows().pixelSize;
        const int last = std::min(first + column_.rows().pixelSize, pictureHeight_);
        for (std::size_t i = 0; i < marks.size(); ++i) {
            const Part& part = *marks[i].part;
            const bool isLayer =
                i + 1 < marks.size() && marks[i + 1].part->isMirrored() == part.isMirrored();
            const int run = addRun(marks[i], isLayer, first, last);
            if (first <= watchedRow_ && watchedRow_ < last)
                of(part).trace.seen.push_back(seenAt(marks[i], run, row));
            if (marks[i].shown.mirror > 0) addMirror(marks[i], first, last);
            if (i == 0 || marks[i - 1].part != &part) addPortals(part, first, last);
        }
    }

    // Returns the run's index.
    int addRun(const Mark& mark, bool isLayer, int first, int last) {
        Account& account = of(*mark.part);
        std::vector<FilledRows>& runs = account.trace.filled;
        FilledRows* run = nullptr;
        for (std::size_t i = runs.size(); i-- > 0 && run == nullptr;) {
            const Mark& begun = account.marks[i];
            if (runs[i].last == first && runs[i].layer == isLayer && begun.part == mark.part &&
                begun.surface == mark.surface && begun.shown.what == mark.shown.what &&
                begun.shown.texture == mark.shown.texture)
                run = &runs[i];
        }
        if (run == nullptr) {
            run = &runs.emplace_back();
            run->begun = static_cast<int>(runs.size()) - 1;
            account.marks.push_back(mark);
            run->what = mark.shown.what;
            run->first = first;
            run->map = mark.part->map;
            run->portals = mark.part->portals;
            run->layer = isLayer;
            run->texture = mark.shown.texture;
            run->top = mark.shown.texel;
            if (mark.surface != nullptr) addThing(mark, account.trace, *run);
        }
        run->last = last;
        run->bottom = mark.shown.texel;
        if (run->texture != kNoTexture)
            run->rowsOfDetail[static_cast<std::size_t>(mark.shown.texel.detail)] +=
                static_cast<std::uint16_t>(last - first);
        if (run->object >= 0)
            account.trace.objects[static_cast<std::size_t>(run->object)].last = last;
        return static_cast<int>(run - runs.data());
    }

    // The point at which the ray of a row meets what it shows.
    SeenPoint seenAt(const Mark& mark, int run, int row) const {
        SeenPoint point;
        point.run = run;
        point.texel = mark.shown.texel;
        if (mark.shown.texture == kNoTexture) {
            point.texel.depth = std::numeric_limits<double>::infinity();
            return point;
        }
        const View& view = mark.part->view;
        const ColumnRay& ray = mark.part->ray;
        const Surface* surface = mark.surface;
        const double depth = point.texel.depth;
        const double along =
            surface != nullptr && surface->isUpright() ? surface->along : depth / ray.depthPerAlong;
        const double stretch = surface != nullptr ? surface->stretch : 1.0;
        point.x = view.eyeX + along * ray.x;
        point.y = view.eyeY + along * ray.y;
        point.z = view.storey + view.eyeZ +
                  depth * stretch * view.upwardSlopeAt(column_.rows().middle(row));
        return point;
    }

    // Sets the block or the object that the rows belong to
    void addThing(const Mark& mark, SliceTrace& trace, FilledRows& run) const {
        const Surface& surface = *mark.surface;
        run.face = surface.face;
        if (surface.block >= 0) {
            std::size_t part = 0;
            while (column_.parts()[part].get() != mark.part) ++part;
            run.hit = static_cast<int>(firstHits_[part]) + surface.block;
        }
        if (surface.object >= 0) {
            run.object = static_cast<int>(trace.objects.size());
            run.side = surface.side;
            trace.objects.push_back({mark.part->map, mark.part->portals, surface.object,
                                     mark.shown.texel.depth, run.first, run.first});
        }
    }

    void addMirror(const Mark& mark, int first, int last) {
        std::vector<MirroredRows>& mirrors = of(*mark.part).trace.mirrors;
        const Coordinate height =
            toCoordinate(mark.surface != nullptr ? mark.surface->plane.height : 0.0);
        if (!mirrors.empty() && mirrors.back().last == first &&
            mirrors.back().map == mark.part->map && mirrors.back().height == height &&
            mirrors.back().strength == mark.shown.mirror) {
            mirrors.back().last = last;
        } else {
            mirrors.push_back({mark.part->map, mark.shown.mirror, height, first, last});
        }
    }

    // Adds all portals that the ray has passed.
    void addPortals(const Part& seen, int first, int last) {
        for (const Part* part = &seen; part->before != nullptr; part = part->before) {
            if (part->door == nullptr) continue;
            std::vector<PassedPortal>& portals = of(*part->before).trace.portals;
            const PassedPortal passed = {part->door->portal, part->before->portals,
                                         part->door->nearest, first, last};
            const auto same = [&](const PassedPortal& other) {
                return other.portal == passed.portal && other.portals == passed.portals &&
                       other.depth == passed.depth && other.last >= first;
            };
            const auto known = std::find_if(portals.begin(), portals.end(), same);
            if (known == portals.end()) {
                portals.push_back(passed);
            } else {
                known->last = last;
            }
        }
    }

    // Runs are listed from the top; sorts them front to back.
    static void finish(SliceTrace& trace) {
        for (const FilledRows& run : trace.filled) {
            if (run.hit >= 0) {
                trace.hits[static_cast<std::size_t>(run.hit)].filled.push_back(run);
            } else if (run.object < 0) {
                trace.planes.push_back(run);
            }
        }
        mergeSort(trace.filled, [](const FilledRows& a, const FilledRows& b) {
            return nearestOf(a) < nearestOf(b);
        });
        for (SeenPoint& point : trace.seen) {
            int at = 0;
            while (trace.filled[static_cast<std::size_t>(at)].begun != point.run) ++at;
            point.run = at;
        }
    }

    const Column& column_;
    const World& world_;
    const int pictureHeight_;
    const int watchedRow_;
    std::vector<std::size_t> firstHits_;  // by part, the index of its first hit
    Account upright_;
    Account reflected_;
};

}  // namespace

SliceTrace traceOf(const Column& column, const World& world, int pictureHeight, int watchedRow) {
    return TraceMaker(column, world, pictureHeight, watchedRow).make();
}

}  // namespace slicecast::classic

#include "classic/level_ray.h"

#include "classic/column_ray.h"
#include "classic/tile_spans.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace slicecast {

ClassicLevelRay castClassic(const World& world, const Eye& eye, const ClassicOptions& options,
                            const ClassicAim& aim) {
    using namespace classic;
    constexpr int kAnySize = 1000;
    const Map& map = world.maps[static_cast<std::size_t>(eye.map)];
    const View view(world, eye, {.fovDegrees = aim.fovDegrees}, options, kAnySize, kAnySize);
    const ColumnRay ray = view.rayAt(aim.share * kAnySize);
    const TileStart start = {eye.x.tile(), eye.y.tile(), 0.0};
    std::vector<TileSpan> spans;
    if (options.march) {
        marchTiles(map, view, ray, start, options, spans);
    } else {
        walkTiles(map, view, ray, start, spans);
    }
    double along = (options.march ? std::min(aim.most, options.reach) : aim.most) / ray.length;
    ClassicLevelRay end;
    for (const TileSpan& span : spans) {
        if (span.first) continue;
        if (span.enter >= along) break;
        const BlueprintId id = map.cell(span.x, span.y, aim.level);
        const CellBlueprint& block = world.blueprints[id];
        const bool stands =
            id != kEmptyCell && !block.isWater &&
            (options.oneLevel || (block.bottom <= aim.height && aim.height < block.top));
        const bool isPortal = map.tilePortal(span.x, span.y) != kNoPortal;
        if (!isPortal && !stands) continue;
        // A block may fill a part of its tile only, or of its height
        std::optional<WayPart> over = WayPart{span.enter, span.leave};
        if (!isPortal && !block.plan.isWhole())
            over = wayOver(block.plan, span.x, span.y, view.eyeX, view.eyeY, ray.x, ray.y, *over);
        if (!isPortal && over && block.slopes.any() && !options.oneLevel)
            over =
                wayBetween(block.slopes, span.x, span.y, 0.0,
                           {view.eyeX, view.eyeY, aim.height.value()}, {ray.x, ray.y, 0.0}, *over);
        if (!over) continue;
        if (over->from >= along) break;
        end.met = true;
        end.portal = isPortal || block.face(span.entered).portal != kNoPortal;
        along = over->from;
        break;
    }
    end.x = along * ray.x;
    end.y = along * ray.y;
    return end;
}

}  // namespace slicecast

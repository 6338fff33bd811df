#include "overlay/map_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicecast {
namespace {

// The tile borders that a ray crosses along one axis. Lengths are in multiples of its direction.
struct Borders {
    int tile;      // where the ray is
    int step;      // 1 or -1: to the next tile
    double next;   // length from the start to the next border; infinite if the ray meets none
    double every;  // length from one border to the next

    Borders(double from, double direction)
        : tile(static_cast<int>(std::floor(from))), step(direction < 0.0 ? -1 : 1) {
        every =
            direction != 0.0 ? 1.0 / std::abs(direction) : std::numeric_limits<double>::infinity();
        const double rest = direction < 0.0 ? from - tile : tile + 1.0 - from;
        next = direction != 0.0 ? rest * every : std::numeric_limits<double>::infinity();
    }
    void cross() {
        tile += step;
        next += every;
    }
};

}  // namespace

MapRayEnd followRay(const World& world, const Map& map, const MapRay& ray, double most) {
    Borders alongX(ray.x, ray.directionX);
    Borders alongY(ray.y, ray.directionY);
    while (true) {
        Borders& crossed = alongX.next < alongY.next ? alongX : alongY;
        double length = crossed.next;
        if (!(length < most)) return {most, false, false};
        crossed.cross();
        if (map.tilePortal(alongX.tile, alongY.tile) != kNoPortal) return {length, true, true};
        const BlueprintId id = map.cell(alongX.tile, alongY.tile, ray.level);
        if (id == kEmptyCell) continue;
        const CellBlueprint& block = world.blueprints[id];
        if (block.isWater || !(block.bottom <= ray.height && ray.height < block.top)) continue;
        if (!block.isBox()) {
            auto over = wayOver(block.plan, alongX.tile, alongY.tile, ray.x, ray.y, ray.directionX,
                                ray.directionY, {length, std::min(alongX.next, alongY.next)});
            if (over && block.slopes.any())
                over = wayBetween(block.slopes, alongX.tile, alongY.tile, 0.0,
                                  {ray.x, ray.y, ray.height.value()},
                                  {ray.directionX, ray.directionY, 0.0}, *over);
            if (!over) continue;
            if (!(over->from < most)) return {most, false, false};
            length = over->from;
        }
        const Face face = &crossed == &alongX ? (alongX.step > 0 ? Face::west : Face::east)
                                              : (alongY.step > 0 ? Face::north : Face::south);
        return {length, true, block.face(face).portal != kNoPortal};
    }
}

}  // namespace slicecast

#include "render/ask/cast.h"

#include "base/angle.h"
#include "render/spans/plan_walk.h"
#include "render/view/vista.h"

#include <bit>
#include <optional>

namespace slicecast {
namespace {

class Caster {
public:
    Caster(const World& world, const CastFrom& from)
        : world_(world),
          hasHeight_(from.z.has_value()),
          from_{.map = from.map,
                .turn = 0,
                .x = from.x.raw,
                .y = from.y.raw,
                .z = from.z ? from.z->raw : 0,
                .upsideDown = false},
          direction_(directionOf(from.headingDegrees)),
          walk_(from.x, from.y, direction_) {
        ray_.direction = direction_;
    }

    CastRay run() {
        for (;; walk_.advance(), isArrival_ = false) {
            const Map& map = mapHere();
            if (!map.contains(walk_.tileX, walk_.tileY)) {
                if (!reachesGrid(map)) return ended(CastRay::End::edge);
                continue;
            }
            addTile();
            if (const std::optional<CastRay::End> end = examineTile(map)) return ended(*end);
        }
    }

private:
    static GroundDirection directionOf(double headingDegrees) {
        const SineCosine heading = sineCosineDegrees(headingDegrees);
        return {heading.cosine, heading.sine};
    }

    const Map& mapHere() const { return world_.maps[static_cast<std::size_t>(from_.map)]; }

    // From outside the grid; false if the ray never reaches it.
    bool reachesGrid(const Map& map) const {
        const bool leavesX =
            walk_.tileX < 0 ? walk_.stepX <= 0 : walk_.tileX >= map.width && walk_.stepX >= 0;
        const bool leavesY =
            walk_.tileY < 0 ? walk_.stepY <= 0 : walk_.tileY >= map.depth && walk_.stepY >= 0;
        return !leavesX && !leavesY;
    }

    void addTile() {
        ray_.tiles.push_back({from_.map, portals_, walk_.tileX, walk_.tileY, walk_.hasEntered(),
                              walk_.hasEntered() && walk_.enter().alongX, walk_.entered,
                              walk_.nextAlongX(), walk_.nextAlongY()});
    }

    // Handles the tile's portal and blocks. If a portal leads on, continues in the exit tile.
    std::optional<CastRay::End> examineTile(const Map& map) {
        if (walk_.hasEntered() && !isArrival_) {
            const PortalId portal = map.tilePortal(walk_.tileX, walk_.tileY);
            if (portal != kNoPortal) return goThrough(portal, CastRay::End::portal);
        }
        std::uint32_t levels = map.occupied[map.tileIndex(walk_.tileX, walk_.tileY)];
        for (; levels != 0; levels &= levels - 1) {
            const int level = std::countr_zero(levels);
            const BlueprintId id = map.cell(walk_.tileX, walk_.tileY, level);
            const CellBlueprint& block = world_.blueprints[id];
            const Coordinate bottom = tileEdge(level) + block.bottom;
            const Coordinate top = tileEdge(level) + block.top;
            if (hasHeight_ && (from_.z < bottom.raw || from_.z >= top.raw)) continue;
            const PlanPassage passage = PlanWalk(walk_, from_, direction_).passage(block.plan);
            if (!passage.isMet) continue;
            const Crossing enter = passage.enter.inner ? passage.enter : walk_.enter();
            WayPart way = {enter.along, passage.leave.inner ? passage.leave.along : walk_.left()};
            bool isEntered = passage.enter.inner || walk_.hasEntered();
            Face face = enteredFace(enter);
            if (hasHeight_ && block.slopes.any()) {
                const std::optional<WayPart> inside = wayInside(block, level, way);
                if (!inside) continue;
                if (inside->from > way.from) {
                    isEntered = true;
                    face = isUnderAt(block, level, way.from) ? Face::bottom : Face::top;
                }
                way = *inside;
            }
            ray_.hits.push_back({from_.map, portals_, walk_.tileX, walk_.tileY, level, id,
                                 isEntered, face, way.from, way.to, x(way.from), y(way.from),
                                 bottom, top});
            if (!hasHeight_ || !isEntered) continue;
            const PortalId portal = block.face(face).portal;
            if (portal != kNoPortal && !isArrival_) return goThrough(portal, CastRay::End::block);
            if (!block.seeThrough) return CastRay::End::block;
        }
        return std::nullopt;
    }

    // The part of the way on which the ray's height is between the slopes of a block.
    std::optional<WayPart> wayInside(const CellBlueprint& block, int level, WayPart way) const {
        return wayBetween(block.slopes, walk_.tileX, walk_.tileY, level,
                          {x(0.0), y(0.0), Coordinate{from_.z}.value()},
                          {direction_.x, direction_.y, 0.0}, way);
    }
    // Whether the ray is below the underside there.
    bool isUnderAt(const CellBlueprint& block, int level, double along) const {
        const Slant& slant = block.slopes.bottom;
        const double at = block.slopes.alongX ? x(along) - walk_.tileX : y(along) - walk_.tileY;
        return Coordinate{from_.z}.value() - level < slant.valueAt(at);
    }

    // `pastLimit` is the reason for the end if the ray has passed as many portals as allowed.
    std::optional<CastRay::End> goThrough(PortalId id, CastRay::End pastLimit) {
        if (portals_ >= world_.portalLimit) return pastLimit;
        const Portal& portal = world_.portals[id];
        ray_.portals.push_back({id, portals_, walk_.entered});
        from_ = throughPortal(from_, portal);
        direction_ = turned(direction_, portal.turn);
        walk_ = walk_.turned(portal.turn, portal.toX, portal.toY);
        ++portals_;
        isArrival_ = true;
        if (hasHeight_ && from_.z < 0) return CastRay::End::floor;
        addTile();
        return examineTile(mapHere());
    }

    CastRay ended(CastRay::End end) {
        ray_.end = end;
        ray_.distance = end == CastRay::End::block ? ray_.hits.back().distance : walk_.entered;
        ray_.map = from_.map;
        ray_.x = x(ray_.distance);
        ray_.y = y(ray_.distance);
        return std::move(ray_);
    }

    double x(double along) const {
        return static_cast<double>(from_.x) / 65536.0 + direction_.x * along;
    }
    double y(double along) const {
        return static_cast<double>(from_.y) / 65536.0 + direction_.y * along;
    }

    const World& world_;
    const bool hasHeight_;
    Viewpoint from_;  // where the ray appears to start, in the present map
    GroundDirection direction_;
    GridWalk walk_;
    int portals_ = 0;
    bool isArrival_ =
        false;  // the ray has just left a portal here: the tile's own portals do not act
    CastRay ray_;
};

}  // namespace

CastRay cast(const World& world, const CastFrom& from) {
    return Caster(world, from).run();
}

}  // namespace slicecast

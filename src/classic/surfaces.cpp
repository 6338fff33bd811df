#include "classic/surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace slicecast::classic {
namespace {

using What = FilledRows::What;

// A point may be rounded to just behind the end of its tile.
constexpr double kRounded = 1.0 + 1e-9;

// A block, the way over it, and its texture's extent.
struct Block {
    const CellBlueprint* blueprint = nullptr;
    int level = 0;
    TileSpan span;
    double bottom = 0.0;
    double top = 1.0;
    Incline bottomPlane = {};
    Incline topPlane = {};
    double textureTop = 1.0;
    double textureBottom = 0.0;

    // The ends of its sides: a slope goes on in other levels, or above and below them.
    double bottomAt(double along) const { return std::clamp(bottomPlane.at(along), bottom, top); }
    double topAt(double along) const { return std::clamp(topPlane.at(along), bottom, top); }
};

// Collects the surfaces of one column.
class Gathering {
public:
    Gathering(const Scenery& scenery, const std::vector<TileSpan>& spans,
              std::vector<BlockMet>& blocks, std::vector<Surface>& surfaces)
        : world_(scenery.world),
          map_(scenery.map),
          view_(scenery.view),
          classic_(scenery.classic),
          ray_(scenery.ray),
          rows_(scenery.rows),
          isBeyondLimit_(scenery.isBeyondLimit),
          spans_(spans),
          blocks_(blocks),
          surfaces_(surfaces) {}

    // False if nothing behind the tile can be seen.
    bool addTile(int index) {
        const TileSpan& span = spans_[static_cast<std::size_t>(index)];
        if (span.first && span.enter <= 0.0 && classic_.noOwnCell) return true;
        const PortalId portal = map_.tilePortal(span.x, span.y);
        if (portal != kNoPortal && !span.first) {
            addPortalTile(span, portal);
            return false;
        }
        addCeiling(span);
        const int first = classic_.oneLevel ? std::max(view_.storey, 0) : 0;
        const int last =
            classic_.oneLevel ? std::min(view_.storey, map_.levels - 1) : map_.levels - 1;
        for (int level = first; level <= last; ++level) {
            const CellBlueprint* blueprint = blueprintAt(span.x, span.y, level);
            if (blueprint == nullptr || (metLevels_ >> level & 1u) != 0) continue;
            const std::optional<TileSpan> over = spanOver(blueprint->plan, view_, ray_, span);
            if (!over) continue;
            const Block block = blockAt(*over, level);
            blocks_.push_back(
                {block.span, level, block.bottom, block.top, block.bottomPlane, block.topPlane});
            addBlock(span, block);
            if (classic_.firstHits && !span.first && !blueprint->seeThrough)
                metLevels_ |= 1u << level;
        }
        return true;
    }

private:
    const CellBlueprint* blueprintAt(int x, int y, int level) const {
        const BlueprintId id = map_.cell(x, y, level);
        return id == kEmptyCell ? nullptr : &world_.blueprints[id];
    }

    // `span` is the way over it.
    Block blockAt(const TileSpan& span, int level) const {
        const CellBlueprint* blueprint = blueprintAt(span.x, span.y, level);
        if (classic_.oneLevel) {
            Block box = {.blueprint = blueprint, .level = level, .span = span};
            box.topPlane.height = 1.0;
            return box;
        }
        Block block = {blueprint,
                       level,
                       span,
                       level + blueprint->bottom.value(),
                       level + blueprint->top.value(),
                       inclineOf(span, *blueprint, level, Face::bottom),
                       inclineOf(span, *blueprint, level, Face::top),
                       level + 1.0,
                       static_cast<double>(level)};
        if (classic_.stretched) {
            block.textureTop = block.top;
            block.textureBottom = block.bottom;
            // Extend over the stack of touching blocks
            for (int n = level + 1; block.textureTop == n; ++n) {
                const CellBlueprint* above = blueprintAt(span.x, span.y, n);
                if (above == nullptr || above->bottom.raw != 0) break;
                block.textureTop = n + above->top.value();
            }
            for (int n = level - 1; block.textureBottom == n + 1; --n) {
                const CellBlueprint* below = blueprintAt(span.x, span.y, n);
                if (below == nullptr || below->top != tileEdge(1)) break;
                block.textureBottom = n + below->bottom.value();
            }
        }
        return block;
    }

    // How a block's top or underside runs along the ray.
    Incline inclineOf(const TileSpan& tile, const CellBlueprint& blueprint, int level,
                      Face face) const {
        const Slopes& slopes = blueprint.slopes;
        const Slant& slant = slopes.of(face);
        if (slant.isLevel())
            return {level + (face == Face::top ? blueprint.top : blueprint.bottom).value(), 0.0};
        const double eye = slopes.alongX ? view_.eyeX - tile.x : view_.eyeY - tile.y;
        return {level + slant.valueAt(eye),
                Coordinate{slant.rise()}.value() * (slopes.alongX ? ray_.x : ray_.y)};
    }

    void addBlock(const TileSpan& tile, const Block& block) {
        const TileSpan& span = block.span;
        const double distance = distanceOf(span, (block.bottom + block.top) / 2.0);
        // True if the ray starts inside the block, or may do so behind a portal
        const bool beginsInside =
            !classic_.oneLevel && (span.enter <= 0.0 ? holdsEye(tile, block) : span.first);
        const bool hasPlanes = !classic_.oneLevel && classic_.roofs != ClassicRoofs::missing;
        // Whether rays meet the plane from below
        const bool leavesTop = view_.eyeZ < block.topPlane.height;
        const bool leavesBottom = view_.eyeZ >= block.bottomPlane.height;
        const auto addPlanes = [&](Passing passing) {
            const bool isLeft = passing == Passing::left;
            if (hasPlanes && leavesTop == isLeft)
                addPlane(tile, block, Face::top, passing, block.topPlane, distance);
            if (hasPlanes && leavesBottom == isLeft)
                addPlane(tile, block, Face::bottom, passing, block.bottomPlane, distance);
        };
        if (beginsInside || block.blueprint->seeThrough) {
            addSide(tile, block, span.left, Passing::left, span.leave, distance);
            addPlanes(Passing::left);
        }
        addPlanes(Passing::entered);
        if (!span.first) addSide(tile, block, span.entered, Passing::entered, span.enter, distance);
    }

    // Whether the eye is in the block, or in another part of the same mover.
    bool holdsEye(const TileSpan& tile, const Block& block) const {
        const auto isIn = [&](const Block& part) {
            return part.bottomAt(0.0) <= view_.eyeZ && view_.eyeZ < part.topAt(0.0);
        };
        if (isIn(block)) return true;
        const int level = static_cast<int>(std::floor(view_.eyeZ));
        const CellBlueprint* own = blueprintAt(tile.x, tile.y, level);
        if (own == nullptr || !areOneMover(*own, *block.blueprint)) return false;
        const std::optional<TileSpan> over = spanOver(own->plan, view_, ray_, tile);
        return over && over->first && isIn(blockAt(*over, level));
    }

    // Whether there are no faces between a block and the one above it, or below: of see-through
    // ones of one kind, or parts of one mover.
    bool joinsLevel(const Block& block, bool up) const {
        const CellBlueprint& own = *block.blueprint;
        const CellBlueprint* next =
            blueprintAt(block.span.x, block.span.y, block.level + (up ? 1 : -1));
        if (classic_.oneLevel || next == nullptr || !(up ? own.fillsUp() : own.fillsDown()) ||
            !spanOver(next->plan, view_, ray_, block.span))
            return false;
        return (areOneMover(own, *next) && (up ? next->goesDown() : next->goesUp())) ||
               (areJoined(world_, own, *next) && (up ? next->fillsDown() : next->fillsUp()));
    }

    // The block beyond a side that has no faces there: both are see-through and of one kind.
    std::optional<Block> joinedAt(const Block& block, Face face, double along) const {
        if (!block.blueprint->seeThrough) return std::nullopt;
        const bool alongX = face == Face::east || face == Face::west;
        const bool isAhead = along == block.span.leave;
        TileSpan beyond = block.span;
        if (alongX) beyond.x += face == Face::east ? 1 : -1;
        if (!alongX) beyond.y += face == Face::south ? 1 : -1;
        const CellBlueprint* next = blueprintAt(beyond.x, beyond.y, block.level);
        if (next == nullptr ||
            !(areJoined(world_, *block.blueprint, *next) ||
              areOneAlong(world_, *block.blueprint, *next, alongX ? Axis::x : Axis::y)))
            return std::nullopt;
        // Both must reach the border where the ray crosses it
        const double infinity = std::numeric_limits<double>::infinity();
        beyond.enter = isAhead ? along : -infinity;
        beyond.leave = isAhead ? infinity : along;
        const std::optional<TileSpan> over = spanOver(next->plan, view_, ray_, beyond);
        const bool touches = over && (isAhead ? over->enter : over->leave) == along;
        return touches && isAtBorder(block.blueprint->plan, face)
                   ? std::optional(blockAt(*over, block.level))
                   : std::nullopt;
    }

    static bool isAtBorder(const Plan& plan, Face side) {
        if (plan.half != Half::none) return hasSide(plan.half, side);
        return side == Face::west    ? plan.west.raw == 0
               : side == Face::east  ? plan.east == tileEdge(1)
               : side == Face::north ? plan.north.raw == 0
                                     : plan.south == tileEdge(1);
    }

    void addSide(const TileSpan& tile, const Block& block, Face face, Passing passing, double along,
                 double distance) {
        Surface side;
        if (!makeFace(tile, block, face, passing, distance, side)) return;
        // A face at the eye is not drawn, but the eye goes through a portal there
        if (along <= 0.0 && side.portal == kNoPortal) return;
        side.what = What::side;
        side.along = along;
        side.textureTop = block.textureTop;
        side.textureBottom = block.textureBottom;
        side.slideU = face == Face::north || face == Face::south ? block.blueprint->textureEast
                                                                 : block.blueprint->textureSouth;
        if (!classic_.stretched && !classic_.oneLevel) side.slideV = block.blueprint->textureRise;
        const double depth = along * ray_.depthPerAlong;
        const auto addBetween = [&](double top, double bottom) {
            if (top > bottom) add(side, view_.rowOf(top, depth), view_.rowOf(bottom, depth));
        };
        const double top = block.topAt(along);
        const double bottom = block.bottomAt(along);
        const std::optional<Block> joined = joinedAt(block, face, along);
        if (!joined) return addBetween(top, bottom);
        addBetween(top, std::max(bottom, joined->topAt(along)));
        addBetween(std::min(top, joined->bottomAt(along)), bottom);
    }

    void addPlane(const TileSpan& tile, const Block& block, Face face, Passing passing,
                  const Incline& incline, double distance) {
        Surface plane;
        if (joinsLevel(block, face == Face::top) ||
            !makeFace(tile, block, face, passing, distance, plane))
            return;
        plane.what = face == Face::top ? What::roof : What::underside;
        plane.slideU = block.blueprint->textureEast;
        plane.slideV = block.blueprint->textureSouth;
        // A slope only as far as this cell holds it
        double enter = block.span.enter;
        double leave = block.span.leave;
        if (incline.climb != 0.0) {
            const double a = (block.bottom - incline.height) / incline.climb;
            const double b = (block.top - incline.height) / incline.climb;
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        } else if (incline.height < block.bottom || incline.height > block.top) {
            return;
        }
        if (enter < leave) addIncline(plane, incline, enter, leave);
    }

    void addIncline(Surface& plane, const Incline& incline, double enter, double leave) {
        plane.plane = incline;
        const auto rowAt = [&](double along) {
            return view_.rowOf(incline.at(along), along * ray_.depthPerAlong);
        };
        add(plane, rowAt(enter), rowAt(leave));
    }

    void addCeiling(const TileSpan& span) {
        if (map_.ceiling.tiles.empty()) return;
        const TextureId texture = map_.ceiling.tiles[map_.tileIndex(span.x, span.y)];
        if (texture == kNoTexture) return;
        const double height = map_.ceiling.height.value() - view_.storey;
        if (height <= 0.0) return;
        Surface ceiling = surfaceAt(span, {texture, map_.ceiling.light, map_.ceiling.glow},
                                    Face::bottom, Passing::ceiling, distanceOf(span, height));
        ceiling.what = What::ceiling;
        ceiling.lit = {span.x, span.y, 0,
                       height < view_.eyeZ ? LitFace::ceilingAbove : LitFace::ceilingBelow};
        addIncline(ceiling, {height, 0.0}, span.enter, span.leave);
    }

    // Covers all heights above the floor. Beyond the limit of portals it shows haze.
    void addPortalTile(const TileSpan& span, PortalId portal) {
        Surface side =
            surfaceAt(span, {}, span.entered, Passing::portal, distanceOf(span, view_.eyeZ));
        side.along = span.enter;
        if (!isBeyondLimit_) side.portal = portal;
        const double depth = span.enter * ray_.depthPerAlong;
        add(side, view_.rowOf(std::numeric_limits<double>::infinity(), depth),
            view_.rowOf(0.0, depth));
    }

    // False if the face is not drawn: missing in water, or a portal seen from inside.
    bool makeFace(const TileSpan& tile, const Block& block, Face face, Passing passing,
                  double distance, Surface& surface) const {
        const FaceBlueprint& look = block.blueprint->face(face);
        if (look.texture == kNoTexture) return false;
        if (passing == Passing::left && look.portal != kNoPortal) return false;
        surface = surfaceAt(tile, look, face, passing, distance);
        surface.lit = {tile.x, tile.y, block.level, static_cast<LitFace>(face)};
        surface.block = static_cast<int>(blocks_.size()) - 1;
        if (passing == Passing::left) return true;
        if (!isBeyondLimit_) surface.portal = look.portal;
        surface.mirror = look.mirror;
        surface.ripples = look.ripples;
        return true;
    }

    Surface surfaceAt(const TileSpan& span, const FaceBlueprint& look, Face face, Passing passing,
                      double distance) const {
        Surface surface;
        surface.texture = look.texture;
        surface.light = look.light;
        surface.glow = look.glow;
        surface.face = face;
        surface.passing = passing;
        surface.tileX = span.x;
        surface.tileY = span.y;
        surface.nearest = span.enter * ray_.depthPerAlong;
        surface.farthest = span.leave * ray_.depthPerAlong * kRounded;
        surface.thingDistance = distance;
        return surface;
    }

    double distanceOf(const TileSpan& span, double middleHeight) const {
        const double x = span.x + 0.5 - view_.eyeX;
        const double y = span.y + 0.5 - view_.eyeY;
        const double z = middleHeight - view_.eyeZ;
        return x * x + y * y + z * z;
    }

    // Adds the rows between two edges in the picture, in either order.
    void add(const Surface& look, double a, double b) {
        const int first = rows_.firstBelow(std::min(a, b));
        const int last = rows_.firstBelow(std::max(a, b));
        if (first >= last) return;
        Surface& surface = surfaces_.emplace_back(look);
        surface.firstRow = first;
        surface.lastRow = last;
        if (classic_.seams && surface.block >= 0) {
            if (surface.isUpright()) {
                ++surface.firstRow;
                surface.lastRow = std::min(surface.lastRow, rows_.rows - 1);
            } else {
                if (surface.lastRow < rows_.rows &&
                    surface.isMet(view_, ray_, rows_.middle(surface.lastRow)))
                    ++surface.lastRow;
                surface.nearest = 0.0;
            }
        }
        // A side of one row is all seam
        if (surface.firstRow >= surface.lastRow) surfaces_.pop_back();
    }

    const World& world_;
    const Map& map_;
    const View& view_;
    const ClassicOptions& classic_;
    const ColumnRay& ray_;
    const RowGrid& rows_;
    const bool isBeyondLimit_;
    const std::vector<TileSpan>& spans_;
    std::vector<BlockMet>& blocks_;
    std::vector<Surface>& surfaces_;
    std::uint32_t metLevels_ = 0;
};

}  // namespace

int RowGrid::firstBelow(double y) const {
    const double row = std::ceil(y / pixelSize - 0.5);
    return row > 0.0 ? (row < rows ? static_cast<int>(row) : rows) : 0;
}

std::size_t gatherSurfaces(const Scenery& scenery, const std::vector<TileSpan>& spans,
                           std::vector<BlockMet>& blocks, std::vector<Surface>& surfaces) {
    surfaces.clear();
    blocks.clear();
    gatherObjects(scenery, surfaces);
    Gathering gathering(scenery, spans, blocks, surfaces);
    for (int i = 0; i < static_cast<int>(spans.size()) && gathering.addTile(i); ++i) {
    }
    if (scenery.classic.columnDepth) hideBehindFirstBlock(surfaces);
    const auto isObject = [](const Surface& surface) {
        return surface.what == FilledRows::What::object;
    };
    return static_cast<std::size_t>(std::find_if_not(surfaces.begin(), surfaces.end(), isObject) -
                                    surfaces.begin());
}

}  // namespace slicecast::classic

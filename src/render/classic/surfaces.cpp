#include "render/classic/surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicecast::classic {
namespace {

using What = FilledRows::What;

// A block and its texture's extent.
struct Block {
    const CellBlueprint* blueprint = nullptr;
    int level = 0;
    double bottom = 0.0;
    double top = 1.0;
    double textureTop = 1.0;
    double textureBottom = 0.0;
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
            const Block block = blockAt(span, level);
            blocks_.push_back({index, level, block.bottom, block.top});
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

    Block blockAt(const TileSpan& span, int level) const {
        const CellBlueprint* blueprint = blueprintAt(span.x, span.y, level);
        if (classic_.oneLevel) return {blueprint, level, 0.0, 1.0, 1.0, 0.0};
        Block block = {blueprint,
                       level,
                       level + blueprint->bottom.value(),
                       level + blueprint->top.value(),
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

    void addBlock(const TileSpan& span, const Block& block) {
        const double distance = distanceOf(span, (block.bottom + block.top) / 2.0);
        // True if the ray starts inside the block, or may do so behind a portal
        const bool beginsInside =
            !classic_.oneLevel && (span.enter <= 0.0 ? holdsEye(span, block) : span.first);
        const bool hasPlanes = !classic_.oneLevel && classic_.roofs != ClassicRoofs::missing;
        const bool leavesTop = view_.eyeZ < block.top;  // a ray that meets it rises
        const bool leavesBottom = view_.eyeZ >= block.bottom;
        if (beginsInside || block.blueprint->seeThrough) {
            addSide(span, block, span.left, Passing::left, span.leave, distance);
            if (hasPlanes && leavesTop)
                addPlane(span, block, Face::top, Passing::left, block.top, distance);
            if (hasPlanes && leavesBottom)
                addPlane(span, block, Face::bottom, Passing::left, block.bottom, distance);
        }
        if (hasPlanes && !leavesTop)
            addPlane(span, block, Face::top, Passing::entered, block.top, distance);
        if (hasPlanes && !leavesBottom)
            addPlane(span, block, Face::bottom, Passing::entered, block.bottom, distance);
        if (!span.first) addSide(span, block, span.entered, Passing::entered, span.enter, distance);
    }

    // Whether the block and the one above it, or below, are parts of one mover.
    bool goesOn(const TileSpan& span, const Block& block, bool up) const {
        const auto reachesEnd = [](const CellBlueprint& blueprint, bool top) {
            return top ? blueprint.top == tileEdge(1) : blueprint.bottom.raw == 0;
        };
        if (classic_.oneLevel || !reachesEnd(*block.blueprint, up)) return false;
        const CellBlueprint* next = blueprintAt(span.x, span.y, block.level + (up ? 1 : -1));
        return next != nullptr && areOneMover(*block.blueprint, *next) && reachesEnd(*next, !up);
    }

    // Whether the eye is in the block, or in another part of the same mover.
    bool holdsEye(const TileSpan& span, const Block& block) const {
        const auto isIn = [&](const Block& part) {
            return part.bottom <= view_.eyeZ && view_.eyeZ < part.top;
        };
        const int level = static_cast<int>(std::floor(view_.eyeZ));
        const CellBlueprint* own = blueprintAt(span.x, span.y, level);
        return isIn(block) || (own != nullptr && areOneMover(*own, *block.blueprint) &&
                               isIn(blockAt(span, level)));
    }

    // Whether two see-through blocks touch here, with no faces between them.
    bool isJoined(const TileSpan& span, const Block& block, Face face) const {
        const CellBlueprint& blueprint = *block.blueprint;
        const Axis axis = face == Face::top || face == Face::bottom  ? Axis::z
                          : face == Face::east || face == Face::west ? Axis::x
                                                                     : Axis::y;
        const auto joins = [&](const CellBlueprint* neighbour) {
            return neighbour != nullptr &&
                   (areJoined(world_, blueprint, *neighbour) ||
                    areOneAlong(world_, blueprint, *neighbour, axis)) &&
                   neighbour->bottom == blueprint.bottom && neighbour->top == blueprint.top;
        };
        if (axis == Axis::z) {
            const bool spansLevel = blueprint.bottom.raw == 0 && blueprint.top == tileEdge(1);
            return goesOn(span, block, face == Face::top) ||
                   (spansLevel &&
                    joins(blueprintAt(span.x, span.y, block.level + (face == Face::top ? 1 : -1))));
        }
        if (!blueprint.seeThrough) return false;
        const int x = span.x + (face == Face::east ? 1 : face == Face::west ? -1 : 0);
        const int y = span.y + (face == Face::south ? 1 : face == Face::north ? -1 : 0);
        return joins(blueprintAt(x, y, block.level));
    }

    void addSide(const TileSpan& span, const Block& block, Face face, Passing passing, double along,
                 double distance) {
        Surface side;
        if (!makeFace(span, block, face, passing, distance, side)) return;
        // A face at the eye is not drawn, but the eye goes through a portal there
        if (along <= 0.0 && side.portal == kNoPortal) return;
        side.what = What::side;
        side.along = along;
        side.textureTop = block.textureTop;
        side.textureBottom = block.textureBottom;
        if (!classic_.stretched && !classic_.oneLevel)
            side.textureRise = block.blueprint->textureRise.value();
        const double depth = along * ray_.depthPerAlong;
        add(side, view_.rowOf(block.top, depth), view_.rowOf(block.bottom, depth));
    }

    void addPlane(const TileSpan& span, const Block& block, Face face, Passing passing,
                  double height, double distance) {
        Surface plane;
        if (!makeFace(span, block, face, passing, distance, plane)) return;
        plane.what = face == Face::top ? What::roof : What::underside;
        addLevel(span, plane, height);
    }

    void addLevel(const TileSpan& span, Surface plane, double height) {
        plane.height = height;
        add(plane, view_.rowOf(height, span.enter * ray_.depthPerAlong),
            view_.rowOf(height, span.leave * ray_.depthPerAlong));
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
        addLevel(span, ceiling, height);
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

    // False if the face is not drawn: missing in water, between joined blocks, or a portal seen
    // from inside.
    bool makeFace(const TileSpan& span, const Block& block, Face face, Passing passing,
                  double distance, Surface& surface) const {
        const FaceBlueprint& look = block.blueprint->face(face);
        if (look.texture == kNoTexture || isJoined(span, block, face)) return false;
        if (passing == Passing::left && look.portal != kNoPortal) return false;
        surface = surfaceAt(span, look, face, passing, distance);
        surface.block = static_cast<int>(blocks_.size()) - 1;
        if (passing == Passing::left) return true;
        if (!isBeyondLimit_) surface.portal = look.portal;
        surface.mirror = look.mirror;
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
        surface.thingDistance = distance;
        return surface;
    }

    double distanceOf(const TileSpan& span, double middleHeight) const {
        const double x = span.x + 0.5 - view_.eyeX;
        const double y = span.y + 0.5 - view_.eyeY;
        const double z = middleHeight - view_.eyeZ;
        return x * x + y * y + z * z;
    }

    // Whether the ray of a row meets a horizontal plane ahead: not at the horizon, nor beyond it.
    bool meetsPlane(double height, int row) const {
        return (height - view_.eyeZ) * view_.upwardSlopeAt(rows_.middle(row)) > 0.0;
    }

    // Adds the rows between two edges in the picture, in either order.
    void add(Surface& surface, double a, double b) {
        surface.firstRow = rows_.firstBelow(std::min(a, b));
        surface.lastRow = rows_.firstBelow(std::max(a, b));
        if (surface.firstRow >= surface.lastRow) return;
        if (classic_.seams && surface.block >= 0) {
            if (surface.isUpright()) {
                ++surface.firstRow;
                surface.lastRow = std::min(surface.lastRow, rows_.rows - 1);
            } else {
                if (surface.lastRow < rows_.rows && meetsPlane(surface.height, surface.lastRow))
                    ++surface.lastRow;
                surface.nearest = 0.0;
            }
        }
        // A side of one row is all seam
        if (surface.firstRow < surface.lastRow) surfaces_.push_back(surface);
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

void gatherSurfaces(const Scenery& scenery, const std::vector<TileSpan>& spans,
                    std::vector<BlockMet>& blocks, std::vector<Surface>& surfaces) {
    surfaces.clear();
    blocks.clear();
    gatherObjects(scenery, surfaces);
    Gathering gathering(scenery, spans, blocks, surfaces);
    for (int i = 0; i < static_cast<int>(spans.size()) && gathering.addTile(i); ++i) {
    }
    if (scenery.classic.columnDepth) hideBehindFirstBlock(surfaces);
}

}  // namespace slicecast::classic

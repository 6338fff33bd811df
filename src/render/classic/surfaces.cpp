#include "render/classic/surfaces.h"

#include <cmath>

namespace slicecast::classic {
namespace {

// A block as a method takes it, heights above the map's floor.
struct Block {
    const CellBlueprint* blueprint = nullptr;
    int level = 0;
    double bottom = 0.0;
    double top = 1.0;
    double textureTop = 1.0;
    double textureBottom = 0.0;
};

// One column's collecting.
class Gathering {
public:
    Gathering(const World& world, const Map& map, const View& view, const ClassicOptions& classic,
              const ColumnRay& ray, const RowGrid& rows, std::vector<Surface>& surfaces)
        : world_(world),
          map_(map),
          view_(view),
          classic_(classic),
          ray_(ray),
          rows_(rows),
          surfaces_(surfaces) {}

    void addTile(const TileSpan& span) {
        addCeiling(span);
        const int first = classic_.oneLevel ? view_.storey : 0;
        const int last = classic_.oneLevel ? view_.storey : map_.levels - 1;
        for (int level = first; level <= last; ++level) {
            if (blueprintAt(span.x, span.y, level) != nullptr) addBlock(span, blockAt(span, level));
        }
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
            // The stack that it belongs to: blocks that touch.
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
        const bool eyeInside =
            span.enter <= 0.0 && block.bottom <= view_.eyeZ && view_.eyeZ < block.top;
        const bool hasPlanes = !classic_.oneLevel;
        const bool leavesTop = view_.eyeZ < block.top;  // a ray that meets it rises
        const bool leavesBottom = view_.eyeZ >= block.bottom;
        if ((eyeInside && hasPlanes) || block.blueprint->seeThrough) {
            if (span.leave > 0.0)
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
        if (span.enter > 0.0)
            addSide(span, block, span.entered, Passing::entered, span.enter, distance);
    }

    // Two see-through blocks that touch here have no faces between them.
    bool isJoined(const TileSpan& span, const Block& block, Face face) const {
        const CellBlueprint& blueprint = *block.blueprint;
        if (!blueprint.seeThrough || !blueprint.join) return false;
        if (face == Face::top || face == Face::bottom) {
            const bool spansLevel = blueprint.bottom.raw == 0 && blueprint.top == tileEdge(1);
            return spansLevel &&
                   blueprintAt(span.x, span.y, block.level + (face == Face::top ? 1 : -1)) ==
                       &blueprint;
        }
        const int x = span.x + (face == Face::east ? 1 : face == Face::west ? -1 : 0);
        const int y = span.y + (face == Face::south ? 1 : face == Face::north ? -1 : 0);
        return blueprintAt(x, y, block.level) == &blueprint;
    }

    void addSide(const TileSpan& span, const Block& block, Face face, Passing passing, double along,
                 double distance) {
        if (isJoined(span, block, face)) return;
        Surface side = surfaceOf(span, block.blueprint->face(face), face, passing, distance);
        const double depth = along * ray_.depthPerAlong;
        side.firstRow = rows_.firstBelow(view_.rowOf(block.top, depth));
        side.lastRow = rows_.firstBelow(view_.rowOf(block.bottom, depth));
        side.along = along;
        side.textureTop = block.textureTop;
        side.textureBottom = block.textureBottom;
        add(side);
    }

    void addPlane(const TileSpan& span, const Block& block, Face face, Passing passing,
                  double height, double distance) {
        if (isJoined(span, block, face)) return;
        addLevel(span, surfaceOf(span, block.blueprint->face(face), face, passing, distance),
                 height);
    }

    void addLevel(const TileSpan& span, Surface plane, double height) {
        const int near = rows_.firstBelow(view_.rowOf(height, span.enter * ray_.depthPerAlong));
        const int farther = rows_.firstBelow(view_.rowOf(height, span.leave * ray_.depthPerAlong));
        plane.firstRow = height > view_.eyeZ ? near : farther;
        plane.lastRow = height > view_.eyeZ ? farther : near;
        plane.height = height;
        add(plane);
    }

    void addCeiling(const TileSpan& span) {
        if (map_.ceiling.tiles.empty()) return;
        const TextureId texture = map_.ceiling.tiles[map_.tileIndex(span.x, span.y)];
        if (texture == kNoTexture) return;
        const double height = map_.ceiling.height.value() - view_.storey;
        if (height <= 0.0) return;
        addLevel(span,
                 surfaceOf(span, {texture, map_.ceiling.light, map_.ceiling.glow}, Face::bottom,
                           Passing::ceiling, distanceOf(span, height)),
                 height);
    }

    Surface surfaceOf(const TileSpan& span, const FaceBlueprint& look, Face face, Passing passing,
                      double distance) const {
        Surface surface;
        surface.texture = look.texture;
        surface.light = look.light;
        surface.glow = look.glow;
        surface.face = face;
        surface.passing = passing;
        surface.tileX = span.x;
        surface.tileY = span.y;
        surface.thingDistance = distance;
        return surface;
    }

    double distanceOf(const TileSpan& span, double middleHeight) const {
        const double x = span.x + 0.5 - view_.eyeX;
        const double y = span.y + 0.5 - view_.eyeY;
        const double z = middleHeight - view_.eyeZ;
        return x * x + y * y + z * z;
    }

    void add(const Surface& surface) {
        if (surface.firstRow < surface.lastRow && surface.texture != kNoTexture)
            surfaces_.push_back(surface);
    }

    const World& world_;
    const Map& map_;
    const View& view_;
    const ClassicOptions& classic_;
    const ColumnRay& ray_;
    const RowGrid& rows_;
    std::vector<Surface>& surfaces_;
};

}  // namespace

int RowGrid::firstBelow(double y) const {
    const double row = std::ceil(y / pixelSize - 0.5);
    return row > 0.0 ? (row < rows ? static_cast<int>(row) : rows) : 0;
}

void gatherSurfaces(const World& world, const Map& map, const View& view,
                    const ClassicOptions& classic, const ColumnRay& ray, const RowGrid& rows,
                    const std::vector<TileSpan>& spans, std::vector<Surface>& surfaces) {
    surfaces.clear();
    Gathering gathering(world, map, view, classic, ray, rows, surfaces);
    for (const TileSpan& span : spans) gathering.addTile(span);
}

}  // namespace slicecast::classic

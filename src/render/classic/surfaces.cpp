#include "render/classic/surfaces.h"

#include <cmath>

namespace slicecast::classic {
namespace {

// A block as a method takes it, heights above the map's floor.
struct Block {
    const CellBlueprint* blueprint = nullptr;
    double bottom = 0.0;
    double top = 1.0;
    double textureTop = 1.0;
    double textureBottom = 0.0;
};

// One column's collecting.
class Gathering {
public:
    Gathering(const World& world, const Map& map, const View& view, const ClassicOptions& classic, const ColumnRay& ray, const RowGrid& rows,
              std::vector<Surface>& surfaces)
        : world_(world), map_(map), view_(view), classic_(classic), ray_(ray), rows_(rows), surfaces_(surfaces) {}

    void addTile(const TileSpan& span) {
        addCeiling(span);
        const int first = classic_.oneLevel ? view_.storey : 0;
        const int last = classic_.oneLevel ? view_.storey : map_.levels - 1;
        for (int level = first; level <= last; ++level) {
            if (blueprintAt(span, level) != nullptr) addBlock(span, blockAt(span, level));
        }
    }

private:
    const CellBlueprint* blueprintAt(const TileSpan& span, int level) const {
        const BlueprintId id = map_.cell(span.x, span.y, level);
        return id == kEmptyCell ? nullptr : &world_.blueprints[id];
    }

    Block blockAt(const TileSpan& span, int level) const {
        const CellBlueprint* blueprint = blueprintAt(span, level);
        if (classic_.oneLevel) return {blueprint, 0.0, 1.0, 1.0, 0.0};
        Block block = {blueprint, level + blueprint->bottom.value(), level + blueprint->top.value(), level + 1.0, static_cast<double>(level)};
        if (classic_.stretched) {
            block.textureTop = block.top;
            block.textureBottom = block.bottom;
            // The stack that it belongs to: blocks that touch.
            for (int n = level + 1; block.textureTop == n; ++n) {
                const CellBlueprint* above = blueprintAt(span, n);
                if (above == nullptr || above->bottom.raw != 0) break;
                block.textureTop = n + above->top.value();
            }
            for (int n = level - 1; block.textureBottom == n + 1; --n) {
                const CellBlueprint* below = blueprintAt(span, n);
                if (below == nullptr || below->top != tileEdge(1)) break;
                block.textureBottom = n + below->bottom.value();
            }
        }
        return block;
    }

    void addBlock(const TileSpan& span, const Block& block) {
        const double distance = distanceOf(span, (block.bottom + block.top) / 2.0);
        const bool inside = span.enter <= 0.0 && block.bottom <= view_.eyeZ && view_.eyeZ < block.top;
        if (!classic_.oneLevel) {
            if (view_.eyeZ >= block.top || inside) addPlane(span, block.blueprint->face(Face::top), Face::top, block.top, distance);
            if (view_.eyeZ < block.bottom || inside) addPlane(span, block.blueprint->face(Face::bottom), Face::bottom, block.bottom, distance);
        }
        if (span.enter > 0.0) addSide(span, block, span.entered, span.enter, distance);
        if (inside && span.leave > 0.0 && !classic_.oneLevel) addSide(span, block, span.left, span.leave, distance);
    }

    void addSide(const TileSpan& span, const Block& block, Face face, double along, double distance) {
        Surface side = surfaceOf(span, block.blueprint->face(face), face, distance);
        const double depth = along * ray_.depthPerAlong;
        side.firstRow = rows_.firstBelow(view_.rowOf(block.top, depth));
        side.lastRow = rows_.firstBelow(view_.rowOf(block.bottom, depth));
        side.along = along;
        side.textureTop = block.textureTop;
        side.textureBottom = block.textureBottom;
        add(side);
    }

    void addPlane(const TileSpan& span, const FaceBlueprint& look, Face face, double height, double distance) {
        Surface plane = surfaceOf(span, look, face, distance);
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
        addPlane(span, {texture, map_.ceiling.light}, Face::bottom, height, distanceOf(span, height));
    }

    Surface surfaceOf(const TileSpan& span, const FaceBlueprint& look, Face face, double distance) const {
        Surface surface;
        surface.texture = look.texture;
        surface.light = look.light;
        surface.face = face;
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
        if (surface.firstRow < surface.lastRow) surfaces_.push_back(surface);
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

void gatherSurfaces(const World& world, const Map& map, const View& view, const ClassicOptions& classic, const ColumnRay& ray, const RowGrid& rows,
                    const std::vector<TileSpan>& spans, std::vector<Surface>& surfaces) {
    surfaces.clear();
    Gathering gathering(world, map, view, classic, ray, rows, surfaces);
    for (const TileSpan& span : spans) gathering.addTile(span);
}

}  // namespace slicecast::classic

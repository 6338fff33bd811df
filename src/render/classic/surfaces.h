// What a column could see of the blocks and ceilings on the tiles that it passes, whether or not
// something nearer hides it. Faces that a ray leaves a block through are seen only where the eye is
// inside it, or the block is see-through.
#pragma once

#include "render/classic/classic_options.h"
#include "render/classic/column_ray.h"
#include "render/classic/tile_spans.h"
#include "world/world.h"

#include <cstdint>
#include <vector>

namespace slicecast::classic {

// The picture's rows: of `pixelSize` pixels each, row r's middle being r * pixelSize + pixelSize
// / 2.
struct RowGrid {
    int pixelSize = 1;
    int rows = 0;

    double middle(int row) const { return (row + 0.5) * pixelSize; }
    // The first row whose middle is not above y, in [0, rows].
    int firstBelow(double y) const;
};

// What a ray does there. At equal depth the earlier ones come first.
enum class Passing : std::uint8_t { left, entered, ceiling };

// A side, upright at one depth, or a level plane: a roof, an underside, a ceiling.
struct Surface {
    TextureId texture = kNoTexture;
    double light = 1.0;
    bool glow = false;
    Face face = Face::top;  // top and bottom are level planes, a ceiling a bottom
    Passing passing = Passing::entered;
    int tileX = 0;
    int tileY = 0;
    int firstRow = 0;  // where it appears: [firstRow, lastRow)
    int lastRow = 0;
    double along = 0.0;       // sides: where on the ray
    double height = 0.0;      // level planes: units
    double textureTop = 0.0;  // sides: heights at which the texture begins and ends
    double textureBottom = 0.0;
    double thingDistance = 0.0;  // of the middle of the block or ceiling tile from the eye,
                                 // squared: what painter's order goes by

    bool isSide() const { return face != Face::top && face != Face::bottom; }
    double depthAt(const View& view, const ColumnRay& ray, double y) const {
        return isSide() ? along * ray.depthPerAlong : view.depthOfPlane(height, y);
    }
};

// Replaces `surfaces` by what there is on these tiles: near tiles first, and of one block the faces
// that are left before those that are entered.
void gatherSurfaces(const World& world, const Map& map, const View& view,
                    const ClassicOptions& classic, const ColumnRay& ray, const RowGrid& rows,
                    const std::vector<TileSpan>& spans, std::vector<Surface>& surfaces);

}  // namespace slicecast::classic

// What a column could see on the tiles that it passes, whether or not something nearer hides it:
// the faces of blocks, ceilings, portals and objects. Faces that a ray leaves a block through are
// seen only where the eye is inside it, or the block is see-through.
#pragma once

#include "render/classic/classic_options.h"
#include "render/classic/column_ray.h"
#include "render/classic/tile_spans.h"
#include "render/trace.h"
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
enum class Passing : std::uint8_t { left, portal, entered, ceiling, object };

// Something upright at one depth, or a level plane: a roof, an underside, a ceiling.
struct Surface {
    FilledRows::What what = FilledRows::What::side;
    TextureId texture = kNoTexture;  // or the sprite's number; none shows the haze
    double light = 1.0;
    bool glow = false;
    std::uint8_t mirror = 0;
    Face face =
        Face::top;  // top and bottom are level planes, a ceiling a bottom; of an object none
    Passing passing = Passing::entered;
    PortalId portal = kNoPortal;  // rays go on behind it
    int tileX = 0;
    int tileY = 0;
    int block = -1;    // index into the blocks met
    int object = -1;   // index into Map::objects
    int firstRow = 0;  // where it appears: [firstRow, lastRow)
    int lastRow = 0;
    double along = 0.0;       // of what is upright: where on the ray
    double nearest = 0.0;     // nothing of it is at a smaller depth
    double height = 0.0;      // of level planes: units
    double textureTop = 0.0;  // of what is upright: heights at which the texture begins and ends
    double textureBottom = 0.0;
    double textureRise = 0.0;    // see CellBlueprint
    double stretch = 1.0;        // of objects: units of height to what the row's slope gives
    double u = 0.0;              // of objects: from the left of the picture, 0 to 1
    double thingDistance = 0.0;  // of the middle of the block, ceiling tile or object from the eye,
                                 // squared: what painter's order goes by

    bool isUpright() const {
        return what == FilledRows::What::side || what == FilledRows::What::object;
    }
    double depthAt(const View& view, const ColumnRay& ray, double y) const {
        return isUpright() ? along * ray.depthPerAlong : view.depthOfPlane(height, y);
    }
};

// A block on the way, as a method takes it.
struct BlockMet {
    int span = 0;  // index into the tiles
    int level = 0;
    double bottom = 0.0;  // heights above the map's floor, or above the one level
    double top = 1.0;
};

// One column's view of a map.
struct Scenery {
    const World& world;
    const Map& map;
    const View& view;
    const ColumnRay& ray;
    const RowGrid& rows;
    const ClassicOptions& classic;
    bool isBeyondLimit = false;  // no further portals
    double begins = 0.0;         // nothing is seen at a smaller depth
};

// Fills both lists anew. Surfaces: objects first, then near tiles before far ones, and of one block
// the faces that are left before those that are entered. Nothing is told of what is behind a tile
// that is a portal.
void gatherSurfaces(const Scenery& scenery, const std::vector<TileSpan>& spans,
                    std::vector<BlockMet>& blocks, std::vector<Surface>& surfaces);

// Puts the objects that the column meets first into an empty list. In objects.cpp, as is:
void gatherObjects(const Scenery& scenery, std::vector<Surface>& surfaces);
// Takes out those behind the first block.
void hideBehindFirstBlock(std::vector<Surface>& surfaces);

}  // namespace slicecast::classic

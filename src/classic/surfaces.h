// Collects the surfaces that a column could see on its tiles, even if something nearer hides them:
// faces of blocks, ceilings, portals and objects. A face by which a ray leaves a block is visible
// only if the eye is inside it, or the block is see-through.
#pragma once

#include "classic/classic_options.h"
#include "classic/column_ray.h"
#include "classic/tile_spans.h"
#include "render/light/light_scene.h"
#include "render/trace.h"
#include "world/world.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace slicecast::classic {

// The picture's rows of `pixelSize` pixels each; row r's middle is r * pixelSize + pixelSize / 2.
struct RowGrid {
    int pixelSize = 1;
    int rows = 0;

    double middle(int row) const { return (row + 0.5) * pixelSize; }
    // The first row whose middle is not above y, in [0, rows].
    int firstBelow(double y) const;
};

// What a ray does at a surface. At equal depth the earlier ones come first.
enum class Passing : std::uint8_t { left, portal, entered, ceiling, object };

// A height that may change along the ray.
struct Incline {
    double height = 0.0;  // over or under the eye, units
    double climb = 0.0;   // per multiple of the ray's direction

    double at(double along) const { return climb == 0.0 ? height : height + climb * along; }
};

// An upright thing at one depth, or a plane: a roof, an underside, a ceiling.
struct Surface {
    FilledRows::What what = FilledRows::What::side;
    TextureId texture = kNoTexture;  // or the sprite's number; none shows haze
    double light = 1.0;
    bool glow = false;
    std::uint8_t mirror = 0;
    std::uint8_t ripples = 0;
    Face face = Face::top;  // top and bottom are planes; a ceiling is a bottom
    Passing passing = Passing::entered;
    PortalId portal = kNoPortal;  // the portal behind which rays continue
    int tileX = 0;
    int tileY = 0;
    LitFaceAt lit;     // where its baked light falls, but on objects
    int block = -1;    // index into the blocks met
    int object = -1;   // index into Map::objects
    int firstRow = 0;  // it covers [firstRow, lastRow), at least one row
    int lastRow = 0;
    double along = 0.0;       // of upright things: position on the ray
    double nearest = 0.0;     // no point of it is nearer
    double farthest = 0.0;    // nor farther, but for seams
    Incline plane;            // of planes
    double textureTop = 0.0;  // of upright things: heights of the texture's ends
    double textureBottom = 0.0;
    Coordinate slideU;     // how far its texture has moved along the face: east or south,
    Coordinate slideV;     // and south, or on sides up
    double stretch = 1.0;  // of objects: factor from the row's slope to units of height
    double u = 0.0;        // of objects: from the left of the sprite, 0 to 1
    ObjectSide side = ObjectSide::front;  // of objects: turned to the eye
    double thingDistance = 0.0;  // squared, from the eye to the middle of the block, ceiling tile
                                 // or object; sorts painter's order

    bool isUpright() const {
        return what == FilledRows::What::side || what == FilledRows::What::object;
    }
    double depthAt(const View& view, const ColumnRay& ray, double y) const {
        return isUpright() ? along * ray.depthPerAlong
                           : view.depthOfPlane(plane.height, y, plane.climb / ray.depthPerAlong);
    }
    // Whether a row's ray meets it ahead: a plane not at the horizon, nor beyond it, nor where the
    // ray runs along a slope.
    bool isMet(const View& view, const ColumnRay& ray, double y) const {
        const double depth = depthAt(view, ray, y);
        return depth >= 0.0 && depth < std::numeric_limits<double>::infinity();
    }
};

// A block on the way, with the method's heights, which are above the map's floor, or above the one
// level.
struct BlockMet {
    TileSpan span;  // of the way over it
    int level = 0;
    double bottom = 0.0;  // its lowest point and its highest
    double top = 1.0;
    Incline bottomPlane = {};
    Incline topPlane = {};
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
    double begins = 0.0;         // nothing is visible at a smaller depth
};

// Refills both lists. Surfaces are in this order: objects, near ones first; then near tiles before
// far ones, and for each block the faces by which it is left before those by which it is entered.
// Skips everything behind a portal tile. Returns the number of objects.
std::size_t gatherSurfaces(const Scenery& scenery, const std::vector<TileSpan>& spans,
                           std::vector<BlockMet>& blocks, std::vector<Surface>& surfaces);

// Adds the objects that the column meets to an empty list, near ones first. In objects.cpp, like
// the next:
void gatherObjects(const Scenery& scenery, std::vector<Surface>& surfaces);
// Removes objects behind the first block.
void hideBehindFirstBlock(std::vector<Surface>& surfaces);

}  // namespace slicecast::classic

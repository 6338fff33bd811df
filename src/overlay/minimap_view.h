// Maps coordinates to the minimap. The middle of its square is the eye's pixel.
#pragma once

#include "base/angle.h"
#include "overlay/lines.h"

namespace slicecast {

struct MinimapView {
    PixelRect area;  // inside the rim
    int pixelsPerTile;
    int eyeX;  // the eye's pixel on the map, from its corner
    int eyeY;
    int centreX;  // the same pixel in the picture
    int centreY;
    SineCosine up;  // the heading that points up in the picture
    int line = 1;   // width of fine lines, pixels

    // Turns a vector: pixels right and down to pixels east and south, and back.
    Point toMap(Point p) const {
        return {-p.x * up.sine - p.y * up.cosine, p.x * up.cosine - p.y * up.sine};
    }
    Point toPicture(Point p) const {
        return {-p.x * up.sine + p.y * up.cosine, -p.x * up.cosine - p.y * up.sine};
    }
    // The middle of the eye's pixel.
    Point centre() const { return {centreX + 0.5, centreY + 0.5}; }
    // The pixel position of a point on the map, in units.
    Point place(double x, double y) const {
        const Point fromCentre =
            toPicture({x * pixelsPerTile - eyeX - 0.5, y * pixelsPerTile - eyeY - 0.5});
        return {centre().x + fromCentre.x, centre().y + fromCentre.y};
    }
};

}  // namespace slicecast

// The way from the map to the minimap. The middle of its square is the pixel in which the eye is.
#pragma once

#include "base/angle.h"
#include "overlay/lines.h"

namespace slicecast {

struct MinimapView {
    PixelRect area;  // inside the rim
    int pixelsPerTile;
    int eyeX;  // the eye's pixel, counted from the map's corner
    int eyeY;
    int centreX;  // the same pixel of the picture
    int centreY;
    SineCosine up;  // the heading that is up in the picture
    int line = 1;   // width of fine lines, pixels

    // From so many pixels to the right and down to as many east and south, and back.
    Point toMap(Point p) const {
        return {-p.x * up.sine - p.y * up.cosine, p.x * up.cosine - p.y * up.sine};
    }
    Point toPicture(Point p) const {
        return {-p.x * up.sine + p.y * up.cosine, -p.x * up.cosine - p.y * up.sine};
    }
    // The middle of the pixel that is the eye's.
    Point centre() const { return {centreX + 0.5, centreY + 0.5}; }
    // A place on the map, in units, in pixels of the picture.
    Point place(double x, double y) const {
        const Point fromCentre =
            toPicture({x * pixelsPerTile - eyeX - 0.5, y * pixelsPerTile - eyeY - 0.5});
        return {centre().x + fromCentre.x, centre().y + fromCentre.y};
    }
};

}  // namespace slicecast

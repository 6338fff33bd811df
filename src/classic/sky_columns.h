// Skies with layers, as a column of the picture sees them: the exact renderer's, in rows of any
// size and from any horizon.
#pragma once

#include "classic/column_ray.h"
#include "classic/surfaces.h"
#include "render/view/projection.h"
#include "render/view/sky_layers.h"
#include "world/world.h"

#include <memory>
#include <vector>

namespace slicecast::classic {

class SkyColumns {
public:
    // The world must outlive it.
    SkyColumns(const World& world, const View& view, const RowGrid& rows);

    // The colour in a row that does not look down; in a mirror, one that does not look up.
    Pixel at(int map, bool isMirrored, double azimuthDegrees, int row);

private:
    // The sky of a map, upright or in a mirror.
    struct Seen {
        SkyLayers layers;
        std::vector<Pixel> colours;  // by row
        int column = -1;             // that they are of
    };

    const World& world_;
    const Projection upright_;
    const Projection mirrored_;
    std::vector<std::unique_ptr<Seen>> seen_;  // two of each map, made when first needed
};

}  // namespace slicecast::classic

// The baked light of a horizontal or sloped plane at one of its tiles.
#pragma once

#include "render/lit_maps.h"
#include "render/plane_looks.h"
#include "render/slice_spans.h"
#include "render/vista.h"

namespace slicecast {

// The nodes of the tile, whose place is relative to the eye's; `run` is a Span of a plane, or has
// its members. Rounding may ask for a tile beside the run's, which has no such face.
template <typename Run>
const FaceNodes& planeNodes(const Run& run, int tileX, int tileY) {
    LitMap& lit = *run.vista->lit;
    LitFaceAt at = {tileX + run.vista->viewpoint.tileX(), tileY + run.vista->viewpoint.tileY(), 0,
                    LitFace::floor};
    if (run.level != kNoLevel) {
        at.level = run.level;
        at.face = static_cast<LitFace>(run.face);
    } else if (run.look->plane.southReversed) {
        at.face = run.look->plane.rise < 0 ? LitFace::ceilingAbove : LitFace::ceilingBelow;
    } else if (!run.vista->map->contains(at.x, at.y)) {
        return lit.outside();
    }
    if (const FaceNodes* const nodes = lit.nodesOf(at)) return *nodes;
    at.x = run.tiles.fromX;
    at.y = run.tiles.fromY;
    const FaceNodes* const nodes = lit.nodesOf(at);
    return nodes != nullptr ? *nodes : lit.outside();
}

}  // namespace slicecast

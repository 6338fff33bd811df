// The faces on which a horizontal or sloped plane's baked light falls.
#pragma once

#include "render/light/lit_maps.h"
#include "render/spans/slice_spans.h"
#include "render/view/plane_looks.h"
#include "render/view/vista.h"

namespace slicecast {

// The face at one of the plane's tiles, whose place is relative to the eye's; `run` is a Span of a
// plane, or has its members. Rounding may ask for a tile beside the run's, which has no such face:
// then that of ownFace counts.
template <typename Run>
LitFaceAt planeFace(const Run& run, int tileX, int tileY) {
    LitFaceAt at = {tileX + run.vista->viewpoint.tileX(), tileY + run.vista->viewpoint.tileY(), 0,
                    LitFace::floor};
    if (run.level != kNoLevel) {
        at.level = run.level;
        at.face = static_cast<LitFace>(run.face);
    } else if (run.look->plane.southReversed) {
        at.face = run.look->plane.rise < 0 ? LitFace::ceilingAbove : LitFace::ceilingBelow;
    } else if (!run.vista->map->contains(at.x, at.y)) {
        return kOutside;
    }
    return at;
}

// The face at the tile of the run that is nearest to the eye.
template <typename Run>
LitFaceAt ownFace(const Run& run) {
    const Viewpoint& eye = run.vista->viewpoint;
    return planeFace(run, run.tiles.fromX - eye.tileX(), run.tiles.fromY - eye.tileY());
}

// The nodes at one of the plane's tiles, as above. Valid until the next call.
template <typename Run>
const FaceNodes& planeNodes(const Run& run, int tileX, int tileY) {
    LitMap& lit = *run.vista->lit;
    const FaceNodes* nodes = lit.nodesOf(planeFace(run, tileX, tileY));
    if (nodes == nullptr) nodes = lit.nodesOf(ownFace(run));
    return nodes != nullptr ? *nodes : *lit.nodesOf(kOutside);
}

}  // namespace slicecast

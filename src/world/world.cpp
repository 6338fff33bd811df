#include "world/world.h"

#include <algorithm>

namespace slicecast {

void markSeeThrough(World& world) {
    for (CellBlueprint& blueprint : world.blueprints) {
        const auto& faces = blueprint.faces;
        blueprint.seeThrough =
            blueprint.isWater ||
            std::any_of(faces.begin(), faces.end(), [&](const FaceBlueprint& face) {
                return face.texture != kNoTexture && world.textures[face.texture].seeThrough;
            });
    }
}

void markPortals(World& world) {
    for (CellBlueprint& blueprint : world.blueprints) {
        blueprint.hasPortals =
            std::any_of(blueprint.faces.begin(), blueprint.faces.end(),
                        [](const FaceBlueprint& face) { return face.portal != kNoPortal; });
    }
}

}  // namespace slicecast

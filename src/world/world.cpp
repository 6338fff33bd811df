#include "world/world.h"

#include <algorithm>

namespace slicecast {
namespace {

const CellBlueprint& originOf(const World& world, const CellBlueprint& blueprint) {
    return blueprint.origin == kEmptyCell ? blueprint : world.blueprints[blueprint.origin];
}

}  // namespace

CellBlueprint instanceOf(const World& world, BlueprintId id) {
    CellBlueprint instance = world.blueprints[id];
    if (instance.origin == kEmptyCell) instance.origin = id;
    instance.firstVariant = kEmptyCell;
    instance.variants = 1;
    return instance;
}

bool areJoined(const World& world, const CellBlueprint& a, const CellBlueprint& b) {
    return a.seeThrough && a.join && b.seeThrough && b.join &&
           &originOf(world, a) == &originOf(world, b);
}

bool areOneAlong(const World& world, const CellBlueprint& a, const CellBlueprint& b, Axis axis) {
    return a.seeThrough && b.seeThrough && a.motion >= 0 && areOneMover(a, b) &&
           world.motions[static_cast<std::size_t>(a.motion)].axis == axis;
}

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

bool movesSideways(const World& world, const CellBlueprint& block) {
    return block.motion >= 0 && world.motions[static_cast<std::size_t>(block.motion)].isSideways();
}

void markPlans(World& world) {
    world.hasPlans = std::any_of(
        world.blueprints.begin(), world.blueprints.end(), [&](const CellBlueprint& blueprint) {
            return !blueprint.plan.isWhole() || movesSideways(world, blueprint);
        });
}

}  // namespace slicecast

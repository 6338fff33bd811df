#include "session/old_ways.h"

#include <algorithm>
#include <array>

namespace slicecast {
namespace {

constexpr auto kOldWays = std::to_array<OldWay>({
    {"Fish eye",
     "Columns at equal angles, heights by the distance along the ray: straight walls bulge.",
     "classic.projection=equalAngles"},
    {"Half a fish eye",
     "Equal angles, and the distance times the cosine: the wall ahead is straight, others bend.",
     "classic.projection=equalAnglesCorrected"},
    {"Marching with a step",
     "Rays look for walls every fifth of a unit: edges are ragged, thin corners are missed.",
     "classic.march=on classic.step=0.2"},
    {"Marching that gives up", "Rays end after eight units: anything further away is missing.",
     "classic.march=on classic.step=0.02 classic.reach=8"},
    {"A coarse sine table",
     "A table with one entry per degree: groups of columns look the same way.",
     "classic.projection=equalAnglesCorrected classic.sineSteps=360"},
    {"Big pixels", "Each colour fills eight by eight pixels, as on a slow computer.",
     "classic.pixelSize=8"},
    {"Stretched textures", "One picture over a whole wall: bricks grow with its height.",
     "classic.stretched=on"},
    {"Mirrored letters",
     "Textures are not turned for each side: on two of four faces letters are mirrored.",
     "classic.mirroredTextures=on"},
    {"Painter's order",
     "Blocks are painted from far to near by the distance of their middles, which fails where they "
     "interlock.",
     "classic.painter=on"},
    {"One level", "All blocks are one unit high and stand on the floor: the first hides the rest.",
     "classic.oneLevel=on"},
    {"One hit per level",
     "Each level shows its first block: behind a low wall houses have no ground floor.",
     "classic.firstHits=on"},
    {"Roofs of one colour", "Tops of blocks have no texture yet.", "classic.roofs=flat"},
    {"No roofs", "Only walls are drawn: you look over them at the things behind.",
     "classic.roofs=missing"},
    {"The own tile is missing", "The roof under your feet and the blocks above you are not drawn.",
     "classic.noOwnCell=on"},
    {"Seams", "Walls begin one row too low: lines between stacked blocks.", "classic.seams=on"},
    {"A drifting horizon", "When you fly up, the horizon sinks as if you were looking up.",
     "classic.driftingHorizon=on"},
    {"One depth per column",
     "A low wall hides all of a tree behind it: each column has only one distance.",
     "classic.columnDepth=on"},
    {"Objects in a wrong scale",
     "Objects scale with the picture's height, walls with its width: objects shrink and float.",
     "classic.wrongScale=on"},
    {"A flipped reflection",
     "Floors copy the picture above them upside down, instead of mirroring the scene.",
     "classic.flippedMirrors=on"},
    {"Portals drawn over",
     "The view through a portal covers the things in front of it, except at its two ends.",
     "classic.portalsOverdrawn=on"},
});

bool hasMirrorsAboveFloor(const World& world) {
    return std::any_of(
        world.blueprints.begin(), world.blueprints.end(),
        [](const CellBlueprint& blueprint) { return blueprint.face(Face::top).mirror > 0; });
}

bool hasSlopes(const World& world) {
    return std::any_of(world.blueprints.begin(), world.blueprints.end(),
                       [](const CellBlueprint& blueprint) { return blueprint.slopes.any(); });
}

bool hasJoinedBlocks(const World& world) {
    return std::any_of(
        world.blueprints.begin(), world.blueprints.end(),
        [](const CellBlueprint& blueprint) { return blueprint.seeThrough && blueprint.join; });
}

}  // namespace

std::span<const OldWay> knownOldWays() {
    return kOldWays;
}

std::vector<std::string> leftOut(const World& world, const SessionOptions& options) {
    std::vector<std::string> sentences;
    if (options.method == DrawMethod::exact && options.compare == 0.0) return sentences;
    const ClassicOptions& classic = options.classic;
    if (classic.oneLevel && hasSlopes(world))
        sentences.push_back("Slopes: their blocks are level boxes.");
    if (!world.portals.empty() && hasJoinedBlocks(world)) {
        sentences.push_back("Glass is not joined through a portal: the faces between are drawn.");
    }
    if (classic.flippedMirrors && hasMirrorsAboveFloor(world))
        sentences.push_back("Mirrors above the floor: they do not reflect.");
    if (classic.paintersOrder && classic.portalsOverdrawn && !world.portals.empty())
        sentences.push_back("Portals drawn over: painter's order paints them in their turn.");
    return sentences;
}

}  // namespace slicecast

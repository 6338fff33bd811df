#include "session/old_ways.h"

#include "base/later_text.h"

#include <algorithm>
#include <array>

namespace slicecast {
namespace {

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
    // No first picture needs them.
    static const auto kWays = std::to_array<OldWay>({
        {"Fish eye"_later,
         "Columns at equal angles, heights by the distance along the "
         "ray: straight walls bulge."_later,
         "classic.projection=equalAngles"_later},
        {"Half a fish eye"_later,
         "Equal angles, and the distance times the cosine: the wall "
         "ahead is straight, others bend."_later,
         "classic.projection=equalAnglesCorrected"_later},
        {"Marching with a step"_later,
         "Rays look for walls every fifth of a unit: edges are "
         "ragged, thin corners are missed."_later,
         "classic.march=on classic.step=0.2"_later},
        {"Marching that gives up"_later,
         "Rays end after eight units: anything further away is missing."_later,
         "classic.march=on classic.step=0.02 classic.reach=8"_later},
        {"A coarse sine table"_later,
         "A table with one entry per degree: groups of columns look the same way."_later,
         "classic.projection=equalAnglesCorrected classic.sineSteps=360"_later},
        {"Big pixels"_later,
         "Each colour fills eight by eight pixels, as on a slow computer."_later,
         "classic.pixelSize=8"_later},
        {"Stretched textures"_later,
         "One picture over a whole wall: bricks grow with its height."_later,
         "classic.stretched=on"_later},
        {"Mirrored letters"_later,
         "Textures are not turned for each side: on two of four faces letters are mirrored."_later,
         "classic.mirroredTextures=on"_later},
        {"Painter's order"_later,
         "Blocks are painted from far to near by the distance of their middles, which fails where "
         "they "
         "interlock."_later,
         "classic.painter=on"_later},
        {"One level"_later,
         "All blocks are one unit high and stand on the floor: the first hides the rest."_later,
         "classic.oneLevel=on"_later},
        {"One hit per level"_later,
         "Each level shows its first block: behind a low wall houses have no ground floor."_later,
         "classic.firstHits=on"_later},
        {"Roofs of one colour"_later, "Tops of blocks have no texture yet."_later,
         "classic.roofs=flat"_later},
        {"No roofs"_later, "Only walls are drawn: you look over them at the things behind."_later,
         "classic.roofs=missing"_later},
        {"The own tile is missing"_later,
         "The roof under your feet and the blocks above you are not drawn."_later,
         "classic.noOwnCell=on"_later},
        {"Seams"_later, "Walls begin one row too low: lines between stacked blocks."_later,
         "classic.seams=on"_later},
        {"A drifting horizon"_later,
         "When you fly up, the horizon sinks as if you were looking up."_later,
         "classic.driftingHorizon=on"_later},
        {"One depth per column"_later,
         "A low wall hides all of a tree behind it: each column has only one distance."_later,
         "classic.columnDepth=on"_later},
        {"Objects in a wrong scale"_later,
         "Objects scale with the picture's height, walls with its "
         "width: objects shrink and float."_later,
         "classic.wrongScale=on"_later},
        {"A flipped reflection"_later,
         "Floors copy the picture above them upside down, instead of mirroring the scene."_later,
         "classic.flippedMirrors=on"_later},
        {"Portals drawn over"_later,
         "The view through a portal covers the things in front of it, "
         "except at its two ends."_later,
         "classic.portalsOverdrawn=on"_later},
    });
    return kWays;
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

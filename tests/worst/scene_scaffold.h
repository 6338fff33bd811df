// The scenes that a SceneMaker begins with: a map with blocks, portals and objects.
#pragma once

#include "scene_maker.h"

#include <array>
#include <cstdint>
#include <string>

namespace slicecast {

// What the map is made of: each number from 0 to 255 is a share of its range, so that any bytes
// are a scene.
enum Gene : std::uint8_t {
    size,     // tiles a side, from 8 to the widest
    levels,   // 1 to 32
    walls,    // density of blocks
    glass,    // density of blocks that are seen through
    gates,    // density of gates
    movers,   // density of moving blocks
    portals,  // how many, 0 to 1,020
    far,      // a portal leads far away, or near
    limit,    // portals that a ray passes, 1 to 32
    well,     // all around the eye stand portals; how many levels high
    bushes,   // density of objects
    walkers,  // density of objects that move
    mirrors,  // bits: floor, roofs, ceiling; and how strong
    ceiling,  // height, none below 64
    water,    // density of water
    eye,      // height
    seed,
    count
};
using Genes = std::array<std::uint8_t, Gene::count>;

std::string sceneScaffold(const Genes& genes, const ScenePictures& pictures, int widest);

}  // namespace slicecast

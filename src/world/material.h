// The materials of textures: what steps on them, and blocks that move, sound like.
#pragma once

#include "base/named.h"
#include "slicecast/sound.h"

#include <optional>
#include <string_view>

namespace slicecast {

// As scenes write them.
inline constexpr Named<Material> kMaterialNames[kMaterials] = {
    {Material::stone, "stone"}, {Material::wood, "wood"},   {Material::earth, "earth"},
    {Material::grass, "grass"}, {Material::sand, "sand"},   {Material::metal, "metal"},
    {Material::glass, "glass"}, {Material::cloth, "cloth"}, {Material::water, "water"}};

// The material that the first telling word of a name stands for: "planks-floor.png" is wood. Words
// are runs of the letters a to z. Nothing if no word tells.
std::optional<Material> materialOfName(std::string_view name);

}  // namespace slicecast

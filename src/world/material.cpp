#include "world/material.h"

#include <algorithm>
#include <cstddef>

namespace slicecast {
namespace {

// Besides the names of the materials themselves. web/docs/scenes.md lists them.
constexpr Named<Material> kTellingWords[] = {
    {Material::wood, "planks"}, {Material::wood, "timber"},      {Material::wood, "boards"},
    {Material::wood, "door"},   {Material::wood, "crate"},       {Material::earth, "path"},
    {Material::grass, "turf"},  {Material::grass, "moss"},       {Material::grass, "leaves"},
    {Material::sand, "gravel"}, {Material::sand, "snow"},        {Material::metal, "iron"},
    {Material::metal, "grate"}, {Material::metal, "portcullis"}, {Material::cloth, "carpet"},
};

bool isLetter(char c) {
    return c >= 'a' && c <= 'z';
}

}  // namespace

std::optional<Material> materialOfName(std::string_view name) {
    while (!name.empty()) {
        const auto end = std::find_if_not(name.begin(), name.end(), isLetter);
        const auto length = static_cast<std::size_t>(end - name.begin());
        const std::string_view word = name.substr(0, length);
        if (const auto material = valueOf(kMaterialNames, word)) return material;
        if (const auto material = valueOf(kTellingWords, word)) return material;
        name.remove_prefix(std::min(length + 1, name.size()));
    }
    return std::nullopt;
}

}  // namespace slicecast

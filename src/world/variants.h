// Variants: a texture may stand for several, of which each place shows one. The place alone decides
// which, so the same scene looks the same everywhere.
#pragma once

#include "base/random.h"
#include "world/blueprint.h"

#include <cstdint>

namespace slicecast {

// The pictures of a texture with variants, itself included, are at most 8. All counts up to 8
// divide this number.
inline constexpr int kMostVariants = 8;
inline constexpr int kVariantNumbers = 840;

// Tiles of the floor and of the ceiling lie on levels of their own.
inline constexpr int kFloorVariants = -1;
inline constexpr int kCeilingVariants = -2;

// The number of a place, from 0 to 839. A texture of n pictures shows the one with this number
// modulo n there.
inline int variantNumber(int x, int y, int level) {
    const auto part = [](int number) { return static_cast<std::uint64_t>(number + 2); };
    return Random(part(x) | part(y) << 20 | part(level) << 40).below(kVariantNumbers);
}

// What a cell shows whose blueprint the scene's text says.
inline BlueprintId variantAt(BlueprintId id, const CellBlueprint& blueprint, int x, int y,
                             int level) {
    const int number =
        blueprint.variants == 1 ? 0 : variantNumber(x, y, level) % blueprint.variants;
    return number == 0 ? id : static_cast<BlueprintId>(blueprint.firstVariant + number - 1);
}

}  // namespace slicecast

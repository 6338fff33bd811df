// Chooses for each place which of a texture's variants it shows. Comes last: before, a block and a
// tile are what the text says.
#include "base/later_text.h"
#include "scene/readers.h"
#include "world/variants.h"

#include <bit>
#include <numeric>
#include <vector>

namespace slicecast {
namespace {

using Pictures = std::vector<std::vector<TextureId>>;

// After this many places a blueprint's faces repeat.
int periodOf(const CellBlueprint& blueprint, const Pictures& pictures) {
    std::size_t period = 1;
    for (const FaceBlueprint& face : blueprint.faces) {
        if (face.texture != kNoTexture && !pictures[face.texture].empty())
            period = std::lcm(period, pictures[face.texture].size());
    }
    return static_cast<int>(period);
}

// False if there would be too many blueprints.
bool makeVariants(World& world, const Pictures& pictures) {
    const std::size_t count = world.blueprints.size();
    for (std::size_t id = 0; id < count; ++id) {
        // Instances keep what they have.
        if (world.blueprints[id].origin != kEmptyCell || !world.blueprints[id].isStill()) continue;
        const int period = periodOf(world.blueprints[id], pictures);
        if (period == 1) continue;
        const std::size_t first = world.blueprints.size();
        if (first + static_cast<std::size_t>(period - 1) > static_cast<std::size_t>(kMaxBlueprints))
            return false;
        for (int number = 1; number < period; ++number) {
            CellBlueprint variant = instanceOf(world, static_cast<BlueprintId>(id));
            for (FaceBlueprint& face : variant.faces) {
                if (face.texture == kNoTexture || pictures[face.texture].empty()) continue;
                const std::vector<TextureId>& choice = pictures[face.texture];
                face.texture = choice[static_cast<std::size_t>(number) % choice.size()];
            }
            world.blueprints.push_back(std::move(variant));
        }
        world.blueprints[id].firstVariant = static_cast<BlueprintId>(first);
        world.blueprints[id].variants = static_cast<std::uint16_t>(period);
    }
    return true;
}

void placeTiles(const Map& map, int level, TextureId except, const Pictures& pictures,
                std::vector<TextureId>& tiles) {
    for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
        const TextureId own = tiles[tile];
        if (own == kNoTexture || own == except || pictures[own].empty()) continue;
        const int x = static_cast<int>(tile) % map.width;
        const int y = static_cast<int>(tile) / map.width;
        tiles[tile] = pictures[own][static_cast<std::size_t>(variantNumber(x, y, level)) %
                                    pictures[own].size()];
    }
}

void placeCells(const World& world, Map& map) {
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            for (std::uint32_t levels = map.occupied[map.tileIndex(x, y)]; levels != 0;
                 levels &= levels - 1) {
                const int level = std::countr_zero(levels);
                const BlueprintId id = map.cell(x, y, level);
                const BlueprintId variant = variantAt(id, world.blueprints[id], x, y, level);
                if (variant != id) map.setCell(x, y, level, variant);
            }
        }
    }
}

}  // namespace

void placeVariants(Reading& reading) {
    if (reading.checker.count() > 0 || !reading.variants) return;
    World& world = reading.description.world;
    Pictures& pictures = reading.pictures;
    pictures.resize(world.textures.size());
    if (!makeVariants(world, pictures)) {
        reading.checker.add(*reading.variants,
                            {"variants that make more than "_later, kMaxBlueprints, " blueprints"},
                            "fewer blueprints or variants"_later);
        return;
    }
    for (Map& map : world.maps) {
        placeCells(world, map);
        placeTiles(map, kFloorVariants, map.floor.water, pictures, map.floor.tiles);
        placeTiles(map, kCeilingVariants, kNoTexture, pictures, map.ceiling.tiles);
    }
}

}  // namespace slicecast

// Gives moving blocks and gates their own blueprints once all maps are complete, and checks that
// they have room.
#include "base/later_text.h"
#include "scene/readers.h"
#include "world/gate.h"
#include "world/mover.h"

#include <algorithm>
#include <vector>

namespace slicecast {
namespace {

// The element of an array.
JsonValue elementOf(JsonValue array, int index) {
    auto element = array.begin();
    for (int i = 0; i < index; ++i) ++element;
    return *element;
}

// Whether a row leaves the tile to what fills its level.
__attribute__((noinline)) bool keeps(JsonValue row, int x) {
    std::size_t offset = 0;
    for (int i = 0; i < x; ++i) takeSign(row.text(), offset);
    return row.text()[offset] == ' ';
}

// At the cell's character in its row, or at what fills its level.
void addFault(Reading& reading, const PlacingFault& fault) {
    const JsonValue level =
        reading.levels[static_cast<std::size_t>(fault.map)][static_cast<std::size_t>(fault.level)];
    const FoundValue rows = level.isArray() ? level : level.find("rows");
    if (rows && rows->count() > 0) {
        const JsonValue row = elementOf(*rows, fault.y);
        if (level.isArray() || !keeps(row, fault.x))
            return reading.checker.addInRow(row, fault.y, fault.x, fault.found, fault.expected);
    }
    if (level.isArray()) return reading.checker.add(level, fault.found, fault.expected);
    reading.checker.add(*level.find("fill"),
                        {fault.found, " at x ", fault.x, ", y ", fault.y, ", level ", fault.level},
                        fault.expected);
}

// Each frame of a sheet that a gate shows becomes a texture.
void checkGateFrames(Reading& reading) {
    const World& world = reading.description.world;
    std::vector<bool> isSheet(world.textures.size());
    for (const Gate& gate : world.gates) {
        for (const BlueprintId part : gate.parts) {
            for (const FaceBlueprint& face : world.blueprints[part].faces)
                isSheet[face.texture] = true;
        }
    }
    std::size_t textures = world.textures.size();
    for (std::size_t i = 0; i < isSheet.size(); ++i) {
        const TextureReference& texture = reading.description.textures[i];
        if (isSheet[i] && texture.rate == 0.0)
            textures += static_cast<std::size_t>(texture.frames - 1);
    }
    if (textures <= static_cast<std::size_t>(kMaxTextures)) return;
    reading.checker.add(*reading.mapList,
                        {Counted{static_cast<std::int64_t>(textures), "texture"},
                         ", counting the frames of gates"_later},
                        {"at most ", kMaxTextures});
}

// A gate that follows one that stands nowhere waits for ever.
void warnOfMissingGates(Reading& reading) {
    const World& world = reading.description.world;
    std::vector<bool> stands(world.gateKinds.size());
    for (const Gate& gate : world.gates) stands[static_cast<std::size_t>(gate.kind)] = true;
    for (const FollowedGate& followed : reading.followed) {
        const auto id = reading.checker.name(followed.name, reading.blueprints, "blueprint");
        if (!id || !stands[static_cast<std::size_t>(followed.kind)] ||
            stands[static_cast<std::size_t>(world.blueprints[*id].gate)])
            continue;
        reading.checker.warn(
            followed.name,
            {"the gate ", quoted(world.blueprints[*id].name), ", which stands in no map"_later},
            "a gate that a player can open, or that opens by itself"_later);
    }
}

// Once the movers are made.
void placeGates(Reading& reading) {
    std::vector<PlacingFault> faults = reading.movers->takeFaults();
    const std::vector<PlacingFault> more = makeGates(reading.description.world);
    faults.insert(faults.end(), more.begin(), more.end());
    for (const PlacingFault& fault : faults) addFault(reading, fault);
    if (!faults.empty()) {
        reading.areBlueprintsSound = false;  // the blocks around the start are unknown
        return;
    }
    checkGateFrames(reading);
    warnOfMissingGates(reading);
}

}  // namespace

void placeMovers(Reading& reading, JsonValue maps) {
    if (!maps.isArray() || !reading.areBlueprintsSound) return;
    const bool areSound = std::all_of(reading.isMapSound.begin(), reading.isMapSound.end(),
                                      [](bool isSound) { return isSound; });
    if (!areSound) return;
    reading.mapList = maps;
    reading.movers.emplace(reading.description.world, reading.tasks);
    reading.tasks.add<placeGates>(reading);
}

}  // namespace slicecast

#include "slicecast/scene_builder.h"

#include "base/printable.h"
#include "base/words.h"
#include "scene/limits.h"
#include "scene/source_text.h"
#include "world/material.h"
#include "world/world.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

bool isWithin(double value, double low, double high) {
    return value >= low && value <= high;  // false for a NaN
}

template <typename List>
bool isIndexOf(int index, const List& list) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size();
}

bool isSign(std::string_view text) {
    std::size_t end = 0;
    return !SourceText(text).invalidByte() && takeSign(text, end) == text && isPrintableSign(text);
}

// A part of the scene as messages name it: block "wall"
std::string named(const char* kind, const std::string& name) {
    return words(kind, " \"", name, "\"");
}

std::string sizeOf(int width, int depth, int levels) {
    return words(width, "x", depth, " tiles and ", Counted{levels, "level"});
}

}  // namespace

struct SceneBuilder::State {
    World world;
    std::vector<LegendEntry> legend;  // of all maps
    std::int64_t cells = 0;           // of all maps
    bool hasStart = false;
    std::vector<Fault> faults;

    // Adds a fault, unless there are enough. `where` is the faulty part: block "wall".
    void refuse(const std::string& where, const Words& found, const Words& expected) {
        if (faults.size() >= kMaxFaults) return;
        Fault fault;
        fault.file = where;
        fault.found = found.str();
        fault.expected = expected.str();
        faults.push_back(std::move(fault));
    }
    template <typename Names>
    void checkName(const std::string& where, const std::string& name, const Names& others) {
        if (name.empty()) refuse(where, "an empty name", "a name");
        for (const auto& other : others) {
            if (!name.empty() && other.name == name)
                refuse(where, "a name that is already taken", "a unique name");
        }
    }
    bool checkTexture(const std::string& where, Texture texture) {
        const bool isKnown = isIndexOf(texture.index, world.textures);
        if (!isKnown) refuse(where, "no texture", "one that texture() or colour() returned");
        return isKnown;
    }
    // Adds a fault if there is no such map.
    slicecast::Map* find(Map map, const std::string& where) {
        if (isIndexOf(map.index, world.maps))
            return &world.maps[static_cast<std::size_t>(map.index)];
        refuse(where, "no map", "one that map() returned");
        return nullptr;
    }
    void checkBlock(const std::string& where, const BlockSpec& spec);
    bool checkMap(const std::string& where, const MapSpec& spec);
    bool checkBox(const slicecast::Map& map, const Box& box);
};

void SceneBuilder::State::checkBlock(const std::string& where, const BlockSpec& spec) {
    checkName(where, spec.name, world.blueprints);
    checkTexture(where, spec.texture);
    if (spec.topTexture.index >= 0) checkTexture(where, spec.topTexture);
    // Heights are rounded; they must still differ afterwards.
    if (!isWithin(spec.bottom, 0.0, 1.0) || !isWithin(spec.top, 0.0, 1.0) ||
        toCoordinate(spec.bottom) >= toCoordinate(spec.top)) {
        refuse(where, {"a bottom of ", Shortest{spec.bottom}, " and a top of ", Shortest{spec.top}},
               "0 <= bottom < top <= 1");
    }
    if (spec.rise) {
        if (spec.rise->side == Face::top || spec.rise->side == Face::bottom)
            refuse(where, "a rise to the top or the bottom", "a rise to one of the four sides");
        if (!isWithin(spec.rise->from, spec.bottom, spec.top)) {
            refuse(where, {"a rise from ", Shortest{spec.rise->from}},
                   {"a height from ", Shortest{spec.bottom}, " to ", Shortest{spec.top}});
        }
        if (spec.diagonal != Half::none || spec.mirror > 0.0)
            refuse(where, "a rise", "none, with a diagonal or a mirror");
    }
    if (!isWithin(spec.light, 0.0, 1.0))
        refuse(where, {"a light of ", Shortest{spec.light}}, "a number from 0 to 1");
    if (!isWithin(spec.mirror, 0.0, 1.0))
        refuse(where, {"a mirror of ", Shortest{spec.mirror}}, "a number from 0 to 1");
    if (spec.sign.empty()) return;
    const bool isTaken = std::any_of(legend.begin(), legend.end(), [&](const LegendEntry& entry) {
        return entry.sign == spec.sign;
    });
    if (isTaken || spec.sign == ".")
        refuse(where, "a sign that is already taken", "a unique one, not '.'");
    if (!isSign(spec.sign))
        refuse(where, {"the sign \"", printable(spec.sign), "\""}, "a single visible character");
}

bool SceneBuilder::State::checkMap(const std::string& where, const MapSpec& spec) {
    checkName(where, spec.name, world.maps);
    if (world.maps.size() >= kMaxMaps) {
        refuse(where, "one more map", {"at most ", kMaxMaps});
        return false;
    }
    const bool fits = spec.width >= 1 && spec.width <= kMaxMapWidth && spec.depth >= 1 &&
                      spec.depth <= kMaxMapDepth && spec.levels >= 1 && spec.levels <= kMaxLevels;
    const std::int64_t more = fits ? std::int64_t{spec.width} * spec.depth * spec.levels : 0;
    if (!fits || cells + more > kMaxSceneCells) {
        refuse(where, sizeOf(spec.width, spec.depth, spec.levels),
               {"1 to ", kMaxMapWidth, "x", kMaxMapDepth, " tiles, 1 to ", kMaxLevels,
                " levels, and at most ", kMaxSceneCells, " cells in all maps"});
        return false;
    }
    if (!isWithin(spec.fogStart, 0.0, kMaxFar) || !isWithin(spec.fogEnd, 0.0, kMaxFar)) {
        refuse(where, {"a fog from ", Shortest{spec.fogStart}, " to ", Shortest{spec.fogEnd}},
               {"numbers from 0 to ", static_cast<int>(kMaxFar)});
    }
    if (!checkTexture(where, spec.floor)) return false;
    cells += more;
    return true;
}

bool SceneBuilder::State::checkBox(const slicecast::Map& map, const Box& box) {
    const auto lies = [](int first, int count, int size) {
        return first >= 0 && count >= 1 && count <= size && first <= size - count;
    };
    if (lies(box.x, box.width, map.width) && lies(box.y, box.depth, map.depth) &&
        lies(box.level, box.levels, map.levels))
        return true;
    refuse(named("map", map.name),
           {"a box of ", sizeOf(box.width, box.depth, box.levels), " at x ", box.x, ", y ", box.y,
            ", level ", box.level},
           {"one inside the map's ", sizeOf(map.width, map.depth, map.levels)});
    return false;
}

SceneBuilder::SceneBuilder(std::string title) : state_(std::make_unique<State>()) {
    state_->world.title = std::move(title);
}
SceneBuilder::~SceneBuilder() = default;
SceneBuilder::SceneBuilder(SceneBuilder&& other) noexcept = default;
SceneBuilder& SceneBuilder::operator=(SceneBuilder&& other) noexcept = default;

SceneBuilder::Texture SceneBuilder::texture(std::string name, const Image& image) {
    State& state = *state_;
    const std::string where = named("texture", name);
    state.checkName(where, name, state.world.textures);
    const int side = image.width;
    const bool isSound = side == image.height && side >= kMinTextureSize &&
                         side <= kMaxTextureSize &&
                         std::has_single_bit(static_cast<unsigned>(side)) &&
                         std::cmp_equal(image.pixels.size(), side * side);
    if (!isSound) {
        state.refuse(where, {image.width, "x", image.height, " pixels"},
                     "a square with 8, 16, 32, 64, 128, 256, 512 or 1024 pixels a side");
        return {};
    }
    if (state.world.textures.size() >= kMaxTextures) {
        state.refuse(where, "one more texture", {"at most ", kMaxTextures});
        return {};
    }
    const Material material = materialOfName(name).value_or(Material::stone);
    state.world.textures.push_back(makeTexture(std::move(name), image));
    state.world.textures.back().material = material;
    return {static_cast<int>(state.world.textures.size()) - 1};
}

SceneBuilder::Texture SceneBuilder::colour(std::string name, Colour colour) {
    Image image(kMinTextureSize, kMinTextureSize);
    std::fill(image.pixels.begin(), image.pixels.end(),
              toPixel({colour.r, colour.g, colour.b, 255}));
    return texture(std::move(name), image);
}

SceneBuilder::Block SceneBuilder::block(const BlockSpec& spec) {
    State& state = *state_;
    const std::string where = named("block", spec.name);
    const std::size_t faultsBefore = state.faults.size();
    state.checkBlock(where, spec);
    if (state.world.blueprints.size() > kMaxBlueprints)
        state.refuse(where, "one more block", {"at most ", kMaxBlueprints});
    if (state.faults.size() != faultsBefore) return {};

    CellBlueprint blueprint;
    blueprint.name = spec.name;
    blueprint.bottom = toCoordinate(spec.bottom);
    blueprint.top = toCoordinate(spec.top);
    blueprint.plan.half = spec.diagonal;
    if (spec.rise) {
        const Slant level = {blueprint.bottom, blueprint.bottom};
        blueprint.slopes =
            slopesTo(spec.rise->side, level, {toCoordinate(spec.rise->from), blueprint.top});
    }
    for (FaceBlueprint& face : blueprint.faces) {
        face.texture = static_cast<TextureId>(spec.texture.index);
        face.light = spec.light;
    }
    FaceBlueprint& top = blueprint.faces[static_cast<std::size_t>(Face::top)];
    if (spec.topTexture.index >= 0) top.texture = static_cast<TextureId>(spec.topTexture.index);
    top.mirror = static_cast<std::uint8_t>(std::floor(spec.mirror * 255.0 + 0.5));
    const int index = static_cast<int>(state.world.blueprints.size());
    state.world.blueprints.push_back(std::move(blueprint));
    if (!spec.sign.empty()) state.legend.push_back({spec.sign, static_cast<BlueprintId>(index)});
    return {index};
}

SceneBuilder::Map SceneBuilder::map(const MapSpec& spec) {
    State& state = *state_;
    if (!state.checkMap(named("map", spec.name), spec)) return {};
    slicecast::Map map = makeMap(spec.name, spec.width, spec.depth, spec.levels,
                                 static_cast<TextureId>(spec.floor.index));
    map.sky.kind = Sky::Kind::gradient;
    map.sky.low = {spec.skyLow.r, spec.skyLow.g, spec.skyLow.b, 255};
    map.sky.high = {spec.skyHigh.r, spec.skyHigh.g, spec.skyHigh.b, 255};
    map.haze = map.sky.low;
    if (spec.fogEnd > spec.fogStart)
        map.fog = {.on = true, .start = spec.fogStart, .end = spec.fogEnd};
    state.world.maps.push_back(std::move(map));
    return {static_cast<int>(state.world.maps.size()) - 1};
}

void SceneBuilder::fill(Map map, const Box& box, Block block) {
    State& state = *state_;
    slicecast::Map* const found = state.find(map, "fill");
    if (found == nullptr) return;
    if (!isIndexOf(block.index, state.world.blueprints)) {
        state.refuse("fill", "no block", "one that block() returned");
        return;
    }
    slicecast::Map& place = *found;
    if (!state.checkBox(place, box)) return;
    for (int y = box.y; y < box.y + box.depth; ++y) {
        for (int x = box.x; x < box.x + box.width; ++x) {
            for (int level = box.level; level < box.level + box.levels; ++level)
                place.setCell(x, y, level, static_cast<BlueprintId>(block.index));
        }
    }
}

void SceneBuilder::light(Map map, const Sun& sun) {
    State& state = *state_;
    slicecast::Map* const place = state.find(map, "light");
    if (place == nullptr) return;
    if (!std::isfinite(sun.azimuthDegrees) || !isWithin(sun.altitudeDegrees, 0.0, 90.0) ||
        sun.altitudeDegrees == 0.0) {
        state.refuse("light",
                     {"a sun at azimuth ", Shortest{sun.azimuthDegrees}, " and altitude ",
                      Shortest{sun.altitudeDegrees}},
                     "an azimuth in degrees, and an altitude above 0 and at most 90");
        return;
    }
    place->baked.on = true;
    place->baked.azimuth = sun.azimuthDegrees;
    place->baked.altitude = sun.altitudeDegrees;
    place->baked.sun = sun.colour;
    place->baked.ambient = sun.ambient;
}

void SceneBuilder::lamp(Map map, const Lamp& lamp) {
    State& state = *state_;
    slicecast::Map* const place = state.find(map, "lamp");
    if (place == nullptr) return;
    const bool isOnMap = isWithin(lamp.x, 0.0, place->width) &&
                         isWithin(lamp.y, 0.0, place->depth) && isWithin(lamp.z, 0.0, kMaxHeight) &&
                         place->contains(toCoordinate(lamp.x).tile(), toCoordinate(lamp.y).tile());
    if (!isOnMap || !isWithin(lamp.strength, 0.0, kStrongestLamp) ||
        !isWithin(lamp.radius, 0.0, kFarthestLamp.value()) || toCoordinate(lamp.radius).raw == 0 ||
        place->baked.lamps.size() >= kMaxLamps) {
        state.refuse(
            "lamp",
            {"x ", Shortest{lamp.x}, ", y ", Shortest{lamp.y}, ", z ", Shortest{lamp.z},
             ", strength ", Shortest{lamp.strength}, ", radius ", Shortest{lamp.radius}},
            {"x from 0 to below ", place->width, ", y from 0 to below ", place->depth,
             ", z from 0 to ", static_cast<int>(kMaxHeight),
             ", strength 0 to 16, radius above 0 and at most 16, at most ", kMaxLamps, " lamps"});
        return;
    }
    place->baked.on = true;
    place->baked.lamps.push_back({toCoordinate(lamp.x),
                                  toCoordinate(lamp.y),
                                  toCoordinate(lamp.z),
                                  {lamp.colour, lamp.strength, toCoordinate(lamp.radius)}});
}

void SceneBuilder::start(Map map, const Start& start) {
    State& state = *state_;
    const slicecast::Map* const found = state.find(map, "start");
    if (found == nullptr) return;
    const slicecast::Map& place = *found;
    const bool isOnMap = isWithin(start.x, 0.0, place.width) &&
                         isWithin(start.y, 0.0, place.depth) &&
                         place.contains(toCoordinate(start.x).tile(), toCoordinate(start.y).tile());
    if (!isOnMap || !isWithin(start.z, 0.0, kMaxHeight) || !std::isfinite(start.headingDegrees)) {
        state.refuse("start",
                     {"x ", Shortest{start.x}, ", y ", Shortest{start.y}, ", z ", Shortest{start.z},
                      ", heading ", Shortest{start.headingDegrees}},
                     {"x from 0 to below ", place.width, ", y from 0 to below ", place.depth,
                      ", z from 0 to ", static_cast<int>(kMaxHeight), ", a heading in degrees"});
        return;
    }
    state.hasStart = true;
    state.world.start = {.map = map.index,
                         .x = toCoordinate(start.x),
                         .y = toCoordinate(start.y),
                         .z = toCoordinate(start.z),
                         .headingDegrees = start.headingDegrees};
}

LoadResult SceneBuilder::build() && {
    const std::unique_ptr<State> state = std::move(state_);
    World& world = state->world;
    if (world.maps.empty() && state->faults.empty())
        state->refuse(named("scene", world.title), "no map", "at least one");
    LoadResult result;
    result.faults = std::move(state->faults);
    if (!result.faults.empty()) return result;
    for (slicecast::Map& map : world.maps) map.legend = state->legend;
    if (!state->hasStart) {
        world.start.x = toCoordinate(0.5 * world.maps.front().width);
        world.start.y = toCoordinate(0.5 * world.maps.front().depth);
    }
    markSeeThrough(world);
    markPlans(world);
    result.scene.emplace(std::move(world));
    return result;
}

}  // namespace slicecast

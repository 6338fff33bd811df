#include "answers/cells_json.h"

#include "answers/hits_json.h"
#include "base/number_text.h"
#include "base/words.h"
#include "session/edit_cells.h"

namespace slicecast {
namespace {

void writeColour(JsonText& json, const Texture& texture) {
    const auto colour = averageColour(texture);
    if (!colour) {
        json.null();
    } else {
        const auto number =
            static_cast<std::uint64_t>(colour->r << 16 | colour->g << 8 | colour->b);
        json.text(words("#", hexText(number, 6)));
    }
}

void writeFace(JsonText& json, const World& world, const FaceBlueprint& face) {
    json.beginObject().key("texture");
    if (face.texture == kNoTexture) {
        json.null().key("colour").null();
    } else {
        const Texture& texture = world.textures[face.texture];
        json.text(texture.name).key("colour");
        writeColour(json, texture);
    }
    json.key("light").number(face.light).key("glow").yesNo(face.glow);
    json.key("mirror").number(face.mirror / 255.0).endObject();
}

}  // namespace

std::string cellsJson(const World& world, int mapIndex) {
    const Map& map = world.maps[static_cast<std::size_t>(mapIndex)];
    JsonText json;
    json.beginArray();
    for (int level = 0; level < map.levels; ++level) {
        json.beginArray();
        for (int y = 0; y < map.depth; ++y) json.text(cellRow(world, mapIndex, level, y));
        json.endArray();
    }
    return json.endArray().str();
}

namespace {

// Heights at the western or northern edge, and at the eastern or southern.
template <typename Json>
void writeSlopes(Json& json, const Slopes& slopes) {
    const auto pair = [&](const Slant& slant) {
        return json.pair(slant.from.value(), slant.to.value());
    };
    json.beginObject().key("along").text(slopes.alongX ? "x" : "y");
    json.key("bottom");
    pair(slopes.bottom);
    json.key("top");
    pair(slopes.top);
    json.endObject();
}

}  // namespace

std::string blueprintsJson(const World& world, int mapIndex) {
    JsonText json;
    json.beginArray();
    for (const LegendEntry& entry : world.maps[static_cast<std::size_t>(mapIndex)].legend) {
        const CellBlueprint& blueprint = world.blueprints[entry.blueprint];
        json.beginObject().key("character").text(entry.sign);
        json.key("name").text(blueprint.name);
        json.key("bottom").number(blueprint.bottom.value());
        json.key("top").number(blueprint.top.value());
        if (blueprint.slopes.any()) writeSlopes(json.key("slopes"), blueprint.slopes);
        const Plan& plan = blueprint.plan;
        json.key("plan").beginArray();
        for (const Coordinate edge : {plan.west, plan.north, plan.east, plan.south})
            json.number(edge.value());
        json.endArray();
        json.key("diagonal");
        if (plan.half == Half::none) {
            json.null();
        } else {
            json.text(nameOf(kHalves, plan.half));
        }
        json.key("seeThrough").yesNo(blueprint.seeThrough);
        json.key("moves").yesNo(blueprint.motion >= 0).key("gate").yesNo(blueprint.gate >= 0);
        json.key("faces").beginObject();
        for (int face = 0; face < kFaces; ++face) {
            json.key(kFaceNames[static_cast<std::size_t>(face)]);
            writeFace(json, world, blueprint.face(static_cast<Face>(face)));
        }
        json.endObject().endObject();
    }
    return json.endArray().str();
}

}  // namespace slicecast

#include "base/later_text.h"
#include "scene/limits.h"
#include "scene/readers.h"

#include <algorithm>
#include <array>

namespace slicecast {
namespace {

constexpr NumberRange kSight = {0.0, 1000.0, true, "a number above 0 and at most 1000, in units"};

// The faces that each key of "faces" covers. Wider keys come first: a narrower one overrides them.
// The face of a half's cut has a key of its own.
constexpr const char* kDiagonal = "diagonal";
struct FaceKey {
    const char* key;
    std::array<bool, kFaces> faces;  // north, east, south, west, top, bottom
};
constexpr FaceKey kFaceKeys[] = {
    {"all", {true, true, true, true, true, true}},
    {"sides", {true, true, true, true, false, false}},
    {"north", {true, false, false, false, false, false}},
    {"east", {false, true, false, false, false, false}},
    {"south", {false, false, true, false, false, false}},
    {"west", {false, false, false, true, false, false}},
    {"top", {false, false, false, false, true, false}},
    {"bottom", {false, false, false, false, false, true}},
};

// "brick" or { "texture": "brick", "light": 0.8 } or { "texture": "lava", "glow": true }; only a
// roof may have a "mirror". A faulty face counts as given, so that it is not also reported as
// missing.
FaceBlueprint readFace(Reading& reading, JsonValue value, bool isRoof) {
    FaceBlueprint face;
    if (value.isText()) {
        face.texture = reading.checker.name(value, reading.textures, "texture").value_or(0);
        return face;
    }
    face.texture = 0;
    const auto fields = reading.checker.fields(
        value, {"texture", "light", "glow", "mirror", "ripples", "lamp"},
        "a texture's name, or an object with \"texture\", \"light\" and \"glow\""_onFault);
    if (!fields) return face;
    if (const auto texture = fields->require("texture", "the name of a texture")) {
        face.texture = reading.checker.name(*texture, reading.textures, "texture").value_or(0);
    }
    face.light = fields->number("light", kUnitRange, 1.0);
    face.glow = fields->flag("glow", false);
    const ReadMirror mirrored = readMirror(reading.checker, *fields);
    face.mirror = mirrored.mirror;
    face.ripples = mirrored.ripples;
    if (const auto lamp = fields->find("lamp")) face.lamp = readLamp(reading, *lamp);
    if (const auto mirror = fields->find("mirror"); mirror && !isRoof) {
        reading.checker.addAtKey(*mirror, "a mirror on a side or an underside"_later,
                                 "\"mirror\" on \"top\" or \"all\": only roofs reflect"_later);
    }
    return face;
}

// Water may leave out faces; they do not exist then. Nor does the side of a half's tile beside its
// cut: it gets the texture of the cut, if that has one of its own.
void readFaces(Reading& reading, JsonValue value, CellBlueprint& blueprint) {
    if (value.isText()) {
        blueprint.faces.fill(readFace(reading, value, true));
        return;
    }
    std::vector<std::string_view> keys;
    for (const FaceKey& faceKey : kFaceKeys) keys.push_back(faceKey.key);
    const Half half = blueprint.plan.half;
    if (half != Half::none) keys.emplace_back(kDiagonal);
    const auto fields = reading.checker.fields(
        value, keys, "a texture's name, or an object with textures for the faces"_onFault);
    if (!fields) return;
    for (const FaceKey& faceKey : kFaceKeys) {
        const auto member = fields->find(faceKey.key);
        if (!member) continue;
        constexpr std::size_t kRoof = static_cast<std::size_t>(Face::top);
        const FaceBlueprint face = readFace(reading, *member, faceKey.faces[kRoof]);
        for (std::size_t i = 0; i < blueprint.faces.size(); ++i) {
            if (!faceKey.faces[i]) continue;
            blueprint.faces[i] = face;
            if (i != kRoof) blueprint.faces[i].mirror = 0;
        }
    }
    if (half != Half::none) {
        FaceBlueprint& cut = blueprint.faces[static_cast<std::size_t>(cutFace(half))];
        FaceBlueprint& beside =
            blueprint.faces[static_cast<std::size_t>(isEastern(half) ? Face::west : Face::east)];
        if (const auto member = fields->find(kDiagonal)) {
            cut = readFace(reading, *member, false);
            if (beside.texture == kNoTexture) beside = cut;
        }
    }
    std::string missing;
    for (std::size_t i = 0; i < blueprint.faces.size(); ++i) {
        if (blueprint.faces[i].texture == kNoTexture)
            missing += (missing.empty() ? "" : ", ") + std::string(kFaceNames[i]);
    }
    if (!missing.empty() && !blueprint.isWater) {
        reading.checker.add(value, {"no texture for ", missing},
                            "a texture for each of the six faces, for example with \"all\""_later);
    }
}

// true, or { "colour": "#265c68", "sight": 8 }
void readWater(Reading& reading, JsonValue value, CellBlueprint& blueprint) {
    blueprint.isWater = value.kind() != JsonValue::Kind::boolean || value.boolean();
    if (value.kind() == JsonValue::Kind::boolean) return;
    const auto fields = reading.checker.fields(
        value, {"colour", "sight"}, "true, or an object with \"colour\" and \"sight\""_onFault);
    if (!fields) return;
    blueprint.waterColour = fields->colour("colour", kWaterColour);
    blueprint.waterSight = fields->number("sight", kSight, kWaterSight);
}

// [west, north, east, south], in units from the tile's north-western corner.
Plan readPlan(Reading& reading, JsonValue value) {
    constexpr const char* kPlan =
        "the edges [west, north, east, south], four numbers from 0 to 1, in units";
    Checker& checker = reading.checker;
    if (!value.isArray() || value.count() != 4) {
        checker.refuse(value, kPlan);
        return {};
    }
    const std::size_t faultsBefore = checker.count();
    std::array<Coordinate, 4> edges;
    std::size_t next = 0;
    for (const JsonValue edge : value) {
        edges[next] = toCoordinate(checker.number(edge, kUnitRange).value_or(0.0));
        if (checker.count() == faultsBefore && next >= 2 &&
            edges[next] - edges[next - 2] < kThinnest) {
            const bool isEast = next == 2;
            checker.add(edge, {checker.shown(edge), " for ", isEast ? "\"east\"" : "\"south\""},
                        {"at least 1/16 more than "_later, isEast ? "\"west\"" : "\"north\"",
                         ": the edges are [west, north, east, south]"_later});
        }
        ++next;
    }
    if (checker.count() != faultsBefore) return {};
    return {edges[0], edges[1], edges[2], edges[3]};
}

constexpr Named<Face> kSides[] = {
    {Face::north, "north"}, {Face::east, "east"}, {Face::south, "south"}, {Face::west, "west"}};

// A height, or the two heights of a slope.
struct Heights {
    Slant heights;
    bool isSlope = false;
};
Heights readHeights(Reading& reading, const Fields& fields, const char* key, double otherwise) {
    const auto member = fields.find(key);
    if (!member || !member->isArray()) {
        const Coordinate height = toCoordinate(fields.number(key, kUnitRange, otherwise));
        return {{height, height}, false};
    }
    if (member->count() != 2) {
        reading.checker.refuse(*member,
                               "a number from 0 to 1, or the two heights of a slope"_later);
        return {};
    }
    Heights read = {{}, true};
    Coordinate* next = &read.heights.from;
    for (const JsonValue height : *member) {
        *next = toCoordinate(reading.checker.number(height, kUnitRange).value_or(0.0));
        next = &read.heights.to;
    }
    return read;
}

// "bottom", "top" and "rise". A list has the height at the edge opposite the side `rise` first.
void readShape(Reading& reading, JsonValue value, const Fields& fields, CellBlueprint& blueprint) {
    Checker& checker = reading.checker;
    const std::size_t faultsBefore = checker.count();
    const auto [bottom, hasBottomSlope] = readHeights(reading, fields, "bottom", 0.0);
    const auto [top, hasTopSlope] = readHeights(reading, fields, "top", 1.0);
    const auto rise = fields.find("rise");
    const Face side = fields.choice("rise", kSides, Face::east);
    if (checker.count() != faultsBefore) return;
    const bool isList = hasBottomSlope || hasTopSlope;
    if (isList && !rise) {
        checker.add(value, "a slope that rises towards no side"_later,
                    "\"rise\": \"north\", \"east\", \"south\" or \"west\""_later);
    } else if (rise && !isList) {
        checker.addAtKey(*rise, "\"rise\" without two heights"_later,
                         "\"top\" or \"bottom\" with two heights, as in \"top\": [0, 1]"_later);
    }
    const auto given = fields.find("top") ? fields.find("top") : fields.find("bottom");
    if (bottom.from > top.from || bottom.to > top.to ||
        (bottom.from == top.from && bottom.to == top.to)) {
        checker.add(*given, "a \"top\" that is not above \"bottom\""_later,
                    isList ? "\"top\" nowhere below \"bottom\", and above it at one edge"_later
                           : "\"top\" above \"bottom\", by at least 1/65536"_later);
    }
    blueprint.bottom = bottom.least();
    blueprint.top = top.most();
    if (isList) blueprint.slopes = slopesTo(side, bottom, top);
}

// What a block with slopes cannot be.
void checkSlopes(Reading& reading, const Fields& fields, const CellBlueprint& blueprint) {
    if (!blueprint.slopes.any()) return;
    if (const auto water = fields.find("water"); water && blueprint.isWater)
        reading.checker.add(*water, "water with slopes", "\"rise\" or \"water\", not both"_later);
    if (const auto diagonal = fields.find("diagonal"))
        reading.checker.add(*diagonal, "a half of a tile with slopes"_later,
                            "\"rise\" or \"diagonal\", not both"_later);
    const auto faces = fields.find("faces");
    if (faces && !blueprint.slopes.top.isLevel() && blueprint.face(Face::top).mirror > 0)
        reading.checker.add(*faces, "a mirror on a slope",
                            "a level \"top\", or no \"mirror\""_later);
}

CellBlueprint readBlueprint(Reading& reading, JsonValue value) {
    CellBlueprint blueprint;
    blueprint.name = std::string(value.key());
    const auto fields = reading.checker.fields(
        value,
        {"bottom", "top", "rise", "plan", "diagonal", "water", "faces", "join", "motion", "gate"},
        "a blueprint: an object with \"faces\""_onFault);
    if (!fields) return blueprint;
    const std::size_t faultsBefore = reading.checker.count();
    readShape(reading, value, *fields, blueprint);
    if (const auto plan = fields->find("plan")) blueprint.plan = readPlan(reading, *plan);
    blueprint.plan.half = fields->choice("diagonal", kHalves, Half::none);
    if (const auto diagonal = fields->find("diagonal"); diagonal && fields->find("plan")) {
        reading.checker.add(*diagonal, "a half of a part of a tile"_later,
                            "\"plan\" or \"diagonal\", not both"_later);
    }
    blueprint.join = fields->flag("join", true);
    if (const auto water = fields->find("water")) {
        readWater(reading, *water, blueprint);
        if (blueprint.isWater && !blueprint.plan.isWhole())
            reading.checker.add(*water, "water that fills a part of its tile"_later,
                                blueprint.plan.half == Half::none
                                    ? "\"plan\" or \"water\", not both"_later
                                    : "\"diagonal\" or \"water\", not both"_later);
    }
    if (const auto faces = fields->require("faces", "the textures of the faces"))
        readFaces(reading, *faces, blueprint);
    if (const auto motion = fields->find("motion"))
        blueprint.motion = reading.checker.name(*motion, reading.motions, "motion").value_or(0);
    const bool hasLamp =
        std::any_of(blueprint.faces.begin(), blueprint.faces.end(),
                    [](const FaceBlueprint& face) { return face.lamp != kNoLamp; });
    if (hasLamp && blueprint.motion >= 0) {
        reading.checker.add(*fields->find("faces"), "a lamp on a block that moves"_later,
                            "\"lamp\" or \"motion\", not both: lamps stand still"_later);
    }
    if (const auto gate = fields->find("gate")) {
        blueprint.gate = readGate(reading, *gate);
        if (reading.checker.count() == faultsBefore) checkGate(reading, *gate, blueprint);
    }
    if (const auto motion = fields->find("motion"); reading.checker.count() == faultsBefore)
        checkMotion(reading, motion ? *motion : value, blueprint);
    checkSlopes(reading, *fields, blueprint);
    return blueprint;
}

}  // namespace

void readBlueprints(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    if (!value.isObject()) {
        checker.refuse(value, "the blueprints: an object with a blueprint for each name"_later);
        reading.blueprints.takeAny();
        return;
    }
    if (value.count() > static_cast<std::size_t>(kMaxBlueprints)) {
        checker.add(value, Counted{static_cast<std::int64_t>(value.count()), "blueprint"},
                    {"at most ", kMaxBlueprints});
        reading.blueprints.takeAny();
        return;
    }
    std::vector<CellBlueprint>& blueprints = reading.description.world.blueprints;
    for (const JsonValue member : value) {
        checker.checkName(member);
        reading.blueprints.add(member.key(), static_cast<BlueprintId>(blueprints.size()));
        reading.addAim(Aim::What::block, member, blueprints.size());
        blueprints.push_back(readBlueprint(reading, member));
    }
    findFollowedGates(reading);
}

}  // namespace slicecast

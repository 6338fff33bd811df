#include "session/hits_json.h"

#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

#include <cmath>
#include <cstddef>

namespace slicecast {
namespace {

using Writer = rapidjson::PrettyWriter<rapidjson::StringBuffer>;

const char* nameOf(FilledRows::What what) {
    switch (what) {
        case FilledRows::What::side:
            return "side";
        case FilledRows::What::roof:
            return "roof";
        case FilledRows::What::underside:
            return "underside";
        case FilledRows::What::floor:
            return "floor";
        case FilledRows::What::ceiling:
            return "ceiling";
        case FilledRows::What::sky:
            return "sky";
        case FilledRows::What::haze:
            break;
    }
    return "haze";
}

const char* nameOf(Face face) {
    return kFaceNames[static_cast<std::size_t>(face)];
}

// JSON has no infinite numbers.
void addNumber(Writer& json, double number) {
    if (std::isfinite(number)) {
        json.Double(number);
    } else {
        json.Null();
    }
}

void add(Writer& json, const char* key, double number) {
    json.Key(key);
    addNumber(json, number);
}

void add(Writer& json, const char* key, int number) {
    json.Key(key);
    json.Int(number);
}

void add(Writer& json, const char* key, const std::string& text) {
    json.Key(key);
    json.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
}

void addPair(Writer& json, const char* key, double a, double b) {
    json.Key(key);
    json.SetFormatOptions(rapidjson::kFormatSingleLineArray);
    json.StartArray();
    addNumber(json, a);
    addNumber(json, b);
    json.EndArray();
    json.SetFormatOptions(rapidjson::kFormatDefault);
}

void addPair(Writer& json, const char* key, int a, int b) {
    json.Key(key);
    json.SetFormatOptions(rapidjson::kFormatSingleLineArray);
    json.StartArray();
    json.Int(a);
    json.Int(b);
    json.EndArray();
    json.SetFormatOptions(rapidjson::kFormatDefault);
}

const std::string& mapName(const World& world, int map) {
    return world.maps[static_cast<std::size_t>(map)].name;
}

// Rows from first to last, both included.
void addRows(Writer& json, int first, int last) {
    add(json, "first", first);
    add(json, "last", last - 1);
}

// Planes need no face: the kind says it. They name their map, as blocks do elsewhere.
void addFilled(Writer& json, const World& world, const char* key, const std::vector<FilledRows>& filled, bool arePlanes) {
    json.Key(key);
    json.StartArray();
    for (const FilledRows& rows : filled) {
        json.StartObject();
        add(json, "what", std::string(nameOf(rows.what)));
        if (arePlanes) add(json, "map", mapName(world, rows.map));
        if (!arePlanes) add(json, "face", std::string(nameOf(rows.face)));
        addRows(json, rows.first, rows.last);
        json.EndObject();
    }
    json.EndArray();
}

void addTile(Writer& json, const World& world, const WalkedTile& tile) {
    json.SetFormatOptions(rapidjson::kFormatSingleLineArray);
    json.StartArray();
    json.Int(tile.x);
    json.Int(tile.y);
    addNumber(json, tile.depth);
    const std::string& map = mapName(world, tile.map);
    json.String(map.data(), static_cast<rapidjson::SizeType>(map.size()));
    json.EndArray();
    json.SetFormatOptions(rapidjson::kFormatDefault);
}

void addHit(Writer& json, const World& world, const Hit& hit) {
    json.StartObject();
    add(json, "map", mapName(world, hit.map));
    add(json, "portals", hit.portals);
    addPair(json, "tile", hit.tileX, hit.tileY);
    add(json, "level", hit.level);
    add(json, "blueprint", world.blueprints[hit.blueprint].name);
    json.Key("face");
    if (hit.entered) {
        json.String(nameOf(hit.face));
    } else {
        json.Null();
    }
    addPair(json, "point", hit.x, hit.y);
    add(json, "rawDepth", hit.rawDepth);
    add(json, "depth", hit.depth);
    add(json, "backDepth", hit.backDepth);
    add(json, "bottom", hit.bottom.value());
    add(json, "top", hit.top.value());
    add(json, "bottomFrontRow", hit.bottomFrontRow);
    add(json, "topFrontRow", hit.topFrontRow);
    add(json, "bottomBackRow", hit.bottomBackRow);
    add(json, "topBackRow", hit.topBackRow);
    addFilled(json, world, "filled", hit.filled, false);
    json.EndObject();
}

void addObject(Writer& json, const World& world, const SeenObject& seen) {
    const Object& object = world.maps[static_cast<std::size_t>(seen.map)].objects[static_cast<std::size_t>(seen.object)];
    json.StartObject();
    add(json, "map", mapName(world, seen.map));
    add(json, "portals", seen.portals);
    add(json, "sprite", world.sprites[object.sprite].name);
    addPair(json, "point", object.x.value(), object.y.value());
    add(json, "bottom", object.z.value());
    add(json, "top", (object.z + object.height).value());
    add(json, "width", object.width.value());
    add(json, "depth", seen.depth);
    addRows(json, seen.first, seen.last);
    json.EndObject();
}

void addEnd(Writer& json, const World& world, const char* key, int map, int x, int y) {
    json.Key(key);
    json.StartObject();
    add(json, "map", mapName(world, map));
    addPair(json, "tile", x, y);
    json.EndObject();
}

void addPortal(Writer& json, const World& world, const PassedPortal& passed) {
    const Portal& portal = world.portals[passed.portal];
    json.StartObject();
    add(json, "portals", passed.portals);
    addEnd(json, world, "from", portal.fromMap, portal.fromX, portal.fromY);
    addEnd(json, world, "to", portal.toMap, portal.toX, portal.toY);
    add(json, "turn", 90 * portal.turn);
    add(json, "levels", portal.levels);
    add(json, "depth", passed.depth);
    addRows(json, passed.first, passed.last);
    json.EndObject();
}

void addMirror(Writer& json, const World& world, const MirroredRows& mirror) {
    json.StartObject();
    add(json, "map", mapName(world, mirror.map));
    add(json, "height", mirror.height.value());
    add(json, "strength", mirror.strength);
    addRows(json, mirror.first, mirror.last);
    json.EndObject();
}

template <typename Thing>
void addAll(Writer& json, const World& world, const char* key, const std::vector<Thing>& things, void (*addOne)(Writer&, const World&, const Thing&)) {
    json.Key(key);
    json.StartArray();
    for (const Thing& thing : things) addOne(json, world, thing);
    json.EndArray();
}

}  // namespace

std::string hitsJson(Session& session, const std::string& sceneName, int width, int height, int column) {
    const World& world = session.world();
    const Eye eye = session.eye();
    const SliceTrace trace = session.trace(width, height, column);

    rapidjson::StringBuffer text;
    Writer json(text);
    json.SetIndent(' ', 2);
    json.StartObject();
    add(json, "scene", sceneName);
    add(json, "map", mapName(world, eye.map));
    addPair(json, "size", width, height);
    add(json, "column", trace.column);
    json.Key("eye");
    json.StartObject();
    add(json, "x", eye.x.value());
    add(json, "y", eye.y.value());
    add(json, "z", eye.z.value());
    add(json, "heading", eye.headingDegrees);
    add(json, "look", eye.look);
    json.EndObject();
    add(json, "fov", session.options().render.fovDegrees);
    add(json, "horizonRow", trace.horizonRow);
    add(json, "projectionDistance", trace.projectionDistance);
    addPair(json, "ray", trace.rayX, trace.rayY);
    addAll(json, world, "tiles", trace.tiles, addTile);
    addAll(json, world, "hits", trace.hits, addHit);
    addFilled(json, world, "planes", trace.planes, true);
    addAll(json, world, "objects", trace.objects, addObject);
    addAll(json, world, "portals", trace.portals, addPortal);
    addAll(json, world, "mirrors", trace.mirrors, addMirror);
    json.EndObject();
    return std::string(text.GetString(), text.GetSize()) + "\n";
}

}  // namespace slicecast

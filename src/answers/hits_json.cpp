#include "answers/hits_json.h"

#include <cstddef>

namespace slicecast {

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
        case FilledRows::What::object:
            return "object";
        case FilledRows::What::haze:
            break;
    }
    return "haze";
}

const char* nameOf(Face face) {
    return kFaceNames[static_cast<std::size_t>(face)];
}

const std::string& mapName(const World& world, int map) {
    return world.maps[static_cast<std::size_t>(map)].name;
}

template <typename Json>
static void writeEnd(Json& json, const World& world, const char* key, int map, int x, int y) {
    json.key(key).beginObject().key("map").text(mapName(world, map));
    json.key("tile").pair(x, y);
    json.endObject();
}

template <typename Json>
void writePortalEnds(Json& json, const World& world, PortalId id, int portalsBefore) {
    const Portal& portal = world.portals[id];
    json.key("portals").number(portalsBefore);
    writeEnd(json, world, "from", portal.fromMap, portal.fromX, portal.fromY);
    writeEnd(json, world, "to", portal.toMap, portal.toX, portal.toY);
    json.key("turn").number(90 * portal.turn).key("levels").number(portal.levels);
}

template <typename Json>
void writeRows(Json& json, int first, int last) {
    json.key("first").number(first).key("last").number(last - 1);
}

template <typename Json>
void writeView(Json& json, const Session& session, const std::string& sceneName, int width,
               int height) {
    const Eye eye = session.eye();
    json.line(1).key("scene").text(sceneName);
    json.line(1).key("map").text(mapName(session.world(), eye.map));
    json.line(1).key("size").pair(width, height);
    json.line(1)
        .key("eye")
        .beginObject()
        .key("x")
        .number(eye.x.value())
        .key("y")
        .number(eye.y.value())
        .key("z")
        .number(eye.z.value());
    json.key("heading").number(eye.headingDegrees).key("look").number(eye.look).endObject();
    json.line(1).key("fov").number(renderOptions(session.options(), width, height).fovDegrees);
}

namespace {

// Planes need no face, because the kind implies it; they name their map, which elsewhere the block
// does.
template <typename Json>
void writeFilled(Json& json, const World& world, const std::vector<FilledRows>& filled,
                 bool arePlanes) {
    json.beginList(filled.size());
    for (const FilledRows& rows : filled) {
        json.beginObject().key("what").text(nameOf(rows.what));
        if (arePlanes) {
            json.key("map").text(mapName(world, rows.map));
        } else {
            json.key("face").text(nameOf(rows.face));
        }
        writeRows(json, rows.first, rows.last);
        json.endObject();
    }
    json.endList();
}

template <typename Json>
void writeWalkedTile(Json& json, const World& world, const WalkedTile& tile) {
    json.beginTuple()
        .number(tile.x)
        .number(tile.y)
        .number(tile.depth)
        .text(mapName(world, tile.map))
        .endArray();
}

template <typename Json>
void writeHit(Json& json, const World& world, const Hit& hit) {
    json.beginObject().key("map").text(mapName(world, hit.map)).key("portals").number(hit.portals);
    json.key("tile").pair(hit.tileX, hit.tileY);
    json.key("level")
        .number(hit.level)
        .key("blueprint")
        .text(world.blueprints[hit.blueprint].name)
        .key("face");
    if (hit.entered) {
        json.text(nameOf(hit.face));
    } else {
        json.null();
    }
    json.key("point").pair(hit.x, hit.y);
    json.key("rawDepth")
        .number(hit.rawDepth)
        .key("depth")
        .number(hit.depth)
        .key("backDepth")
        .number(hit.backDepth);
    json.key("bottom").number(hit.bottom.value()).key("top").number(hit.top.value());
    json.key("bottomFrontRow")
        .number(hit.bottomFrontRow)
        .key("topFrontRow")
        .number(hit.topFrontRow);
    json.key("bottomBackRow").number(hit.bottomBackRow).key("topBackRow").number(hit.topBackRow);
    writeFilled(json.key("filled"), world, hit.filled, false);
    json.endObject();
}

template <typename Json>
void writeObject(Json& json, const World& world, const SeenObject& seen) {
    const Object& object = world.maps[static_cast<std::size_t>(seen.map)]
                               .objects[static_cast<std::size_t>(seen.object)];
    json.beginObject()
        .key("map")
        .text(mapName(world, seen.map))
        .key("portals")
        .number(seen.portals);
    json.key("sprite").text(world.sprites[object.sprite].name);
    json.key("point").pair(object.x.value(), object.y.value());
    json.key("bottom")
        .number(object.z.value())
        .key("top")
        .number((object.z + object.height).value())
        .key("width")
        .number(object.width.value());
    json.key("depth").number(seen.depth);
    writeRows(json, seen.first, seen.last);
    json.endObject();
}

template <typename Json>
void writePortal(Json& json, const World& world, const PassedPortal& passed) {
    json.beginObject();
    writePortalEnds(json, world, passed.portal, passed.portals);
    json.key("depth").number(passed.depth);
    writeRows(json, passed.first, passed.last);
    json.endObject();
}

template <typename Json>
void writeMirror(Json& json, const World& world, const MirroredRows& mirror) {
    json.beginObject()
        .key("map")
        .text(mapName(world, mirror.map))
        .key("height")
        .number(mirror.height.value())
        .key("strength")
        .number(mirror.strength);
    writeRows(json, mirror.first, mirror.last);
    json.endObject();
}

template <typename Json, typename Item>
void writeLines(Json& json, const World& world, const char* key, const std::vector<Item>& items,
                void (*writeOne)(Json&, const World&, const Item&)) {
    json.line(1).key(key).beginList(items.size());
    for (const Item& item : items) writeOne(json.line(2), world, item);
    if (!items.empty()) json.line(1);
    json.endList();
}

}  // namespace

template <typename Json>
void writeHits(Json& json, const Session& session, const SliceTrace& trace) {
    const World& world = session.world();
    json.line(1).key("column").number(trace.column);
    json.line(1).key("horizonRow").number(trace.horizonRow);
    json.line(1).key("projectionDistance").number(trace.projectionDistance);
    json.line(1).key("ray").pair(trace.rayX, trace.rayY);
    writeLines(json, world, "tiles", trace.tiles, writeWalkedTile<Json>);
    writeLines(json, world, "hits", trace.hits, writeHit<Json>);
    writeFilled(json.line(1).key("planes"), world, trace.planes, true);
    writeLines(json, world, "objects", trace.objects, writeObject<Json>);
    writeLines(json, world, "portals", trace.portals, writePortal<Json>);
    writeLines(json, world, "mirrors", trace.mirrors, writeMirror<Json>);
}

template void writeView(JsonText&, const Session&, const std::string&, int, int);
template void writeView(PackedJson&, const Session&, const std::string&, int, int);
template void writeHits(JsonText&, const Session&, const SliceTrace&);
template void writeHits(PackedJson&, const Session&, const SliceTrace&);
template void writeRows(JsonText&, int, int);
template void writeRows(PackedJson&, int, int);
template void writePortalEnds(JsonText&, const World&, PortalId, int);
template void writePortalEnds(PackedJson&, const World&, PortalId, int);

namespace {

template <typename Json>
void writeColumn(Json& json, const Session& session, const std::string& sceneName, int width,
                 int height, const SliceTrace& trace) {
    json.beginObject();
    writeView(json, session, sceneName, width, height);
    writeHits(json, session, trace);
    json.line(0).endObject();
}

}  // namespace

std::string hitsJson(Session& session, const std::string& sceneName, int width, int height,
                     int column) {
    JsonText json;
    writeColumn(json, session, sceneName, width, height, session.trace(width, height, column));
    return json.str() + "\n";
}

void packHits(Session& session, const std::string& sceneName, int width, int height,
              std::span<const int> columns, PackedValues& packed) {
    PackedJson json(packed);
    json.beginList(columns.size());
    const TraceRequest request = {
        .width = width, .height = height, .columns = columns, .reflections = false};
    session.trace(request, [&](const SliceTrace& trace) {
        writeColumn(json, session, sceneName, width, height, trace);
    });
    json.endList();
}

}  // namespace slicecast

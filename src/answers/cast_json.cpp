#include "answers/cast_json.h"

#include "answers/hits_json.h"
#include "base/named.h"

#include <cstddef>

namespace slicecast {
namespace {

using End = CastRay::End;
constexpr Named<End> kEnds[] = {
    {End::block, "block"}, {End::edge, "edge"}, {End::portal, "portal"}, {End::floor, "floor"}};

template <typename Json>
void writeCastTile(Json& json, const World& world, const CastTile& tile) {
    json.beginObject().key("map").text(mapName(world, tile.map));
    json.key("portals").number(tile.portals);
    json.key("tile").pair(tile.x, tile.y);
    json.key("axis");
    if (tile.entered) {
        json.text(tile.alongX ? "x" : "y");
    } else {
        json.null();
    }
    json.key("distance").number(tile.distance);
    json.key("next").pair(tile.nextX, tile.nextY);
    json.endObject();
}

template <typename Json>
void writeCastHit(Json& json, const World& world, const CastHit& hit) {
    json.beginObject().key("map").text(mapName(world, hit.map)).key("portals").number(hit.portals);
    json.key("tile").pair(hit.tileX, hit.tileY);
    json.key("level").number(hit.level);
    json.key("blueprint").text(world.blueprints[hit.blueprint].name).key("face");
    if (hit.entered) {
        json.text(nameOf(hit.face));
    } else {
        json.null();
    }
    json.key("point").pair(hit.x, hit.y);
    json.key("distance").number(hit.distance).key("backDistance").number(hit.backDistance);
    json.key("bottom").number(hit.bottom.value()).key("top").number(hit.top.value());
    json.endObject();
}

template <typename Json>
void writeCastPortal(Json& json, const World& world, const CastPortal& passed) {
    json.beginObject();
    writePortalEnds(json, world, passed.portal, passed.portals);
    json.key("distance").number(passed.distance).endObject();
}

template <typename Json, typename Item>
void writeList(Json& json, const World& world, const char* key, const std::vector<Item>& items,
               void (*writeOne)(Json&, const World&, const Item&)) {
    json.key(key).beginList(items.size());
    for (const Item& item : items) writeOne(json, world, item);
    json.endList();
}

}  // namespace

template <typename Json>
void writeCast(Json& json, const World& world, const CastFrom& from) {
    const CastRay ray = cast(world, from);
    json.beginObject().key("map").text(mapName(world, from.map));
    json.key("x").number(from.x.value()).key("y").number(from.y.value()).key("z");
    if (from.z) {
        json.number(from.z->value());
    } else {
        json.null();
    }
    json.key("heading").number(from.headingDegrees);
    json.key("ray").pair(ray.direction.x, ray.direction.y);
    writeList(json, world, "tiles", ray.tiles, writeCastTile<Json>);
    writeList(json, world, "hits", ray.hits, writeCastHit<Json>);
    writeList(json, world, "portals", ray.portals, writeCastPortal<Json>);
    json.key("end").beginObject().key("why").text(nameOf(kEnds, ray.end));
    json.key("map").text(mapName(world, ray.map));
    json.key("point").pair(ray.x, ray.y);
    json.key("distance").number(ray.distance).endObject().endObject();
}

template void writeCast(JsonText&, const World&, const CastFrom&);
template void writeCast(PackedJson&, const World&, const CastFrom&);

}  // namespace slicecast

#include "answers/pick.h"

#include "answers/hits_json.h"
#include "answers/trace_json.h"
#include "render/view/projection.h"

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

using What = FilledRows::What;

int alphaOf(const World& world, const FilledRows& rows, const TracedTexel& texel) {
    const auto detail = static_cast<std::size_t>(texel.detail);
    Pixel pixel{};
    if (rows.what == What::object) {
        const SpriteLevel& level =
            world.sprites[rows.texture].levelsAt(world.steps, rows.side)[detail];
        pixel = level.texels[static_cast<std::size_t>(texel.u * level.height + texel.v)];
    } else {
        const Texture& texture = world.textures[rows.texture];
        const TextureLevel& level = texture.levelsOf(texture.frameAt(world.steps))[detail];
        pixel = level.texels[static_cast<std::size_t>((texel.u << level.bits) + texel.v)];
    }
    return toColour(pixel).a;
}

bool isMirrored(const SliceTrace& trace) {
    return std::any_of(trace.mirrors.begin(), trace.mirrors.end(), [&](const MirroredRows& mirror) {
        return mirror.first <= trace.watchedRow && trace.watchedRow < mirror.last;
    });
}

}  // namespace

// #region nearest
SeenThing nearestSeen(const World& world, const SliceTrace& trace) {
    SeenThing picked;
    for (const SeenPoint& point : trace.seen) {
        const FilledRows& rows = trace.filled[static_cast<std::size_t>(point.run)];
        const bool hasTexture = rows.texture != kNoTexture;
        // A mirror's texels count as opaque.
        const bool isOpaque = !hasTexture || (!rows.layer && isMirrored(trace));
        picked = {&rows, &point, isOpaque ? 255 : alphaOf(world, rows, point.texel), false};
        if (picked.alpha > 0) return picked;
    }
    picked.isHole = true;
    return picked;
}
// #endregion

bool isThing(const SeenThing& seen) {
    return seen.rows->texture != kNoTexture && !seen.isHole;
}

const SliceTrace* reflectionAt(const SliceTrace& trace, const SeenThing& picked) {
    const bool isSeen = isThing(picked) && !picked.rows->layer && isMirrored(trace) &&
                        !trace.reflection.empty() && !trace.reflection[0].seen.empty();
    return isSeen ? &trace.reflection[0] : nullptr;
}

double heightOf(const World& world, const SliceTrace& trace, const FilledRows& rows, double z) {
    const bool isSloped =
        rows.hit >= 0 && !world.blueprints[trace.hits[static_cast<std::size_t>(rows.hit)].blueprint]
                              .slopes.of(rows.face)
                              .isLevel();
    switch (isSloped ? What::side : rows.what) {
        case What::roof:
            return trace.hits[static_cast<std::size_t>(rows.hit)].top.value();
        case What::underside:
            return trace.hits[static_cast<std::size_t>(rows.hit)].bottom.value();
        case What::floor:
            return 0.0;
        case What::ceiling:
            return world.maps[static_cast<std::size_t>(rows.map)].ceiling.height.value();
        default:
            return z;
    }
}

namespace {

template <typename Json>
void writeSeenTile(Json& json, const SliceTrace& trace, const SeenThing& picked) {
    const FilledRows& rows = *picked.rows;
    if (rows.hit >= 0) {
        const Hit& hit = trace.hits[static_cast<std::size_t>(rows.hit)];
        json.key("tile").pair(hit.tileX, hit.tileY);
    } else if (rows.what == What::floor || rows.what == What::ceiling) {
        json.key("tile").pair(std::floor(picked.point->x), std::floor(picked.point->y));
    } else {
        json.key("tile").null();
    }
}

template <typename Json>
void writeSeen(Json& json, const World& world, const SliceTrace& trace, int column) {
    const SeenThing picked = nearestSeen(world, trace);
    const FilledRows& rows = *picked.rows;
    const SeenPoint& point = *picked.point;
    json.beginObject().key("column").number(column).key("row").number(trace.watchedRow);
    json.key("what").text(nameOf(picked.isHole ? What::haze : rows.what));
    json.key("map").text(mapName(world, rows.map)).key("portals").number(rows.portals);
    writeSeenTile(json, trace, picked);
    if (rows.hit >= 0) {
        const Hit& hit = trace.hits[static_cast<std::size_t>(rows.hit)];
        json.key("level").number(hit.level);
        json.key("blueprint").text(world.blueprints[hit.blueprint].name);
        json.key("face").text(nameOf(rows.face));
    } else {
        json.key("level").null().key("blueprint").null().key("face").null();
    }
    json.key("object");
    if (rows.object >= 0) {
        json.number(trace.objects[static_cast<std::size_t>(rows.object)].object);
    } else {
        json.null();
    }
    json.key("texture");
    if (isThing(picked)) {
        json.text(textureName(world, rows));
        json.key("point").beginTuple().number(point.x).number(point.y);
        json.number(heightOf(world, trace, rows, point.z)).endArray();
        json.key("depth").number(point.texel.depth).key("texel");
        writeTexel(json, world, rows, point.texel, trace.watchedRow);
        json.key("alpha").number(picked.alpha);
    } else {
        json.null().key("point").null().key("depth").null().key("texel").null();
        json.key("alpha").number(255);
    }
    json.key("reflection");
    if (const SliceTrace* const reflection = reflectionAt(trace, picked)) {
        writeSeen(json, world, *reflection, column);
    } else {
        json.null();
    }
    json.endObject();
}

}  // namespace

template <typename Json>
void writePick(Json& json, Session& session, int width, int height, int column, int row) {
    writeSeen(json, session.world(), session.trace(width, height, column, row), column);
}

template void writePick(JsonText&, Session&, int, int, int, int);
template void writePick(PackedJson&, Session&, int, int, int, int);

std::optional<PicturePoint> project(const Session& session, const Eye& eye, const Place& place,
                                    int map, int width, int height) {
    if (map != eye.map) return std::nullopt;
    const Projection projection(eye, renderOptions(session.options(), width, height), width,
                                height);
    const double east = place.x - eye.x.value();
    const double south = place.y - eye.y.value();
    const double depth = east * projection.forward.x + south * projection.forward.y;
    if (!(depth > 0.0)) return std::nullopt;
    const double sideways = east * projection.right.x + south * projection.right.y;
    return PicturePoint{width / 2.0 + sideways * projection.distance / depth,
                        projection.rowOf(place.z - eye.z.value(), depth), depth};
}

}  // namespace slicecast

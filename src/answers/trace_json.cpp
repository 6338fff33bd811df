#include "answers/trace_json.h"

#include "answers/frame_trace.h"
#include "answers/hits_json.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

using What = FilledRows::What;
constexpr std::size_t kWhats = FilledRows::kWhats;

constexpr auto kKinds = std::to_array<What>({What::side, What::roof, What::underside, What::floor,
                                             What::ceiling, What::sky, What::haze, What::object});
static_assert(kKinds.size() == kWhats && kKinds.back() == What{kWhats - 1},
              "must be in the order of What, and whole");

bool hasTexture(const FilledRows& rows) {
    return rows.texture != kNoTexture;
}

template <typename Json>
void writeIndex(Json& json, const char* key, int index) {
    json.key(key);
    if (index < 0) {
        json.null();
    } else {
        json.number(index);
    }
}

template <typename Json>
void writeTracedTile(Json& json, const World& world, const WalkedTile& tile,
                     double projectionDistance) {
    json.beginObject()
        .key("map")
        .text(mapName(world, tile.map))
        .key("portals")
        .number(tile.portals);
    json.key("tile").pair(tile.x, tile.y);
    json.key("axis");
    if (tile.entered) {
        json.text(tile.alongX ? "x" : "y");
    } else {
        json.null();
    }
    json.key("distance").number(tile.distance).key("speed").number(tile.speed);
    json.key("along").number(tile.along).key("depth").number(tile.along * projectionDistance);
    json.key("next").pair(tile.nextX, tile.nextY);
    json.endObject();
}

}  // namespace

const std::string& textureName(const World& world, const FilledRows& rows) {
    return rows.what == What::object ? world.sprites[rows.texture].name
                                     : world.textures[rows.texture].name;
}

TexelSize sizeOfDetail(const World& world, const FilledRows& rows, int detail) {
    const auto index = static_cast<std::size_t>(detail);
    if (rows.what == What::object) {
        const SpriteLevel& level = world.sprites[rows.texture].frames[0][index];
        return {level.width, level.height};
    }
    const int side = world.textures[rows.texture].levels[index].size;
    return {side, side};
}

template <typename Json>
void writeTexel(Json& json, const World& world, const FilledRows& rows, const TracedTexel& texel,
                int row) {
    const TexelSize size = sizeOfDetail(world, rows, texel.detail);
    json.beginObject()
        .key("row")
        .number(row)
        .key("depth")
        .number(texel.depth)
        .key("detail")
        .number(texel.detail);
    json.key("size").pair(size.width, size.height);
    json.key("u")
        .number(texel.u)
        .key("v")
        .number(texel.v)
        .key("baked")
        .beginTuple()
        .number(texel.baked[0])
        .number(texel.baked[1])
        .number(texel.baked[2])
        .endArray()
        .key("light")
        .number(texel.light)
        .key("fog")
        .number(texel.fog)
        .endObject();
}

template void writeTexel(JsonText&, const World&, const FilledRows&, const TracedTexel&, int);
template void writeTexel(PackedJson&, const World&, const FilledRows&, const TracedTexel&, int);

namespace {

template <typename Json>
void writeRun(Json& json, const World& world, const FilledRows& rows) {
    json.beginObject()
        .key("what")
        .text(nameOf(rows.what))
        .key("map")
        .text(mapName(world, rows.map))
        .key("portals")
        .number(rows.portals);
    writeIndex(json, "hit", rows.hit);
    writeIndex(json, "object", rows.object);
    json.key("face");
    if (rows.hit >= 0) {
        json.text(nameOf(rows.face));
    } else {
        json.null();
    }
    json.key("texture");
    if (hasTexture(rows)) {
        json.text(textureName(world, rows));
    } else {
        json.null();
    }
    writeRows(json, rows.first, rows.last);
    json.key("layer").yesNo(rows.layer);
    json.key("texels").beginList(hasTexture(rows) ? 2 : 0);
    if (hasTexture(rows)) {
        writeTexel(json, world, rows, rows.top, rows.first);
        writeTexel(json, world, rows, rows.bottom, rows.last - 1);
    }
    json.endList().endObject();
}

template <typename Json>
void writeSlice(Json& json, const Session& session, const SliceTrace& trace) {
    writeHits(json, session, trace);
    json.line(1).key("walk").beginList(trace.tiles.size());
    for (const WalkedTile& tile : trace.tiles)
        writeTracedTile(json.line(2), session.world(), tile, trace.projectionDistance);
    json.endList().line(1).key("runs").beginList(trace.filled.size());
    for (const FilledRows& rows : trace.filled) writeRun(json.line(2), session.world(), rows);
    json.endList();
}

// Writes one number for each column.
template <typename Number>
void writeColumns(JsonText& json, const char* key, const FrameTrace& frame, Number numberOf) {
    json.line(2).key(key).beginArray();
    for (const ColumnSums& column : frame.columns) json.number(numberOf(column));
    json.endArray();
}

void writeNumbers(JsonText& json, const char* key,
                  std::initializer_list<std::pair<const char*, double>> numbers) {
    json.line(1).key(key).beginObject();
    for (const auto& [name, number] : numbers) json.key(name).number(number);
    json.endObject();
}

void writeTextures(JsonText& json, const FrameTrace& frame) {
    json.line(1).key("textures").beginArray();
    for (const TextureUse& use : frame.textures) {
        json.line(2).beginObject().key("name").text(use.name);
        json.key("kind").text(use.isSprite ? "sprite" : "texture").key("texels").beginArray();
        for (const std::int64_t rows : use.rows) json.number(static_cast<double>(rows));
        json.endArray().endObject();
    }
    json.endArray();
}

template <typename Json>
void writeTrace(Json& json, const Session& session, const std::string& sceneName, int width,
                int height, const SliceTrace& trace) {
    json.beginObject();
    writeView(json, session, sceneName, width, height);
    writeSlice(json, session, trace);
    json.line(1).key("reflection");
    if (trace.reflection.empty()) {
        json.null();
    } else {
        json.beginObject();
        writeSlice(json, session, trace.reflection[0]);
        json.endObject();
    }
    json.line(0).endObject();
}

}  // namespace

std::string traceJson(Session& session, const std::string& sceneName, int width, int height,
                      int column) {
    JsonText json;
    writeTrace(json, session, sceneName, width, height, session.trace(width, height, column));
    return json.str() + "\n";
}

void packTraces(Session& session, const std::string& sceneName, int width, int height,
                std::span<const int> columns, PackedValues& packed) {
    PackedJson json(packed);
    json.beginList(columns.size());
    session.trace({width, height, columns}, [&](const SliceTrace& trace) {
        writeTrace(json, session, sceneName, width, height, trace);
    });
    json.endList();
}

std::string frameTraceJson(Session& session, const std::string& sceneName, int width, int height) {
    const FrameTrace frame = frameTrace(session, width, height);
    JsonText json;
    json.beginObject();
    writeView(json, session, sceneName, width, height);
    json.line(1).key("horizonRow").number(frame.horizonRow);
    json.line(1).key("projectionDistance").number(frame.projectionDistance);
    const auto number = [](std::int64_t whole) { return static_cast<double>(whole); };
    writeNumbers(json, "totals",
                 {{"tilesWalked", number(frame.tilesWalked)},
                  {"blocksMet", number(frame.blocksMet)},
                  {"spansDrawn", number(frame.spansDrawn)},
                  {"rowsFilled", number(frame.rowsFilled)},
                  {"layers", number(frame.layers)},
                  {"objectSlices", number(frame.objectSlices)},
                  {"walksBehindPortals", number(frame.walksBehindPortals)},
                  {"deepestPortal", number(frame.deepestPortal)},
                  {"mirroredRows", number(frame.mirroredRows)}});
    if (const ProcessTimes* times = session.times()) {
        writeNumbers(json, "times",
                     {{"framesPerSecond", times->framesPerSecond},
                      {"stepMilliseconds", times->stepMilliseconds},
                      {"viewMilliseconds", times->viewMilliseconds},
                      {"overlayMilliseconds", times->overlayMilliseconds}});
    } else {
        json.line(1).key("times").null();
    }
    writeTextures(json, frame);
    json.line(1).key("columns").beginObject();
    using Column = const ColumnSums&;
    writeColumns(json, "nearest", frame, [](Column column) { return column.nearest; });
    writeColumns(json, "tiles", frame, [](Column column) { return column.tiles; });
    writeColumns(json, "hits", frame, [](Column column) { return column.hits; });
    json.line(2).key("rows").beginObject();
    for (const What what : kKinds) {
        writeColumns(json, nameOf(what), frame,
                     [what](Column column) { return column.rows[static_cast<std::size_t>(what)]; });
    }
    json.endObject();
    writeColumns(json, "layers", frame, [](Column column) { return column.layers; });
    return json.endObject().line(0).endObject().str() + "\n";
}

}  // namespace slicecast

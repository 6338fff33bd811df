#include "session/trace_json.h"

#include "session/hits_json.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
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

const std::string& textureName(const World& world, bool isSprite, std::size_t texture) {
    return isSprite ? world.sprites[texture].name : world.textures[texture].name;
}

}  // namespace

const std::string& textureName(const World& world, const FilledRows& rows) {
    return textureName(world, rows.what == What::object, rows.texture);
}

template <typename Json>
void writeTexel(Json& json, const World& world, const FilledRows& rows, const TracedTexel& texel,
                int row) {
    const auto detail = static_cast<std::size_t>(texel.detail);
    json.beginObject()
        .key("row")
        .number(row)
        .key("depth")
        .number(texel.depth)
        .key("detail")
        .number(texel.detail);
    if (rows.what == What::object) {
        const SpriteLevel& level = world.sprites[rows.texture].frames[0][detail];
        json.key("size").pair(level.width, level.height);
    } else {
        const TextureLevel& level = world.textures[rows.texture].levels[detail];
        json.key("size").pair(level.size, level.size);
    }
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
void writeColumns(JsonText& json, const char* key, const std::vector<double>& numbers) {
    json.line(2).key(key).beginArray();
    for (const double number : numbers) json.number(number);
    json.endArray();
}

void writeNumbers(JsonText& json, const char* key,
                  std::initializer_list<std::pair<const char*, double>> numbers) {
    json.line(1).key(key).beginObject();
    for (const auto& [name, number] : numbers) json.key(name).number(number);
    json.endObject();
}

// Sums over all columns of a picture.
struct Sums {
    explicit Sums(int width)
        : nearest(static_cast<std::size_t>(width), std::numeric_limits<double>::infinity()),
          tiles(nearest.size()),
          hits(tiles),
          layers(tiles) {
        rows.fill(tiles);
    }

    void add(const SliceTrace& trace) {
        const auto column = static_cast<std::size_t>(trace.column);
        tiles[column] = static_cast<double>(trace.tiles.size());
        hits[column] = static_cast<double>(trace.hits.size());
        for (const FilledRows& run : trace.filled) {
            (run.layer ? layers : rows[static_cast<std::size_t>(run.what)])[column] +=
                run.last - run.first;
            if (run.hit >= 0 || run.object >= 0)
                nearest[column] = std::min({nearest[column], run.top.depth, run.bottom.depth});
            if (!hasTexture(run)) continue;
            auto& ofKind = texels[run.what == What::object ? 1 : 0];
            if (ofKind.size() <= run.texture) ofKind.resize(run.texture + std::size_t{1});
            for (std::size_t m = 0; m < kMostDetails; ++m)
                ofKind[run.texture][m] += run.rowsOfDetail[m];
        }
    }

    std::vector<double> nearest;
    std::vector<double> tiles;
    std::vector<double> hits;
    std::vector<double> layers;
    std::array<std::vector<double>, kKinds.size()> rows;
    std::array<std::vector<std::array<std::int64_t, kMostDetails>>, 2>
        texels;  // by texture and sprite
};

void writeTextures(JsonText& json, const World& world, const Sums& sums) {
    json.line(1).key("textures").beginArray();
    for (const bool isSprite : {false, true}) {
        const auto& texels = sums.texels[isSprite ? 1 : 0];
        for (std::size_t i = 0; i < texels.size(); ++i) {
            std::size_t levelCount = kMostDetails;
            while (levelCount > 0 && texels[i][levelCount - 1] == 0) --levelCount;
            if (levelCount == 0) continue;
            json.line(2)
                .beginObject()
                .key("name")
                .text(textureName(world, isSprite, i))
                .key("kind")
                .text(isSprite ? "sprite" : "texture");
            json.key("texels").beginArray();
            for (std::size_t m = 0; m < levelCount; ++m)
                json.number(static_cast<double>(texels[i][m]));
            json.endArray().endObject();
        }
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
    const FrameReport report = session.measure(width, height);
    Sums sums(width);
    std::vector<int> columns(static_cast<std::size_t>(width));
    for (int column = 0; column < width; ++column)
        columns[static_cast<std::size_t>(column)] = column;
    double horizonRow = 0.0;
    double projectionDistance = 0.0;
    const TraceRequest request = {
        .width = width, .height = height, .columns = columns, .reflections = false};
    session.trace(request, [&](const SliceTrace& slice) {
        sums.add(slice);
        horizonRow = slice.horizonRow;
        projectionDistance = slice.projectionDistance;
    });

    JsonText json;
    json.beginObject();
    writeView(json, session, sceneName, width, height);
    json.line(1)
        .key("horizonRow")
        .number(horizonRow)
        .line(1)
        .key("projectionDistance")
        .number(projectionDistance);
    const auto number = [](std::int64_t whole) { return static_cast<double>(whole); };
    writeNumbers(json, "totals",
                 {{"tilesWalked", number(report.tilesWalked)},
                  {"blocksMet", number(report.blocksMet)},
                  {"spansDrawn", number(report.spansDrawn)},
                  {"rowsFilled", number(report.rowsFilled)},
                  {"layers", number(report.layers)},
                  {"objectSlices", number(report.objectSlices)},
                  {"walksBehindPortals", number(report.partsBehindPortals)},
                  {"deepestPortal", number(report.deepestPortal)},
                  {"mirroredRows", number(report.mirroredRows)}});
    if (const ProcessTimes* times = session.times()) {
        writeNumbers(json, "times",
                     {{"framesPerSecond", times->framesPerSecond},
                      {"stepMilliseconds", times->stepMilliseconds},
                      {"viewMilliseconds", times->viewMilliseconds},
                      {"overlayMilliseconds", times->overlayMilliseconds}});
    } else {
        json.line(1).key("times").null();
    }
    writeTextures(json, session.world(), sums);
    json.line(1).key("columns").beginObject();
    writeColumns(json, "nearest", sums.nearest);
    writeColumns(json, "tiles", sums.tiles);
    writeColumns(json, "hits", sums.hits);
    json.line(2).key("rows").beginObject();
    for (const What what : kKinds)
        writeColumns(json, nameOf(what), sums.rows[static_cast<std::size_t>(what)]);
    json.endObject();
    writeColumns(json, "layers", sums.layers);
    return json.endObject().line(0).endObject().str() + "\n";
}

}  // namespace slicecast

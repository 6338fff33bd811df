// What a Game tells about its cells, rays and pixels.
#include "answers/frame_trace.h"
#include "answers/pick.h"
#include "answers/trace_json.h"
#include "library/game_state.h"
#include "render/ask/cast.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace slicecast {
namespace {

using What = FilledRows::What;

// Seen and RayEnd have the engine's order.
static_assert(static_cast<int>(Seen::side) == static_cast<int>(What::side) &&
              static_cast<int>(Seen::roof) == static_cast<int>(What::roof) &&
              static_cast<int>(Seen::underside) == static_cast<int>(What::underside) &&
              static_cast<int>(Seen::floor) == static_cast<int>(What::floor) &&
              static_cast<int>(Seen::ceiling) == static_cast<int>(What::ceiling) &&
              static_cast<int>(Seen::sky) == static_cast<int>(What::sky) &&
              static_cast<int>(Seen::haze) == static_cast<int>(What::haze) &&
              static_cast<int>(Seen::object) == static_cast<int>(What::object) &&
              kSeenKinds == static_cast<int>(FilledRows::kWhats));
static_assert(static_cast<int>(RayEnd::block) == static_cast<int>(CastRay::End::block) &&
              static_cast<int>(RayEnd::edge) == static_cast<int>(CastRay::End::edge) &&
              static_cast<int>(RayEnd::portal) == static_cast<int>(CastRay::End::portal) &&
              static_cast<int>(RayEnd::floor) == static_cast<int>(CastRay::End::floor));

// ---- Columns

ColumnHit toColumnHit(const World& world, const Hit& hit) {
    ColumnHit column = {.map = hit.map,
                        .portals = hit.portals,
                        .tileX = hit.tileX,
                        .tileY = hit.tileY,
                        .level = hit.level,
                        .block = world.blueprints[hit.blueprint].name,
                        .face = hit.entered ? std::optional(hit.face) : std::nullopt,
                        .x = hit.x,
                        .y = hit.y,
                        .distance = hit.rawDepth,
                        .depth = hit.depth,
                        .backDepth = hit.backDepth,
                        .bottom = hit.bottom.value(),
                        .top = hit.top.value(),
                        .topFrontRow = hit.topFrontRow,
                        .bottomFrontRow = hit.bottomFrontRow,
                        .topBackRow = hit.topBackRow,
                        .bottomBackRow = hit.bottomBackRow,
                        .rows = {}};
    for (const FilledRows& rows : hit.filled) column.rows.push_back({rows.first, rows.last});
    return column;
}

ColumnTile toColumnTile(const WalkedTile& tile, double projectionDistance) {
    return {.map = tile.map,
            .portals = tile.portals,
            .x = tile.x,
            .y = tile.y,
            .entered = tile.entered,
            .alongX = tile.alongX,
            .distance = tile.distance,
            .speed = tile.speed,
            .along = tile.along,
            .depth = tile.along * projectionDistance,
            .nextX = tile.nextX,
            .nextY = tile.nextY};
}

Texel toTexel(const World& world, const FilledRows& rows, const TracedTexel& texel, int row) {
    const TexelSize size = sizeOfDetail(world, rows, texel.detail);
    return {.row = row,
            .depth = texel.depth,
            .detail = texel.detail,
            .width = size.width,
            .height = size.height,
            .u = texel.u,
            .v = texel.v,
            .baked = {texel.baked[0], texel.baked[1], texel.baked[2]},
            .light = static_cast<int>(texel.light),
            .fog = static_cast<int>(texel.fog)};
}

ColumnRun toColumnRun(const World& world, const FilledRows& rows) {
    ColumnRun run = {.what = static_cast<Seen>(rows.what),
                     .map = rows.map,
                     .portals = rows.portals,
                     .hit = rows.hit,
                     .object = rows.object,
                     .face = rows.hit >= 0 ? std::optional(rows.face) : std::nullopt,
                     .texture = {},
                     .rows = {rows.first, rows.last},
                     .isLayer = rows.layer,
                     .first = {},
                     .last = {}};
    if (rows.texture == kNoTexture) return run;
    run.texture = textureName(world, rows);
    run.first = toTexel(world, rows, rows.top, rows.first);
    run.last = toTexel(world, rows, rows.bottom, rows.last - 1);
    return run;
}

ColumnObject toColumnObject(const World& world, const SeenObject& seen) {
    const Object& object = world.maps[static_cast<std::size_t>(seen.map)]
                               .objects[static_cast<std::size_t>(seen.object)];
    return {.map = seen.map,
            .portals = seen.portals,
            .object = seen.object,
            .sprite = world.sprites[object.sprite].name,
            .x = object.x.value(),
            .y = object.y.value(),
            .bottom = object.z.value(),
            .top = (object.z + object.height).value(),
            .width = object.width.value(),
            .depth = seen.depth,
            .rows = {seen.first, seen.last}};
}

PortalEnds toPortalEnds(const World& world, PortalId id, int portals) {
    const Portal& portal = world.portals[id];
    return {.portals = portals,
            .fromMap = portal.fromMap,
            .fromX = portal.fromX,
            .fromY = portal.fromY,
            .toMap = portal.toMap,
            .toX = portal.toX,
            .toY = portal.toY,
            .turnDegrees = 90 * portal.turn,
            .levels = portal.levels};
}

ColumnTrace toColumnTrace(const World& world, const SliceTrace& slice, int column) {
    ColumnTrace trace;
    trace.column = column;
    trace.rayX = slice.rayX;
    trace.rayY = slice.rayY;
    trace.horizonRow = slice.horizonRow;
    trace.projectionDistance = slice.projectionDistance;
    for (const WalkedTile& tile : slice.tiles)
        trace.tiles.push_back(toColumnTile(tile, slice.projectionDistance));
    for (const Hit& hit : slice.hits) trace.hits.push_back(toColumnHit(world, hit));
    for (const FilledRows& rows : slice.filled) trace.runs.push_back(toColumnRun(world, rows));
    for (const SeenObject& seen : slice.objects)
        trace.objects.push_back(toColumnObject(world, seen));
    for (const PassedPortal& passed : slice.portals) {
        trace.portals.push_back({toPortalEnds(world, passed.portal, passed.portals),
                                 passed.depth,
                                 {passed.first, passed.last}});
    }
    for (const MirroredRows& rows : slice.mirrors) {
        trace.mirrors.push_back(
            {rows.map, rows.height.value(), rows.strength, {rows.first, rows.last}});
    }
    for (const SliceTrace& reflection : slice.reflection)
        trace.reflection.push_back(toColumnTrace(world, reflection, column));
    return trace;
}

// ---- Pixels

Pick toPick(const World& world, const SliceTrace& trace) {
    const SeenThing seen = nearestSeen(world, trace);
    const FilledRows& rows = *seen.rows;
    Pick pick;
    pick.what = seen.isHole ? Seen::haze : static_cast<Seen>(rows.what);
    pick.map = rows.map;
    pick.portals = rows.portals;
    pick.depth = std::numeric_limits<double>::infinity();
    if (rows.hit >= 0) {
        const Hit& hit = trace.hits[static_cast<std::size_t>(rows.hit)];
        pick.face = rows.face;
        pick.tileX = hit.tileX;
        pick.tileY = hit.tileY;
        pick.level = hit.level;
        pick.block = world.blueprints[hit.blueprint].name;
    } else if (rows.what == What::floor || rows.what == What::ceiling) {
        pick.tileX = static_cast<int>(std::floor(seen.point->x));
        pick.tileY = static_cast<int>(std::floor(seen.point->y));
    }
    if (rows.object >= 0) pick.object = trace.objects[static_cast<std::size_t>(rows.object)].object;
    if (!isThing(seen)) return pick;
    pick.texture = textureName(world, rows);
    pick.x = seen.point->x;
    pick.y = seen.point->y;
    pick.z = heightOf(world, trace, rows, seen.point->z);
    pick.depth = seen.point->texel.depth;
    pick.texel = toTexel(world, rows, seen.point->texel, trace.watchedRow);
    pick.alpha = seen.alpha;
    if (const SliceTrace* const reflection = reflectionAt(trace, seen))
        pick.reflection.push_back(toPick(world, *reflection));
    return pick;
}

// ---- Rays

RayTile toRayTile(const CastTile& tile) {
    return {.map = tile.map,
            .portals = tile.portals,
            .x = tile.x,
            .y = tile.y,
            .entered = tile.entered,
            .alongX = tile.alongX,
            .distance = tile.distance,
            .nextX = tile.nextX,
            .nextY = tile.nextY};
}

RayHit toRayHit(const World& world, const CastHit& hit) {
    return {.map = hit.map,
            .portals = hit.portals,
            .tileX = hit.tileX,
            .tileY = hit.tileY,
            .level = hit.level,
            .block = world.blueprints[hit.blueprint].name,
            .face = hit.entered ? std::optional(hit.face) : std::nullopt,
            .x = hit.x,
            .y = hit.y,
            .distance = hit.distance,
            .backDistance = hit.backDistance,
            .bottom = hit.bottom.value(),
            .top = hit.top.value()};
}

// ---- Blocks

FaceLook toFaceLook(const World& world, const FaceBlueprint& face) {
    FaceLook look = {.texture = {},
                     .colour = {},
                     .light = face.light,
                     .glows = face.glow,
                     .mirror = face.mirror / 255.0};
    if (face.texture == kNoTexture) return look;
    const Texture& texture = world.textures[face.texture];
    look.texture = texture.name;
    look.colour = averageColour(texture);
    return look;
}

Blueprint toBlueprint(const World& world, const LegendEntry& entry) {
    const CellBlueprint& block = world.blueprints[entry.blueprint];
    Blueprint blueprint;
    blueprint.sign = entry.sign;
    blueprint.name = block.name;
    blueprint.bottom = block.bottom.value();
    blueprint.top = block.top.value();
    if (block.slopes.any()) {
        const Slopes& slopes = block.slopes;
        blueprint.slopes = {.alongX = slopes.alongX,
                            .bottom = {slopes.bottom.from.value(), slopes.bottom.to.value()},
                            .top = {slopes.top.from.value(), slopes.top.to.value()}};
    }
    blueprint.west = block.plan.west.value();
    blueprint.north = block.plan.north.value();
    blueprint.east = block.plan.east.value();
    blueprint.south = block.plan.south.value();
    blueprint.diagonal = block.plan.half;
    blueprint.isSeeThrough = block.seeThrough;
    blueprint.moves = block.motion >= 0;
    blueprint.isGate = block.gate >= 0;
    for (int face = 0; face < kFaces; ++face) {
        blueprint.faces[static_cast<std::size_t>(face)] =
            toFaceLook(world, block.face(static_cast<Face>(face)));
    }
    return blueprint;
}

}  // namespace

std::vector<std::vector<std::string>> Game::cells(int map) const {
    std::vector<std::vector<std::string>> levels;
    if (!state_->hasMap(map)) return levels;
    const World& world = state_->session.world();
    const Map& place = world.maps[static_cast<std::size_t>(map)];
    levels.resize(static_cast<std::size_t>(place.levels));
    for (int level = 0; level < place.levels; ++level) {
        for (int y = 0; y < place.depth; ++y)
            levels[static_cast<std::size_t>(level)].push_back(cellRow(world, map, level, y));
    }
    return levels;
}

std::string Game::cell(int map, int level, int x, int y) const {
    if (!state_->hasMap(map)) return {};
    const World& world = state_->session.world();
    const Map& place = world.maps[static_cast<std::size_t>(map)];
    const bool exists = level >= 0 && level < place.levels && x >= 0 && x < place.width && y >= 0 &&
                        y < place.depth;
    return exists ? std::string(signAt(world, {map, level, x, y})) : std::string();
}

std::string Game::setCell(int map, int level, int x, int y, std::string_view sign) {
    return state_->session.setCell({map, level, x, y}, sign);
}

std::string Game::setCells(int map, std::span<const CellChange> changes) {
    return state_->session.setCells(map, changes);
}

bool Game::mark(std::span<const Mark> lines) {
    if (lines.size() > kMostMarks) return false;
    const auto isWithin = [](const Place& place) {
        return std::abs(place.x) <= kCoordinateLimit && std::abs(place.y) <= kCoordinateLimit &&
               std::abs(place.z) <= kCoordinateLimit;
    };
    for (const Mark& line : lines)
        if (!state_->hasMap(line.map) || !isWithin(line.from) || !isWithin(line.to)) return false;
    state_->session.setMarks({lines.begin(), lines.end()});
    return true;
}

std::vector<Blueprint> Game::blueprints(int map) const {
    std::vector<Blueprint> list;
    if (!state_->hasMap(map)) return list;
    const World& world = state_->session.world();
    for (const LegendEntry& entry : world.maps[static_cast<std::size_t>(map)].legend)
        list.push_back(toBlueprint(world, entry));
    return list;
}

std::vector<ColumnHit> Game::hits(int width, int height, int column) {
    std::vector<ColumnHit> hits;
    if (!isPictureSize(width, height) || column < 0 || column >= width) return hits;
    const World& world = state_->session.world();
    for (const Hit& hit : state_->session.trace(width, height, column).hits)
        hits.push_back(toColumnHit(world, hit));
    return hits;
}

std::vector<ColumnTrace> Game::trace(int width, int height, std::span<const int> columns) {
    std::vector<ColumnTrace> traces;
    const bool exist = isPictureSize(width, height) && columns.size() <= kMaxPictureSide &&
                       std::all_of(columns.begin(), columns.end(),
                                   [width](int column) { return column >= 0 && column < width; });
    if (!exist) return traces;
    const World& world = state_->session.world();
    state_->session.trace({.width = width, .height = height, .columns = columns},
                          [&](const SliceTrace& slice) {
                              traces.push_back(toColumnTrace(world, slice, slice.column));
                          });
    return traces;
}

std::optional<FrameTrace> Game::traceFrame(int width, int height) {
    if (!isPictureSize(width, height)) return std::nullopt;
    return frameTrace(state_->session, width, height);
}

std::optional<Ray> Game::cast(const RayStart& from) const {
    for (const double place : {from.x, from.y, from.z.value_or(0.0)})
        if (!(std::abs(place) <= kCoordinateLimit)) return std::nullopt;  // NaN too
    if (!state_->hasMap(from.map) || !std::isfinite(from.headingDegrees)) return std::nullopt;
    const World& world = state_->session.world();
    CastFrom start = {.map = from.map,
                      .x = toCoordinate(from.x),
                      .y = toCoordinate(from.y),
                      .z = {},
                      .headingDegrees = from.headingDegrees};
    if (from.z) start.z = toCoordinate(*from.z);
    const CastRay way = slicecast::cast(world, start);
    Ray ray;
    ray.directionX = way.direction.x;
    ray.directionY = way.direction.y;
    for (const CastTile& tile : way.tiles) ray.tiles.push_back(toRayTile(tile));
    for (const CastHit& hit : way.hits) ray.hits.push_back(toRayHit(world, hit));
    for (const CastPortal& passed : way.portals) {
        ray.portals.push_back(
            {toPortalEnds(world, passed.portal, passed.portals), passed.distance});
    }
    ray.end = static_cast<RayEnd>(way.end);
    ray.map = way.map;
    ray.x = way.x;
    ray.y = way.y;
    ray.distance = way.distance;
    return ray;
}

std::optional<Pick> Game::pick(int width, int height, int column, int row) {
    if (!isPictureSize(width, height) || column < 0 || column >= width || row < 0 || row >= height)
        return std::nullopt;
    return toPick(state_->session.world(), state_->session.trace(width, height, column, row));
}

std::optional<ScreenPoint> Game::project(double x, double y, double z, int width,
                                         int height) const {
    if (!isPictureSize(width, height)) return std::nullopt;
    const Eye eye = state_->session.eye();
    const auto point = slicecast::project(state_->session, eye, {x, y, z}, eye.map, width, height);
    if (!point) return std::nullopt;
    return ScreenPoint{point->x, point->y, point->depth};
}

}  // namespace slicecast

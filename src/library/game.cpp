#include "slicecast/game.h"

#include "library/map_infos.h"
#include "session/pick.h"
#include "session/session.h"
#include "session/trace_json.h"

#include <cmath>
#include <limits>
#include <utility>

namespace slicecast {
namespace {

using What = FilledRows::What;

// Seen and the kinds of news have the engine's order.
static_assert(static_cast<int>(Seen::side) == static_cast<int>(What::side) &&
              static_cast<int>(Seen::roof) == static_cast<int>(What::roof) &&
              static_cast<int>(Seen::underside) == static_cast<int>(What::underside) &&
              static_cast<int>(Seen::floor) == static_cast<int>(What::floor) &&
              static_cast<int>(Seen::ceiling) == static_cast<int>(What::ceiling) &&
              static_cast<int>(Seen::sky) == static_cast<int>(What::sky) &&
              static_cast<int>(Seen::haze) == static_cast<int>(What::haze) &&
              static_cast<int>(Seen::object) == static_cast<int>(What::object) &&
              static_cast<int>(Seen::object) + 1 == static_cast<int>(FilledRows::kWhats));
using Told = GameNews::Kind;
static_assert(static_cast<int>(Told::message) == static_cast<int>(QuestNews::Kind::message) &&
              static_cast<int>(Told::find) == static_cast<int>(QuestNews::Kind::find) &&
              static_cast<int>(Told::goal) == static_cast<int>(QuestNews::Kind::goal));

ColumnHit toColumnHit(const Hit& hit, const World& world) {
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

void setBlock(Pick& pick, const Hit& hit, Face face, const World& world) {
    pick.face = face;
    pick.tileX = hit.tileX;
    pick.tileY = hit.tileY;
    pick.level = hit.level;
    pick.block = world.blueprints[hit.blueprint].name;
}

}  // namespace

struct Game::State {
    Session session;
};

Game::Game(Scene scene)
    : state_(std::make_unique<State>(State{Session(std::move(scene).takeWorld())})) {}
Game::~Game() = default;
Game::Game(Game&& other) noexcept = default;
Game& Game::operator=(Game&& other) noexcept = default;

void Game::step(const Input& input) {
    state_->session.step(input);
}

void Game::reset() {
    state_->session.reset();
}

bool Game::draw(const Picture& picture, double fraction) {
    if (picture.pixels == nullptr || picture.pitch < picture.width) return false;
    return state_->session.draw(picture, fraction);
}

Image Game::picture(int width, int height) {
    if (!isPictureSize(width, height)) return {};
    Image image(width, height);
    if (!draw(image.view())) return {};
    return image;
}

Camera Game::camera() const {
    const Eye eye = state_->session.eye();
    return {.map = eye.map,
            .x = eye.x.value(),
            .y = eye.y.value(),
            .z = eye.z.value(),
            .headingDegrees = eye.headingDegrees,
            .look = eye.look};
}

bool Game::setCamera(const Camera& camera) {
    for (const double place : {camera.x, camera.y, camera.z})
        if (!(std::abs(place) <= kCoordinateLimit)) return false;  // NaN too
    return state_->session.setEye({.map = camera.map,
                                   .x = toCoordinate(camera.x),
                                   .y = toCoordinate(camera.y),
                                   .z = toCoordinate(camera.z),
                                   .headingDegrees = camera.headingDegrees,
                                   .look = camera.look});
}

bool Game::goToMap(int map) {
    return state_->session.goToMap(map);
}

std::string Game::setOption(std::string_view name, std::string_view value) {
    return state_->session.setOption(name, value);
}

std::string Game::option(std::string_view name) const {
    return state_->session.option(name);
}

std::string Game::setCell(int map, int level, int x, int y, std::string_view sign) {
    return state_->session.setCell({map, level, x, y}, sign);
}

std::vector<ColumnHit> Game::hits(int width, int height, int column) {
    std::vector<ColumnHit> hits;
    if (!isPictureSize(width, height) || column < 0 || column >= width) return hits;
    const World& world = state_->session.world();
    for (const Hit& hit : state_->session.trace(width, height, column).hits)
        hits.push_back(toColumnHit(hit, world));
    return hits;
}

std::optional<Pick> Game::pick(int width, int height, int column, int row) {
    if (!isPictureSize(width, height) || column < 0 || column >= width || row < 0 || row >= height)
        return std::nullopt;
    const World& world = state_->session.world();
    const SliceTrace trace = state_->session.trace(width, height, column, row);
    const SeenThing seen = nearestSeen(world, trace);
    const FilledRows& rows = *seen.rows;
    Pick pick;
    pick.what = seen.isHole ? Seen::haze : static_cast<Seen>(rows.what);
    pick.map = rows.map;
    pick.portals = rows.portals;
    pick.depth = std::numeric_limits<double>::infinity();
    if (rows.hit >= 0)
        setBlock(pick, trace.hits[static_cast<std::size_t>(rows.hit)], rows.face, world);
    if (rows.texture == kNoTexture || seen.isHole) return pick;
    pick.texture = textureName(world, rows);
    pick.x = seen.point->x;
    pick.y = seen.point->y;
    pick.z = heightOf(world, trace, rows, seen.point->z);
    pick.depth = seen.point->texel.depth;
    return pick;
}

std::vector<Sound> Game::hear() {
    const std::span<const Sound> heard = state_->session.hear();
    return {heard.begin(), heard.end()};
}

GameProgress Game::progress() const {
    const Quest& quest = state_->session.world().quest;
    GameProgress progress = {.aim = quest.aim,
                             .taken = quest.taken,
                             .of = static_cast<int>(quest.finds.size()),
                             .finds = {},
                             .hasGoal = quest.goal.has_value(),
                             .isReached = quest.isReached,
                             .steps = quest.steps};
    for (const FindKind& kind : quest.kinds)
        progress.finds.push_back({kind.name, kind.taken, kind.count});
    return progress;
}

std::vector<GameNews> Game::takeNews() {
    std::vector<GameNews> told;
    for (QuestNews& news : state_->session.takeNews()) {
        told.push_back({static_cast<GameNews::Kind>(news.kind), std::move(news.text),
                        std::move(news.name), news.taken});
    }
    return told;
}

std::optional<ScreenPoint> Game::project(double x, double y, double z, int width,
                                         int height) const {
    if (!isPictureSize(width, height)) return std::nullopt;
    const Eye eye = state_->session.eye();
    const auto point = slicecast::project(state_->session, eye, {x, y, z}, eye.map, width, height);
    if (!point) return std::nullopt;
    return ScreenPoint{point->x, point->y, point->depth};
}

const std::string& Game::title() const {
    return state_->session.world().title;
}

std::vector<MapInfo> Game::maps() const {
    return mapInfos(state_->session.world());
}

std::int64_t Game::steps() const {
    return state_->session.steps();
}

}  // namespace slicecast

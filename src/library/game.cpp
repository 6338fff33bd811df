#include "slicecast/game.h"

#include "library/game_state.h"
#include "library/map_infos.h"

#include <cmath>
#include <utility>

namespace slicecast {
namespace {

// The kinds of news have the engine's order.
using Told = GameNews::Kind;
static_assert(static_cast<int>(Told::message) == static_cast<int>(QuestNews::Kind::message) &&
              static_cast<int>(Told::find) == static_cast<int>(QuestNews::Kind::find) &&
              static_cast<int>(Told::goal) == static_cast<int>(QuestNews::Kind::goal));

}  // namespace

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

std::span<const OptionInfo> Game::options() {
    return knownOptions();
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

#include "app/app.h"

#include "base/angle.h"
#include "overlay/minimap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace slicecast {

namespace {

constexpr double kFastFactor = 3.0;  // for the keys of light and mirrors, as for moving
constexpr double kSlowFactor = 0.2;
constexpr double kLargestMouseTurn = 0.5;  // degrees per pixel
constexpr int kFastSlices = 10;            // step of the inspected slice while "fast" is held
constexpr double kDegreesBetweenWinds = 45.0;

}  // namespace

App::App(Shell& shell) : shell_(shell) {}

void App::play(std::unique_ptr<Session> game) {
    endReplay();
    replay_.reset();
    if (recorder_) shell_.tell(News::recording, false);
    game_ = std::move(game);
    game_->setClock([this] { return shell_.nowSeconds(); });
    recorder_.reset();
    clock_.stop();
    meter_.skip();
    turnDegrees_ = lookHeights_ = 0.0;
    beginning_ = Beginning{.lightLeft = kLightOfFirstPicture};
    redraw();
    tellChanges();
}

void App::redraw() {
    stale_ = true;
    if (beginning_) beginning_->column = 0;
    if (wantsFrame()) shell_.askForFrame();
}

void App::endReplay() {
    if (!isReplaying_) return;
    isReplaying_ = false;
    seekedStep_.reset();
    replay_->leave();
    shell_.tell(News::replay, false);
}

void App::record(const std::string& scene) {
    if (!game_) return;
    recorder_.emplace(scene);
    game_->record(&*recorder_);
    shell_.tell(News::recording, true);
}

std::optional<Recording> App::takeRecording() {
    if (!recorder_) return std::nullopt;
    Recording recording = recorder_->finish(*game_);
    game_->record(nullptr);
    recorder_.reset();
    shell_.tell(News::recording, false);
    return recording;
}

void App::replay(Recording recording) {
    if (!game_) return;
    replay_.emplace(std::move(recording));
    replay_->seek(*game_, 0, 0);  // keeps the start
    beginReplay();
}

void App::beginReplay() {
    isReplaying_ = true;
    shell_.tell(News::replay, true);
}

bool App::seek(std::int64_t step) {
    if (!game_ || !replay_ || recorder_) return false;
    if (!isReplaying_) beginReplay();
    seekedStep_ = step;
    redraw();
    return true;
}

// True when it is there.
bool App::seekOn() {
    const double begin = shell_.nowSeconds();
    while (!replay_->seek(*game_, *seekedStep_, 1)) {
        if (shell_.nowSeconds() - begin >= kSliceSeconds) return false;
    }
    game_->takeNews();  // what happened on the way is not told
    seekedStep_.reset();
    clock_.stop();
    return true;
}

void App::resize(int width, int height) {
    width_ = std::clamp(width, 1, kLargestPictureSide);
    height_ = std::clamp(height, 1, kLargestPictureSide);
    redraw();
}

void App::setPaused(bool paused) {
    if (paused == paused_) return;
    paused_ = paused;
    clock_.stop();
    meter_.skip();
    redraw();
    shell_.tell(News::pause, paused);
}

void App::setHidden(bool hidden) {
    hidden_ = hidden;
    clock_.stop();
    meter_.skip();
    redraw();
    releaseKeys();
}

void App::setMouse(double degreesPerPixel, bool invert) {
    if (degreesPerPixel >= 0.0) degreesPerPixel_ = std::min(degreesPerPixel, kLargestMouseTurn);
    invert_ = invert;
}

// ---- keys and mouse

void App::keyDown(SDL_Scancode key, bool repeated) {
    const std::optional<Action> action = bindings_.actionOf(key);
    if (!action) return;
    const Press press = infoOf(*action).press;
    if (press == Press::hold) {
        keys_.press(key, *action);
    } else if (!repeated || press == Press::repeat) {
        act(*action);
    }
}

void App::keyUp(SDL_Scancode key) {
    keys_.release(key);
}

void App::setKeys(const KeyBindings& keys) {
    bindings_ = keys;
    releaseKeys();
}

void App::releaseKeys() {
    keys_.releaseAll();
    thumbs_ = {};
    setCursorSteering(false);
}

void App::act(Action action) {
    switch (action) {
        case Action::help:
            shell_.tell(News::help, true);
            return;
        case Action::rate:
            shell_.tell(News::rate, true);
            return;
        case Action::sound:
            shell_.tell(News::sound, true);
            return;
        case Action::fullscreen:
            shell_.tell(News::fullscreen, true);
            return;
        case Action::leave:
            shell_.leave();
            return;
        case Action::pause:
            setPaused(!paused_);
            return;
        case Action::record:
            shell_.tell(News::record, true);
            return;
        case Action::cursor:
            setCursorSteering(!cursorSteers_);
            return;
        default:
            break;
    }
    if (!game_) return;
    if (action >= Action::map0 && action <= Action::map9) {
        endReplay();
        game_->goToMap(static_cast<int>(action) - static_cast<int>(Action::map0));
    } else if (action >= Action::faceEast && action <= Action::faceNorthEast) {
        endReplay();
        game_->setHeading(kDegreesBetweenWinds *
                          (static_cast<int>(action) - static_cast<int>(Action::faceEast)));
    } else if (infoOf(action).option != nullptr) {
        changeOption(infoOf(action));
    } else if (!actInGame(action)) {
        return;
    }
    redraw();
}

// False for an action that acts only while held.
bool App::actInGame(Action action) {
    const int slices = keys_.isDown(Action::fast) ? kFastSlices : 1;
    switch (action) {
        case Action::levelLook:
            endReplay();
            game_->levelLook();
            return true;
        case Action::fly:
            endReplay();
            game_->setFlying(!game_->player().flying);
            return true;
        case Action::hits:
            shell_.tellHits(*game_, width_, height_, game_->inspectedColumn(width_));
            return true;
        case Action::minimapLevelDown:
            changeMinimapLevel(-1);
            return true;
        case Action::minimapLevelUp:
            changeMinimapLevel(1);
            return true;
        case Action::sliceLeft:
            changeNumber("inspectorColumn", game_->inspectedColumn(width_), -slices, 0, width_ - 1);
            return true;
        case Action::sliceRight:
            changeNumber("inspectorColumn", game_->inspectedColumn(width_), slices, 0, width_ - 1);
            return true;
        default:
            return false;
    }
}

// Toggles the option, selects the next choice, or changes a number within its range. Light that has
// not been set starts from the map's own.
void App::changeOption(const ActionInfo& info) {
    // What the page has changed in this frame is told before the key changes it back
    tellChanges();
    const OptionInfo* option = findOption(info.option);
    if (option->kind == OptionKind::onOff) {
        game_->setOption(info.option, game_->option(info.option) == "on" ? "off" : "on");
    } else if (option->kind == OptionKind::choice) {
        game_->setOption(info.option, nextChoice(info.option, game_->option(info.option)));
    } else {
        const bool whole = option->kind == OptionKind::wholeNumber;
        const double factor = whole                        ? 1.0
                              : keys_.isDown(Action::slow) ? kSlowFactor
                              : keys_.isDown(Action::fast) ? kFastFactor
                                                           : 1.0;
        const double target = optionNow(info.option) + info.by * factor;
        game_->setOption(info.option, std::floor(target * 100.0 + 0.5) / 100.0);
    }
}

double App::optionNow(std::string_view option) const {
    if (option == "intensity") return game_->state().intensity;
    if (option == "multiplier") return game_->state().multiplier;
    return optionNumber(game_->options(), option);
}

void App::changeNumber(const char* option, int now, int by, int least, int greatest) {
    game_->setOption(option, static_cast<double>(std::clamp(now + by, least, greatest)));
}

// Below the lowest level, the minimap shows the player's level.
void App::changeMinimapLevel(int by) {
    const Eye eye = game_->eye();
    const Map& map = game_->world().maps[static_cast<std::size_t>(eye.map)];
    changeNumber("minimapLevel", minimapLevel(map, eye, {.level = game_->options().minimapLevel}),
                 by, -1, map.levels - 1);
}

void App::pointerMoved(double right, double down) {
    if (pointerHeld_) look(right, down);
}

void App::dragged(double right, double down) {
    look(right, down);
}

void App::look(double right, double down) {
    // The click that starts a replay also moves the mouse.
    if (paused_ || hidden_ || !game_ || isReplaying_) return;
    turnDegrees_ += right * degreesPerPixel_;

    // The same motion moves the middle of the picture equally far up or down as sideways.
    const double fov = renderOptions(game_->options(), width_, height_).fovDegrees;
    const double distanceHeights = 0.5 * width_ / height_ / tanDegrees(0.5 * fov);
    const double up = (invert_ ? down : -down) * degreesPerPixel_;
    lookHeights_ += tanDegrees(std::clamp(up, -45.0, 45.0)) * distanceHeights;
}

void App::pointerHeld(bool held) {
    if (held == pointerHeld_) return;
    pointerHeld_ = held;
    turnDegrees_ = lookHeights_ = 0.0;
    shell_.tell(News::pointer, held);
    if (held) setCursorSteering(false);
}

void App::setCursorSteering(bool on) {
    cursor_ = {};
    if (on == cursorSteers_) return;
    cursorSteers_ = on;
    shell_.tell(News::cursor, on);
}

void App::cursorAt(double x, double y) {
    if (!cursorSteers_) return;
    cursor_ = cursorInput(x, y);
    if (invert_) cursor_.look = -cursor_.look;
}

void App::setGamepad(const Gamepad& gamepad) {
    const unsigned pressed = gamepad.buttons & ~gamepad_.buttons;
    gamepad_ = gamepad;
    if ((pressed & kPadFly) != 0) act(Action::fly);
    if ((pressed & kPadLevel) != 0) act(Action::levelLook);
    if ((pressed & kPadMinimap) != 0) act(Action::minimap);
    if ((pressed & kPadPause) != 0) act(Action::pause);
}

// ---- frames

Input App::takeInput() {
    Input input = keys_.takeInput();
    input.turnDegrees = std::exchange(turnDegrees_, 0.0);
    input.lookHeights = std::exchange(lookHeights_, 0.0);
    input = together(together(input, thumbs_), together(cursor_, gamepadInput(gamepad_)));
    // While one flies, a jump rises
    if (input.jump && game_->player().flying) {
        input.fly = std::min(input.fly + 1.0, 1.0);
        input.jump = false;
    }
    return input;
}

void App::play() {
    const Input input = takeInput();
    if (isReplaying_ && !isAnything(input) && replay_->step(*game_)) {
        tellStep();
    } else {
        step(input);
    }
}

void App::step(const Input& input) {
    if (!game_) return;
    endReplay();
    game_->step(input);
    tellStep();
    redraw();
}

void App::tellStep() {
    if (!game_->world().quest.news.empty()) shell_.tell(News::quest, true);
    const Player& before = game_->beforeStep();
    const Player& now = game_->player();
    if (before.leaps == now.leaps) return;
    const auto nameOf = [&](int map) -> const std::string& {
        return game_->world().maps[static_cast<std::size_t>(map)].name;
    };
    shell_.tellPortal(nameOf(before.map), nameOf(now.map));
}

bool App::frame(double nowSeconds) {
    if (hidden_ || !game_) return false;
    if (seekedStep_ && !seekOn()) return false;
    if (!paused_) {
        if (beginning_) clock_.stop();
        const int steps = clock_.advance(nowSeconds);
        for (int i = 0; i < steps; ++i) play();
        stale_ = true;
    }
    tellChanges();
    return stale_ && draw(nowSeconds);
}

bool App::draw(double nowSeconds) {
    stale_ = false;

    // A surface of the picture's size
    if (!surface_ || surface_->w != width_ || surface_->h != height_) {
        surface_.reset();  // frees its memory for the next one
        surface_.reset(
            SDL_CreateRGBSurfaceWithFormat(0, width_, height_, 32, SDL_PIXELFORMAT_RGBA32));
        if (!surface_) return false;
        SDL_SetSurfaceBlendMode(surface_.get(), SDL_BLENDMODE_NONE);
        shell_.tellSize(width_, height_);
    }

    // The picture; while paused, exactly of the last step
    const double fraction = paused_ || beginning_ ? 1.0 : clock_.fraction();
    const Picture picture = {static_cast<Pixel*>(surface_->pixels), width_, height_,
                             surface_->pitch / static_cast<int>(sizeof(Pixel))};
    const double begin = shell_.nowSeconds();
    if (beginning_ && !drawBeginning(picture)) {
        stale_ = true;
        return false;
    }
    const bool isFirst = std::exchange(beginning_, {}).has_value();
    if (!isFirst && !game_->draw(picture, fraction, kLightOfPicture)) return false;
    stale_ = game_->report().lateLight > 0;
    if (!isFirst && game_->report().unlit > 0 && ++unlitPictures_ < kMostUnlitPictures)
        return false;
    unlitPictures_ = 0;
    const double end = shell_.nowSeconds();
    shell_.show(*surface_);

    // News for the shell
    if (!ready_) shell_.tell(News::ready, true);
    ready_ = true;
    const Eye eye = game_->eye(fraction);
    shell_.tellShown(std::exchange(shownEye_, eye) != eye);
    if (!paused_ && meter_.add(nowSeconds, end - begin)) shell_.tellRates(meter_.rates());
    return true;
}

// Draws slices of the first picture. False if there are more to come.
bool App::drawBeginning(const Picture& picture) {
    constexpr LightWork kLightOfSlice = 50'000;  // some milliseconds on a slow phone
    const double begin = shell_.nowSeconds();
    do {
        const int next = beginning_->lightLeft > 0
                             ? game_->drawSome(picture, 1.0, beginning_->column, kLightOfSlice)
                         : game_->draw(picture, 1.0, kLightOfSlice) ? picture.width
                                                                    : -1;
        if (next < 0) {
            beginning_.reset();
            return false;
        }
        beginning_->lightLeft -= game_->report().lightWork;
        beginning_->column = next;
    } while (beginning_->column < picture.width && shell_.nowSeconds() - begin < kSliceSeconds);
    return beginning_->column >= picture.width;
}

// The keys, the page and the engine (a body that is stuck starts to fly) all change modes, so they
// are compared.
void App::tellChanges() {
    if (!game_) return;
    if (std::exchange(toldFly_, game_->player().flying) != game_->player().flying)
        shell_.tell(News::fly, toldFly_);
    const bool hasOverlay = showsOverlay(game_->options());
    if (std::exchange(toldOverlay_, hasOverlay) != hasOverlay)
        shell_.tell(News::overlay, hasOverlay);
}

}  // namespace slicecast

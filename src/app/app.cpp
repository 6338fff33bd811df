#include "app/app.h"

#include "base/angle.h"
#include "base/number_text.h"
#include "overlay/minimap.h"
#include "overlay/slow_drawing.h"
#include "session/hits_json.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace slicecast {

namespace {

constexpr double kIntensityStep = 0.1;
constexpr double kMultiplierStep = 0.5;  // units
constexpr double kMirrorsStep = 0.1;
constexpr double kFastFactor = 3.0;  // for the keys of light and mirrors, as for moving
constexpr double kSlowFactor = 0.2;
constexpr double kLargestMouseTurn = 0.5;  // degrees per pixel
constexpr int kFastSlices = 10;            // by which the inspected slice moves

// Keys that switch an option on and off.
struct Switch {
    Action action;
    const char* option;
    bool SessionOptions::*value;
};
constexpr auto kSwitches = std::to_array<Switch>({
    {Action::minimap, "minimap", &SessionOptions::minimap},
    {Action::minimapTurns, "minimapTurns", &SessionOptions::minimapTurns},
    {Action::minimapRays, "minimapRays", &SessionOptions::minimapRays},
    {Action::playerPanel, "playerPanel", &SessionOptions::playerPanel},
    {Action::processPanel, "processPanel", &SessionOptions::processPanel},
    {Action::inspector, "inspector", &SessionOptions::inspector},
    {Action::grid, "grid", &SessionOptions::grid},
    {Action::slowDrawing, "slow", &SessionOptions::slow},
});

}  // namespace

App::App(Shell& shell) : shell_(shell) {}

void App::play(std::unique_ptr<Session> game) {
    endReplay();
    if (recorder_) shell_.tell(News::recording, false);
    game_ = std::move(game);
    game_->setClock([this] { return shell_.nowSeconds(); });
    recorder_.reset();
    clock_.stop();
    meter_.skip();
    turnDegrees_ = lookHeights_ = 0.0;
    redraw();
    tellChanges();
}

void App::redraw() {
    stale_ = true;
    if (wantsFrame()) shell_.askForFrame();
}

void App::endReplay() {
    if (!replay_) return;
    replay_.reset();
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
    shell_.tell(News::replay, true);
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

void App::keyDown(const Key& key, bool repeated) {
    if (isHeld(key.action)) {
        keys_.press(key);
    } else if (!repeated || repeats(key.action)) {
        act(key);
    }
}

void App::keyUp(const Key& key) {
    keys_.release(key);
}

void App::releaseKeys() {
    keys_.releaseAll();
    thumbs_ = {};
    setCursorSteering(false);
}

void App::act(const Key& key) {
    switch (key.action) {
        case Action::help:
            shell_.tell(News::help, true);
            return;
        case Action::rate:
            shell_.tell(News::rate, true);
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
    switch (key.action) {
        case Action::levelLook:
            endReplay();
            game_->levelLook();
            break;
        case Action::heading:
            endReplay();
            game_->setHeading(key.headingDegrees);
            break;
        case Action::fly:
            endReplay();
            game_->setFlying(!game_->player().flying);
            break;
        case Action::map:
            endReplay();
            game_->goToMap(key.map);
            break;
        case Action::lightPreset:
            game_->setOption("lightPreset",
                             nextChoice("lightPreset", game_->option("lightPreset")));
            break;
        case Action::hits:
            shell_.tellHits(hitsJson(*game_, game_->world().title, width_, height_,
                                     game_->inspectedColumn(width_)));
            break;
        case Action::minimapLevelDown:
            changeMinimapLevel(-1);
            break;
        case Action::minimapLevelUp:
            changeMinimapLevel(1);
            break;
        case Action::sliceLeft:
            changeNumber("inspectorColumn", game_->inspectedColumn(width_),
                         keys_.isDown(Action::fast) ? -kFastSlices : -1, 0, width_ - 1);
            break;
        case Action::sliceRight:
            changeNumber("inspectorColumn", game_->inspectedColumn(width_),
                         keys_.isDown(Action::fast) ? kFastSlices : 1, 0, width_ - 1);
            break;
        case Action::slowerSlices:
            changeNumber("slowSlices", game_->options().slowSlices, -1, -kMostSlicesPerPicture,
                         kMostSlicesPerPicture);
            break;
        case Action::fasterSlices:
            changeNumber("slowSlices", game_->options().slowSlices, 1, -kMostSlicesPerPicture,
                         kMostSlicesPerPicture);
            break;
        case Action::intensityUp:
            changeLight("intensity", game_->state().intensity, kIntensityStep);
            break;
        case Action::intensityDown:
            changeLight("intensity", game_->state().intensity, -kIntensityStep);
            break;
        case Action::multiplierUp:
            changeLight("multiplier", game_->state().multiplier, kMultiplierStep);
            break;
        case Action::multiplierDown:
            changeLight("multiplier", game_->state().multiplier, -kMultiplierStep);
            break;
        case Action::mirrorsUp:
            changeLight("mirrors", game_->options().render.mirrors, kMirrorsStep);
            break;
        case Action::mirrorsDown:
            changeLight("mirrors", game_->options().render.mirrors, -kMirrorsStep);
            break;
        default:
            if (!toggle(key.action)) return;
            break;
    }
    redraw();
}

// Switches the option of an action on or off. False if it has none.
bool App::toggle(Action action) {
    for (const Switch& one : kSwitches) {
        if (one.action != action) continue;
        game_->setOption(one.option, game_->options().*one.value ? "off" : "on");
        return true;
    }
    return false;
}

void App::changeNumber(const char* option, int now, int by, int least, int greatest) {
    game_->setOption(option, wholeText(std::clamp(now + by, least, greatest)));
}

// Below the lowest level comes whichever level the player is on.
void App::changeMinimapLevel(int by) {
    const Eye eye = game_->eye();
    const Map& map = game_->world().maps[static_cast<std::size_t>(eye.map)];
    changeNumber("minimapLevel", minimapLevel(map, eye, {.level = game_->options().minimapLevel}),
                 by, -1, map.levels - 1);
}

// Light and mirrors, as far as their range goes; from the map's own light where the option has not
// been set.
void App::changeLight(const char* option, double now, double by) {
    const double factor = keys_.isDown(Action::slow)   ? kSlowFactor
                          : keys_.isDown(Action::fast) ? kFastFactor
                                                       : 1.0;
    const double wanted = now + by * factor;
    for (const OptionInfo& info : knownOptions()) {
        if (info.name != std::string_view(option)) continue;
        game_->setOption(option, fixedText(std::clamp(wanted, info.least, info.greatest), 2));
    }
}

void App::pointerMoved(double right, double down) {
    if (pointerHeld_) look(right, down);
}

void App::dragged(double right, double down) {
    look(right, down);
}

void App::look(double right, double down) {
    // A mouse is moved by the click that begins a replay.
    if (paused_ || hidden_ || !game_ || replay_) return;
    turnDegrees_ += right * degreesPerPixel_;

    // The same movement carries the middle of the picture as many pixels up or down as sideways.
    const double distanceHeights =
        0.5 * width_ / height_ / tanDegrees(0.5 * game_->options().render.fovDegrees);
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
    return together(together(input, thumbs_), together(cursor_, gamepadInput(gamepad_)));
}

void App::play() {
    const Input input = takeInput();
    if (replay_ && !isAnything(input) && replay_->step(*game_)) {
        tellPortal();
    } else {
        step(input);
    }
}

void App::step(const Input& input) {
    if (!game_) return;
    endReplay();
    game_->step(input);
    tellPortal();
    redraw();
}

void App::tellPortal() {
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
    if (!paused_) {
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
        surface_.reset(
            SDL_CreateRGBSurfaceWithFormat(0, width_, height_, 32, SDL_PIXELFORMAT_RGBA32));
        if (!surface_) return false;
        SDL_SetSurfaceBlendMode(surface_.get(), SDL_BLENDMODE_NONE);
        shell_.tellSize(width_, height_);
    }

    // The picture; while paused, of the last step itself
    const double fraction = paused_ ? 1.0 : clock_.fraction();
    const Picture picture = {static_cast<Pixel*>(surface_->pixels), width_, height_,
                             surface_->pitch / static_cast<int>(sizeof(Pixel))};
    const double begin = shell_.nowSeconds();
    if (!game_->draw(picture, fraction)) return false;
    const double end = shell_.nowSeconds();
    shell_.show(*surface_);

    // What the shell may want to know
    if (!ready_) shell_.tell(News::ready, true);
    ready_ = true;
    const Eye eye = game_->eye(fraction);
    shell_.tellShown(std::exchange(shownEye_, eye) != eye);
    if (!paused_ && meter_.add(nowSeconds, end - begin)) shell_.tellRates(meter_.rates());
    return true;
}

// Modes change by keys, by the page and by themselves (a body that is not free flies), so they are
// compared.
void App::tellChanges() {
    if (!game_) return;
    if (std::exchange(toldFly_, game_->player().flying) != game_->player().flying)
        shell_.tell(News::fly, toldFly_);
    const bool hasOverlay = std::any_of(kSwitches.begin(), kSwitches.end(), [&](const Switch& one) {
        return game_->options().*one.value;
    });
    if (std::exchange(toldOverlay_, hasOverlay) != hasOverlay)
        shell_.tell(News::overlay, hasOverlay);
}

}  // namespace slicecast

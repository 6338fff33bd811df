#include "app/window_shell.h"

#ifndef __EMSCRIPTEN__

#include "answers/hits_json.h"
#include "app/help_pages.h"
#include "base/words.h"
#include "overlay/text.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace slicecast {

namespace {

constexpr Size kFirstWindow = {1280, 720};
constexpr Uint32 kFullscreen = SDL_WINDOW_FULLSCREEN_DESKTOP;
constexpr int kUsualRate = 60;      // pictures per second if the screen does not report a rate
constexpr Uint32 kIdleMillis = 10;  // between checks for events while nothing moves

// SDL's controller buttons and their numbers in the web's standard gamepad.
struct PadButton {
    SDL_GameControllerButton button;
    GamepadButton meaning;
};
constexpr auto kPadButtons = std::to_array<PadButton>({
    {SDL_CONTROLLER_BUTTON_A, kPadJump},
    {SDL_CONTROLLER_BUTTON_B, kPadCrouch},
    {SDL_CONTROLLER_BUTTON_X, kPadLevel},
    {SDL_CONTROLLER_BUTTON_Y, kPadFly},
    {SDL_CONTROLLER_BUTTON_LEFTSHOULDER, kPadSlow},
    {SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, kPadFast},
    {SDL_CONTROLLER_BUTTON_BACK, kPadMinimap},
    {SDL_CONTROLLER_BUTTON_START, kPadPause},
    {SDL_CONTROLLER_BUTTON_RIGHTSTICK, kPadUse},
    {SDL_CONTROLLER_BUTTON_DPAD_UP, kPadUp},
    {SDL_CONTROLLER_BUTTON_DPAD_DOWN, kPadDown},
    {SDL_CONTROLLER_BUTTON_DPAD_LEFT, kPadLeft},
    {SDL_CONTROLLER_BUTTON_DPAD_RIGHT, kPadRight},
});

constexpr std::size_t kMessageWidth = 56;  // characters of a line of a message

// Breaks a text into lines at its spaces.
std::string wrapped(std::string text, std::size_t width) {
    std::size_t lineBegin = 0;
    std::size_t space = std::string::npos;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == ' ') space = i;
        if (text[i] == '\n') lineBegin = i + 1;
        if (i - lineBegin < width || space == std::string::npos || space < lineBegin) continue;
        text[space] = '\n';
        lineBegin = space + 1;
    }
    return text;
}

std::string sdlFault(const char* what) {
    return std::string(what) + ": " + SDL_GetError();
}

}  // namespace

WindowShell::~WindowShell() {
    gamepad_.reset();
    window_.reset();
    SDL_Quit();
}

std::string WindowShell::open(App& app, const std::string& title) {
    app_ = &app;
    if (SDL_Init(SDL_INIT_VIDEO) != 0) return sdlFault("cannot use a screen");
    // Where there is no display, SDL falls back to drivers that show nothing. Whoever wants one, as
    // tests do, names it.
    const std::string driver = SDL_GetCurrentVideoDriver();
    const char* asked = std::getenv("SDL_VIDEODRIVER");
    if ((driver == "offscreen" || driver == "dummy") && (asked == nullptr || *asked == '\0'))
        return words("cannot use a screen: found none, and SDL's driver \"", driver,
                     "\" would draw unseen; expected a desktop (DISPLAY or WAYLAND_DISPLAY)");
    const Size size = settings_.picture.value_or(kFirstWindow);
    const Uint32 flags =
        SDL_WINDOW_HIDDEN | SDL_WINDOW_RESIZABLE | (settings_.fullscreen ? kFullscreen : 0u);
    title_ = title;
    window_.reset(SDL_CreateWindow(shownTitle().c_str(), SDL_WINDOWPOS_CENTERED,
                                   SDL_WINDOWPOS_CENTERED, size.width, size.height, flags));
    if (!window_) return sdlFault("cannot open a window");
    // SDL may replace the window here. It was hidden until now, so it does not blink.
    if (SDL_GetWindowSurface(window_.get()) == nullptr)
        return sdlFault("cannot draw in the window");
    SDL_ShowWindow(window_.get());
    SDL_StopTextInput();
    // Works with keys alone if this fails.
    SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);
    fitPicture();
    return {};
}

void WindowShell::run(const std::function<void(const std::filesystem::path&)>& dropped,
                      const std::function<void()>& record) {
    SDL_DisplayMode mode = {};
    const int display = std::max(0, SDL_GetWindowDisplayIndex(window_.get()));
    const int rate = SDL_GetCurrentDisplayMode(display, &mode) == 0 && mode.refresh_rate > 0
                         ? mode.refresh_rate
                         : kUsualRate;
    running_ = true;
    double due = nowSeconds();
    while (running_) {
        // Events
        SDL_Event event;
        while (SDL_PollEvent(&event) != 0) handle(event);
        if (!dropped_.empty()) dropped(std::exchange(dropped_, {}));
        if (std::exchange(recordAsked_, false)) record();
        if (gamepad_) readGamepad();

        // A picture, and the time until the next one is due
        const double now = nowSeconds();
        if (!app_->frame(now)) {
            if (!app_->isBeginning()) SDL_Delay(kIdleMillis);
            due = nowSeconds();
            continue;
        }
        due = std::max(due + 1.0 / rate, now);
        const double wait = due - nowSeconds();
        if (wait > 0.0) SDL_Delay(static_cast<Uint32>(wait * 1000.0));
    }
}

void WindowShell::setTitle(const std::string& title) {
    title_ = title;
    if (!window_) return;
    SDL_SetWindowTitle(window_.get(), shownTitle().c_str());
}

std::string WindowShell::shownTitle() const {
    std::string shown = title_;
    if (finds_ > 0) shown += words(" (", taken_, " of ", finds_, ")");
    if (app_->isRecording()) shown += " (recording)";
    if (app_->replayed() != nullptr) shown += " (replay)";
    if (app_->paused()) shown += " (paused)";
    return shown;
}

double WindowShell::nowSeconds() const {
    return static_cast<double>(SDL_GetPerformanceCounter()) /
           static_cast<double>(SDL_GetPerformanceFrequency());
}

// ---- pictures

Size WindowShell::windowSize() const {
    Size size;
    SDL_GetWindowSize(window_.get(), &size.width, &size.height);
    return {std::max(1, size.width), std::max(1, size.height)};
}

void WindowShell::fitPicture() {
    const Fit fit =
        settings_.picture ? letterbox(*settings_.picture, windowSize()) : fillWindow(windowSize());
    place_ = fit.place;
    pictureSize_ = fit.picture;
    app_->resize(fit.picture.width, fit.picture.height);
}

// The panels that a page shows beside the picture.
void WindowShell::drawPanels(SDL_Surface& surface) const {
    const Picture picture = {static_cast<Pixel*>(surface.pixels), surface.w, surface.h,
                             surface.pitch / static_cast<int>(sizeof(Pixel))};
    if (showsRate_) {
        char text[64];
        std::snprintf(text, sizeof text, "%.0f frames/s\n%.1f ms to draw", rates_.framesPerSecond,
                      rates_.drawMilliseconds);
        drawTextPanel(picture, Anchor::top, text);
    }
    if (!message_.empty() && nowSeconds() < messageEnd_)
        drawTextPanel(picture, Anchor::bottom, message_);
    const std::vector<std::string> pages = helpPages(app_->keys(), {surface.w, surface.h});
    if (helpPage_ < pages.size()) drawTextPanel(picture, Anchor::middle, pages[helpPage_]);
}

void WindowShell::show(SDL_Surface& picture) {
    drawPanels(picture);
    SDL_Surface* screen = SDL_GetWindowSurface(window_.get());
    if (screen == nullptr) return;
    const bool covered =
        place_.x <= 0 && place_.y <= 0 && place_.w >= screen->w && place_.h >= screen->h;
    if (!covered) SDL_FillRect(screen, nullptr, SDL_MapRGB(screen->format, 0, 0, 0));
    SDL_Rect place = place_;
    SDL_BlitScaled(&picture, nullptr, screen, &place);
    SDL_UpdateWindowSurface(window_.get());
}

// The standard output has nothing else, so that programs can read it.
void WindowShell::tellHits(Session& game, int width, int height, int column) {
    const std::string json = hitsJson(game, game.world().title, width, height, column);
    std::fwrite(json.data(), 1, json.size(), stdout);
    std::fflush(stdout);
}

void WindowShell::tell(News news, bool yes) {
    switch (news) {
        case News::pause:
        case News::recording:
        case News::replay:
            setTitle(title_);
            break;
        case News::record:
            recordAsked_ = true;
            break;
        case News::fullscreen: {
            const bool full = (SDL_GetWindowFlags(window_.get()) & kFullscreen) == kFullscreen;
            SDL_SetWindowFullscreen(window_.get(), full ? 0u : kFullscreen);
            break;
        }
        case News::help: {
            const bool hasNext = helpPage_ + 1 < helpPages(app_->keys(), pictureSize_).size();
            helpPage_ = !yes                   ? kNoPage
                        : helpPage_ == kNoPage ? 0
                        : hasNext              ? helpPage_ + 1
                                               : kNoPage;
            app_->redraw();
            break;
        }
        case News::rate:
            showsRate_ = yes && !showsRate_;
            app_->redraw();
            break;
        case News::quest:
            showNews();
            break;
        case News::ready:
        case News::pointer:
        case News::cursor:
        case News::fly:
        case News::overlay:
        case News::sound:  // the program in a window is silent
            break;
    }
}

void WindowShell::showMessage(const std::string& text) {
    constexpr double kReadingSeconds = 5.0;
    message_ = wrapped(text, kMessageWidth);
    messageEnd_ = nowSeconds() + kReadingSeconds;
    if (app_ != nullptr) app_->redraw();
}

// The last text of the news, and how many finds are taken.
void WindowShell::showNews() {
    Session& game = *app_->game();
    for (const QuestNews& news : game.takeNews()) {
        if (!news.text.empty()) showMessage(news.text);
    }
    taken_ = game.world().quest.taken;
    finds_ = static_cast<int>(game.world().quest.finds.size());
    setTitle(title_);
    app_->redraw();
}

// ---- events

void WindowShell::leave() {
    if (app_->holdsPointer()) {
        holdPointer(false);
    } else if (app_->cursorSteers()) {
        app_->setCursorSteering(false);
    } else {
        running_ = false;
    }
}

void WindowShell::holdPointer(bool hold) {
    if (SDL_SetRelativeMouseMode(hold ? SDL_TRUE : SDL_FALSE) == 0) {
        app_->pointerHeld(hold);
    } else if (hold) {
        app_->setCursorSteering(true);
    }
}

void WindowShell::handle(const SDL_Event& event) {
    switch (event.type) {
        case SDL_QUIT:
            running_ = false;
            break;
        case SDL_WINDOWEVENT:
            handleWindow(event.window);
            break;
        case SDL_KEYDOWN:
            // With Alt or the system's key, keys belong to the desktop.
            if ((event.key.keysym.mod & (KMOD_ALT | KMOD_GUI)) != 0) break;
            app_->keyDown(event.key.keysym.scancode, event.key.repeat != 0);
            break;
        case SDL_KEYUP:
            app_->keyUp(event.key.keysym.scancode);
            break;
        case SDL_MOUSEBUTTONDOWN:
            if (event.button.button == SDL_BUTTON_LEFT && !app_->holdsPointer()) holdPointer(true);
            break;
        case SDL_MOUSEMOTION:
            app_->pointerMoved(event.motion.xrel, event.motion.yrel);
            app_->cursorAt(2.0 * event.motion.x / windowSize().width - 1.0,
                           2.0 * event.motion.y / windowSize().height - 1.0);
            break;
        case SDL_CONTROLLERDEVICEADDED:
            gamepad_.reset(SDL_GameControllerOpen(event.cdevice.which));
            break;
        case SDL_CONTROLLERDEVICEREMOVED:
            if (gamepad_ && !SDL_GameControllerGetAttached(gamepad_.get())) {
                gamepad_.reset();
                app_->setGamepad({});
            }
            break;
        case SDL_DROPFILE:
            dropped_ = event.drop.file;
            SDL_free(event.drop.file);
            break;
        default:
            break;
    }
}

void WindowShell::readGamepad() {
    const auto axis = [&](SDL_GameControllerAxis which) {
        return std::max(-1.0, SDL_GameControllerGetAxis(gamepad_.get(), which) / 32767.0);
    };
    Gamepad now;
    now.left = {axis(SDL_CONTROLLER_AXIS_LEFTX), axis(SDL_CONTROLLER_AXIS_LEFTY)};
    now.right = {axis(SDL_CONTROLLER_AXIS_RIGHTX), axis(SDL_CONTROLLER_AXIS_RIGHTY)};
    now.leftTrigger = axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT);
    now.rightTrigger = axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT);
    for (const PadButton& pad : kPadButtons) {
        if (SDL_GameControllerGetButton(gamepad_.get(), pad.button) != 0)
            now.buttons |= pad.meaning;
    }
    app_->setGamepad(now);
}

void WindowShell::handleWindow(const SDL_WindowEvent& event) {
    switch (event.event) {
        case SDL_WINDOWEVENT_SIZE_CHANGED:
            fitPicture();
            break;
        case SDL_WINDOWEVENT_EXPOSED:
            app_->redraw();
            break;
        case SDL_WINDOWEVENT_FOCUS_LOST:
            app_->releaseKeys();
            if (app_->holdsPointer()) holdPointer(false);
            break;
        case SDL_WINDOWEVENT_LEAVE:
            app_->cursorLeft();
            break;
        case SDL_WINDOWEVENT_HIDDEN:
        case SDL_WINDOWEVENT_MINIMIZED:
            app_->setHidden(true);
            break;
        case SDL_WINDOWEVENT_SHOWN:
        case SDL_WINDOWEVENT_RESTORED:
            app_->setHidden(false);
            break;
        default:
            break;
    }
}

}  // namespace slicecast

#endif

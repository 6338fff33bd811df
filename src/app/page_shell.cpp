#include "app/page_shell.h"

#ifdef __EMSCRIPTEN__

#include <SDL2/SDL_surface.h>
#include <emscripten/emscripten.h>

#include <array>
#include <cstdint>
#include <memory>

// ---- what needs JavaScript

// web/engine/engine-module.js implements these functions.
#define SLICECAST_PAGE(name) __attribute__((import_module("page"), import_name(name)))

extern "C" {

// Starts the canvas's events. They write the code of a key into `code`, which has room for the
// longest known one. 0 if there is no canvas.
SLICECAST_PAGE("openCanvas") int slicecastOpenCanvas(char* code, int codeBytes);
SLICECAST_PAGE("closeCanvas") void slicecastCloseCanvas(void);
// Milliseconds on the clock of the browser's frames.
SLICECAST_PAGE("now") double slicecastNow(void);
SLICECAST_PAGE("leaveCanvas") void slicecastLeaveCanvas(void);
SLICECAST_PAGE("showPixels") void slicecastShowPixels(uint32_t address, int width, int height);
// With the screen's next picture, or else as soon as the page has had its turn.
SLICECAST_PAGE("askForFrame") void slicecastAskForFrame(int withScreen);
SLICECAST_PAGE("forgetFrame") void slicecastForgetFrame(void);
SLICECAST_PAGE("tell") void slicecastTell(const char* news, int yes);
SLICECAST_PAGE("tellShown") void slicecastTellShown(int moved);
SLICECAST_PAGE("tellPortal") void slicecastTellPortal(const char* from, const char* to);
SLICECAST_PAGE("tellRates")
void slicecastTellRates(double framesPerSecond, double drawMilliseconds,
                        double longestMilliseconds);
SLICECAST_PAGE("tellSize") void slicecastTellSize(int width, int height);
SLICECAST_PAGE("tellHits") void slicecastTellHits(int width, int height, int column);

}  // extern "C"

namespace slicecast {

namespace {

class PageShell : public Shell {
public:
    double nowSeconds() const override { return slicecastNow() * 0.001; }
    void show(SDL_Surface& picture) override {
        slicecastShowPixels(static_cast<uint32_t>(reinterpret_cast<std::uintptr_t>(picture.pixels)),
                            picture.w, picture.h);
    }
    void askForFrame() override;
    void tell(News news, bool yes) override { slicecastTell(nameOf(kNews, news), yes); }
    void tellShown(bool moved) override { slicecastTellShown(moved); }
    void tellPortal(const std::string& from, const std::string& to) override {
        slicecastTellPortal(from.c_str(), to.c_str());
    }
    void tellRates(const FrameRates& rates) override {
        slicecastTellRates(rates.framesPerSecond, rates.drawMilliseconds,
                           rates.longestMilliseconds);
    }
    void tellSize(int width, int height) override { slicecastTellSize(width, height); }
    void tellHits(Session&, int width, int height, int column) override {
        slicecastTellHits(width, height, column);
    }
    void leave() override { slicecastLeaveCanvas(); }

    bool isOpen = false;
    std::array<char, 32> code{};  // of the key of the current event
    bool asksFrame = false;       // of the browser
};

PageShell& shell() {
    static PageShell theShell;
    return theShell;
}

// ---- keys and mouse

bool isArrow(SDL_Scancode key) {
    return key >= SDL_SCANCODE_RIGHT && key <= SDL_SCANCODE_UP;
}

bool isShiftOrControl(SDL_Scancode key) {
    return key == SDL_SCANCODE_LSHIFT || key == SDL_SCANCODE_RSHIFT || key == SDL_SCANCODE_LCTRL ||
           key == SDL_SCANCODE_RCTRL;
}

void PageShell::askForFrame() {
    if (!isOpen || asksFrame) return;
    asksFrame = true;
    const bool isHurried = pageProgram().isBeginning() || pageProgram().isSeeking();
    slicecastAskForFrame(isHurried ? 0 : 1);
}

}  // namespace

extern "C" {

// Replaces SDL's own (src/CMakeLists.txt), and returns the same: failure.
int __wrap_SDL_SetError(const char*, ...) {
    return -1;
}

// SDL would wait where another thread holds a lock. There is none, and a page cannot wait.
void __wrap_SDL_Delay(Uint32) {}

EMSCRIPTEN_KEEPALIVE void slicecastFrame(double timeMilliseconds) {
    shell().asksFrame = false;
    pageProgram().frame(timeMilliseconds * 0.001);
    if (pageProgram().wantsFrame()) shell().askForFrame();
}

// Returns whether the key is taken from the page. Flags: 1 Ctrl, 2 Alt, 4 Meta, 8 repeated.
EMSCRIPTEN_KEEPALIVE int slicecastKey(int isDown, int flags) {
    App& app = pageProgram();
    const bool ctrl = (flags & 1) != 0;
    const KeyPosition* position = findPosition(shell().code.data());
    if (isDown == 0) {
        if (position != nullptr) app.keyUp(position->scancode);
        return 0;
    }
    if ((flags & 4) != 0) {
        // While Meta is down, macOS sends no key-up events.
        app.releaseKeys();
        return 0;
    }
    if (position == nullptr || (flags & 2) != 0) return 0;
    const SDL_Scancode key = position->scancode;
    const std::optional<Action> action = app.keys().actionOf(key);
    if (!action) return 0;

    // Ctrl shortcuts belong to the browser. It has none with arrows, so those turn slowly.
    if (ctrl && !isShiftOrControl(key) && !isArrow(key)) return 0;
    app.keyDown(key, (flags & 8) != 0);
    return !ctrl && !isShiftOrControl(key) && action != Action::leave ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE void slicecastBlurred(void) {
    pageProgram().releaseKeys();
}

EMSCRIPTEN_KEEPALIVE void slicecastHidden(int hidden) {
    pageProgram().setHidden(hidden != 0);
}

// Returns whether the cursor's place is wanted.
EMSCRIPTEN_KEEPALIVE int slicecastPointerMoved(double right, double down) {
    pageProgram().pointerMoved(right, down);
    return pageProgram().cursorSteers() ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE void slicecastCursorAt(double x, double y) {
    pageProgram().cursorAt(x, y);
}

EMSCRIPTEN_KEEPALIVE void slicecastCursorLeft(void) {
    pageProgram().cursorLeft();
}

EMSCRIPTEN_KEEPALIVE void slicecastPointerHeld(int held) {
    pageProgram().pointerHeld(held != 0);
}

}  // extern "C"

App& pageProgram() {
    static App app(shell());
    return app;
}

void renewPageProgram() {
    App& app = pageProgram();
    shell() = PageShell();
    std::destroy_at(&app);
    std::construct_at(&app, shell());
}

bool beginPageProgram() {
    if (shell().isOpen) return true;
    if (!slicecastOpenCanvas(shell().code.data(), static_cast<int>(shell().code.size())))
        return false;
    // The first picture is drawn at once.
    shell().isOpen = true;
    slicecastFrame(slicecastNow());
    return true;
}

void endPageProgram() {
    if (!shell().isOpen) return;
    if (shell().asksFrame) slicecastForgetFrame();
    shell().asksFrame = false;
    pageProgram().releaseKeys();
    pageProgram().pointerHeld(false);
    shell().isOpen = false;
    slicecastCloseCanvas();
}

}  // namespace slicecast

#endif

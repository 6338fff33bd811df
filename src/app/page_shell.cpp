#include "app/page_shell.h"

#ifdef __EMSCRIPTEN__

#include <SDL2/SDL_surface.h>
#include <emscripten/emscripten.h>

#include <array>
#include <cstdint>
#include <cstdio>

// ---------------------------------------------------------------------------------------------- what only JavaScript can

// clang-format off

// Everything that is heard on the way in, before the page's own listeners; the C++ below decides which keys are taken from the page. `code` has room for
// the longest name of a key that it knows.
EM_JS(int, slicecastOpenCanvas, (char* code, int codeBytes), {
    const canvas = Module["canvas"];
    if (!canvas) return 0;
    if (!canvas.hasAttribute("tabindex")) canvas.tabIndex = 0;
    const listeners = new AbortController();
    const on = (target, type, hear) => target.addEventListener(type, hear, {signal: listeners.signal, capture: true});
    const screen = {context: canvas.getContext("2d", {alpha: false}), image: null, listeners, asks: false, held: false, lockEnd: -Infinity};

    const key = (event, isDown) => {
        stringToUTF8(event.code, code, codeBytes);
        const flags = (event.ctrlKey ? 1 : 0) | (event.altKey ? 2 : 0) | (event.metaKey ? 4 : 0) | (event.repeat ? 8 : 0);
        if (_slicecastKey(isDown, flags)) event.preventDefault();
    };
    on(canvas, "keydown", (event) => key(event, 1));
    on(canvas, "keyup", (event) => key(event, 0));
    on(canvas, "blur", () => _slicecastBlurred());
    on(document, "visibilitychange", () => _slicecastHidden(document.hidden ? 1 : 0));

    // -1 to 1 from edge to edge, where that is wanted.
    on(canvas, "mousemove", (event) => {
        if (!_slicecastPointerMoved(event.movementX, event.movementY)) return;
        const box = canvas.getBoundingClientRect();
        if (box.width > 0 && box.height > 0) _slicecastCursorAt(2 * (event.clientX - box.left) / box.width - 1, 2 * (event.clientY - box.top) / box.height - 1);
    });
    on(canvas, "mouseleave", () => _slicecastCursorLeft());

    // A press of the mouse gives the focus without scrolling, and so does a tap; a finger that moves on scrolls the page. A click asks for the pointer; where
    // that is refused, the cursor's place steers. A browser also refuses for a moment after Escape, which means nothing.
    const until = {signal: listeners.signal};
    canvas.addEventListener("pointerdown", (event) => event.pointerType !== "touch" && canvas.focus({preventScroll: true}), until);
    const holdsPointer = () => canvas.getRootNode().pointerLockElement === canvas;
    const refused = () => {
        if (screen.asks && !listeners.signal.aborted && performance.now() - screen.lockEnd > 2000) _slicecast_steerByCursor(1);
        screen.asks = false;
    };
    document.addEventListener("pointerlockerror", refused, until);
    on(document, "pointerlockchange", () => {
        if (holdsPointer()) screen.asks = false;
        else if (screen.held) screen.lockEnd = performance.now();
        screen.held = holdsPointer();
        _slicecastPointerHeld(screen.held ? 1 : 0);
    });
    canvas.addEventListener("click", (event) => {
        canvas.focus({preventScroll: true});
        if (event.pointerType && event.pointerType !== "mouse") return;
        if (holdsPointer()) return;
        screen.asks = true;
        if (!canvas.requestPointerLock) return refused();
        const asked = canvas.requestPointerLock();
        if (asked && asked.catch) asked.catch(refused);
    }, until);

    Module["slicecastScreen"] = screen;
    return 1;
});

EM_JS(void, slicecastCloseCanvas, (), {
    const canvas = Module["canvas"];
    if (canvas.getRootNode().pointerLockElement === canvas) document.exitPointerLock();
    Module["slicecastScreen"].listeners.abort();
    delete Module["slicecastScreen"];
});

// The image is a view on the surface's own memory; growing memory moves it.
EM_JS(void, slicecastShowPixels, (uint32_t address, int width, int height), {
    const screen = Module["slicecastScreen"];
    const start = address >>> 0;
    let image = screen.image;
    if (!image || image.data.buffer !== HEAPU8.buffer || image.data.byteOffset !== start || image.width !== width || image.height !== height) {
        image = screen.image = new ImageData(new Uint8ClampedArray(HEAPU8.buffer, start, width * height * 4), width, height);
    }
    screen.context.putImageData(image, 0, 0);
});

EM_JS(int, slicecastAskForFrame, (), { return requestAnimationFrame((time) => _slicecastFrame(time)); });
EM_JS(void, slicecastForgetFrame, (int frame), { cancelAnimationFrame(frame); });

EM_JS(void, slicecastLeaveCanvas, (), { Module["canvas"].blur(); });

// The names stand in the order of News.
EM_JS(void, slicecastTell, (int news, int yes), {
    const names = ["ready", "pause", "pointer", "cursor", "recording", "replay", "fly", "minimap", "help", "rate", "fullscreen", "record"];
    if (Module["onSlicecast"]) Module["onSlicecast"](names[news], yes !== 0);
});

EM_JS(void, slicecastTellShown, (int moved), {
    const hear = Module["onSlicecast"];
    if (!hear) return;
    if (moved) hear("view", true);
    hear("frame", true);
});

EM_JS(void, slicecastTellPortal, (const char* from, const char* to), {
    if (Module["onSlicecast"]) Module["onSlicecast"]("portal", {from: UTF8ToString(from), to: UTF8ToString(to)});
});

EM_JS(void, slicecastTellRates, (double framesPerSecond, double drawMilliseconds, double longestMilliseconds), {
    if (Module["onSlicecast"]) Module["onSlicecast"]("frames", {framesPerSecond, drawMilliseconds, longestMilliseconds});
});

EM_JS(void, slicecastTellSize, (int width, int height), {
    Module["canvas"].width = width;
    Module["canvas"].height = height;
    if (Module["onSlicecast"]) Module["onSlicecast"]("size", {width, height});
});

EM_JS(void, slicecastTellHits, (const char* json), {
    if (Module["onSlicecast"]) Module["onSlicecast"]("hits", JSON.parse(UTF8ToString(json)));
});

// clang-format on

namespace slicecast {

namespace {

class PageShell : public Shell {
public:
    double nowSeconds() const override { return emscripten_get_now() * 0.001; }
    void show(SDL_Surface& picture) override {
        slicecastShowPixels(static_cast<uint32_t>(reinterpret_cast<std::uintptr_t>(picture.pixels)), picture.w, picture.h);
    }
    void askForFrame() override;
    void tell(News news, bool yes) override { slicecastTell(static_cast<int>(news), yes); }
    void tellShown(bool moved) override { slicecastTellShown(moved); }
    void tellPortal(const std::string& from, const std::string& to) override { slicecastTellPortal(from.c_str(), to.c_str()); }
    void tellRates(const FrameRates& rates) override { slicecastTellRates(rates.framesPerSecond, rates.drawMilliseconds, rates.longestMilliseconds); }
    void tellSize(int width, int height) override { slicecastTellSize(width, height); }
    void tellHits(const std::string& json) override { slicecastTellHits(json.c_str()); }
    void leave() override { slicecastLeaveCanvas(); }

    bool isOpen = false;
    std::array<char, 32> code{};  // of the key that is told
    int frame = 0;                // the browser's number of the frame that was asked for; 0 where none was
};

PageShell& shell() {
    static PageShell theShell;
    return theShell;
}

// ------------------------------------------------------------------------------------------------- keys and mouse

bool isArrow(Action action) {
    return action == Action::turnLeft || action == Action::turnRight || action == Action::lookUp || action == Action::lookDown;
}

void PageShell::askForFrame() {
    if (isOpen && frame == 0) frame = slicecastAskForFrame();
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE void slicecastFrame(double timeMilliseconds) {
    shell().frame = 0;
    pageProgram().frame(timeMilliseconds * 0.001);
    if (pageProgram().wantsFrame()) shell().askForFrame();
}

// The answer is whether the key is taken from the page. Flags: 1 Ctrl, 2 Alt, 4 Meta, 8 repeated.
EMSCRIPTEN_KEEPALIVE int slicecastKey(int isDown, int flags) {
    App& app = pageProgram();
    const bool ctrl = (flags & 1) != 0;
    const Key* key = findKeyByCode(shell().code.data());
    if (isDown == 0) {
        if (key != nullptr) app.keyUp(*key);
        return 0;
    }
    if ((flags & 4) != 0) {
        // While Meta is down, macOS tells of no key that goes up.
        app.releaseKeys();
        return 0;
    }
    if (key == nullptr || (flags & 2) != 0) return 0;

    // Ctrl with another key is the browser's. The arrows mean nothing to it, so they turn slowly.
    const bool slow = key->action == Action::slow;
    if (ctrl && !slow && !isArrow(key->action)) return 0;
    app.keyDown(*key, (flags & 8) != 0);
    return !ctrl && !slow && key->action != Action::fast && key->action != Action::leave ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE void slicecastBlurred(void) {
    pageProgram().releaseKeys();
}

EMSCRIPTEN_KEEPALIVE void slicecastHidden(int hidden) {
    pageProgram().setHidden(hidden != 0);
}

// The answer is whether the cursor's place is wanted.
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

bool beginPageProgram() {
    if (shell().isOpen) return true;
    if (!slicecastOpenCanvas(shell().code.data(), static_cast<int>(shell().code.size()))) {
        std::fputs("slicecast: there is no canvas; give one as Module.canvas.\n", stderr);
        return false;
    }
    shell().isOpen = true;
    pageProgram().redraw();
    return true;
}

void endPageProgram() {
    if (!shell().isOpen) return;
    if (shell().frame != 0) slicecastForgetFrame(shell().frame);
    shell().frame = 0;
    pageProgram().releaseKeys();
    pageProgram().pointerHeld(false);
    shell().isOpen = false;
    slicecastCloseCanvas();
}

}  // namespace slicecast

#endif

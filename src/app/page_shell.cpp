#include "app/page_shell.h"

#ifdef __EMSCRIPTEN__

#include <SDL2/SDL.h>
#include <emscripten/emscripten.h>
#include <emscripten/html5.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <string_view>

// ---------------------------------------------------------------------------------------------- what only JavaScript can

// clang-format off

// SDL looks for "#canvas" in the document: it is told which canvas is meant, and gets an element of nobody's for its keys.
EM_JS(int, slicecastOpenCanvas, (), {
    const canvas = Module["canvas"];
    if (!canvas) return 0;
    specialHTMLTargets["#canvas"] = canvas;
    specialHTMLTargets["#no-keys"] = document.createElement("div");
    if (!canvas.hasAttribute("tabindex")) canvas.tabIndex = 0;

    // A press of the mouse gives the focus without scrolling, and so does a tap; a finger that moves on scrolls the page. A click asks for the pointer; where
    // that is refused, the cursor's place steers. A browser also refuses for a moment after Escape, which means nothing.
    const listeners = new AbortController();
    const until = {signal: listeners.signal};
    canvas.addEventListener("pointerdown", (event) => event.pointerType !== "touch" && canvas.focus({preventScroll: true}), until);
    const screen = {context: canvas.getContext("2d", {alpha: false}), image: null, listeners, asks: false, lockEnd: -Infinity};
    const refused = () => {
        if (screen.asks && !listeners.signal.aborted && performance.now() - screen.lockEnd > 2000) _slicecast_steerByCursor(1);
        screen.asks = false;
    };
    document.addEventListener("pointerlockerror", refused, until);
    canvas.addEventListener("click", (event) => {
        canvas.focus({preventScroll: true});
        if (event.pointerType && event.pointerType !== "mouse") return;
        if (canvas.getRootNode().pointerLockElement === canvas) return;
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

EM_JS(int, slicecastHoldsPointer, (), {
    const canvas = Module["canvas"];
    const holds = canvas.getRootNode().pointerLockElement === canvas;
    const screen = Module["slicecastScreen"];
    if (holds) screen.asks = false;
    else if (screen.held) screen.lockEnd = performance.now();
    screen.held = holds;
    return holds ? 1 : 0;
});

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
    void tellSize(int width, int height) override {
        SDL_SetWindowSize(window, width, height);
        slicecastTellSize(width, height);
    }
    void tellHits(const std::string& json) override { slicecastTellHits(json.c_str()); }
    void leave() override { slicecastLeaveCanvas(); }

    SDL_Window* window = nullptr;  // null unless the program runs
    int frame = 0;                 // the browser's number of the frame that was asked for; 0 where none was
};

PageShell& shell() {
    static PageShell theShell;
    return theShell;
}

// ------------------------------------------------------------------------------------------------- keys and mouse

bool isArrow(Action action) {
    return action == Action::turnLeft || action == Action::turnRight || action == Action::lookUp || action == Action::lookDown;
}

// The answer is whether the key is taken from the page.
EM_BOOL onKeyDown(int, const EmscriptenKeyboardEvent* event, void*) {
    App& app = pageProgram();
    if (event->metaKey) {
        // While Meta is down, macOS tells of no key that goes up.
        app.releaseKeys();
        return EM_FALSE;
    }
    const Key* key = findKeyByCode(event->code);
    if (key == nullptr || event->altKey) return EM_FALSE;

    // Ctrl with another key is the browser's. The arrows mean nothing to it, so they turn slowly.
    const bool slow = key->action == Action::slow;
    if (event->ctrlKey && !slow && !isArrow(key->action)) return EM_FALSE;
    app.keyDown(*key, event->repeat);
    return !event->ctrlKey && !slow && key->action != Action::fast && key->action != Action::leave;
}

EM_BOOL onKeyUp(int, const EmscriptenKeyboardEvent* event, void*) {
    if (const Key* key = findKeyByCode(event->code)) pageProgram().keyUp(*key);
    return EM_FALSE;
}

EM_BOOL onBlur(int, const EmscriptenFocusEvent*, void*) {
    pageProgram().releaseKeys();
    return EM_FALSE;
}

EM_BOOL onMouseMove(int, const EmscriptenMouseEvent* event, void*) {
    App& app = pageProgram();
    app.pointerMoved(static_cast<double>(event->movementX), static_cast<double>(event->movementY));
    double width = 0.0;
    double height = 0.0;
    if (app.cursorSteers() && emscripten_get_element_css_size("#canvas", &width, &height) == EMSCRIPTEN_RESULT_SUCCESS && width > 0.0 && height > 0.0) {
        app.cursorAt(2.0 * static_cast<double>(event->targetX) / width - 1.0, 2.0 * static_cast<double>(event->targetY) / height - 1.0);
    }
    return EM_FALSE;
}

EM_BOOL onMouseLeave(int, const EmscriptenMouseEvent*, void*) {
    pageProgram().cursorLeft();
    return EM_FALSE;
}

EM_BOOL onPointerLockChange(int, const EmscriptenPointerlockChangeEvent*, void*) {
    pageProgram().pointerHeld(slicecastHoldsPointer() != 0);
    return EM_FALSE;
}

EM_BOOL onVisibilityChange(int, const EmscriptenVisibilityChangeEvent* event, void*) {
    pageProgram().setHidden(event->hidden);
    return EM_FALSE;
}

// Removing takes away every listener of that kind, SDL's too, so it comes after SDL's end or where SDL's is not wanted.
void listen(bool on) {
    const char* canvas = "#canvas";
    void* app = nullptr;
    emscripten_set_keydown_callback(canvas, app, EM_TRUE, on ? onKeyDown : nullptr);
    emscripten_set_keyup_callback(canvas, app, EM_TRUE, on ? onKeyUp : nullptr);
    emscripten_set_blur_callback(canvas, app, EM_TRUE, on ? onBlur : nullptr);
    emscripten_set_mousemove_callback(canvas, app, EM_TRUE, on ? onMouseMove : nullptr);
    emscripten_set_mouseleave_callback(canvas, app, EM_TRUE, on ? onMouseLeave : nullptr);
    emscripten_set_pointerlockchange_callback(EMSCRIPTEN_EVENT_TARGET_DOCUMENT, app, EM_TRUE, on ? onPointerLockChange : nullptr);
    emscripten_set_visibilitychange_callback(app, EM_TRUE, on ? onVisibilityChange : nullptr);
}

EM_BOOL onAnimationFrame(double timeMilliseconds, void*) {
    shell().frame = 0;
    pageProgram().frame(timeMilliseconds * 0.001);
    if (pageProgram().wantsFrame()) shell().askForFrame();
    return EM_FALSE;
}

void PageShell::askForFrame() {
    if (window != nullptr && frame == 0) frame = emscripten_request_animation_frame(onAnimationFrame, nullptr);
}

}  // namespace

App& pageProgram() {
    static App app(shell());
    return app;
}

bool beginPageProgram() {
    if (shell().window != nullptr) return true;
    if (!slicecastOpenCanvas()) {
        std::fputs("slicecast: there is no canvas; give one as Module.canvas.\n", stderr);
        return false;
    }
    SDL_SetHint(SDL_HINT_EMSCRIPTEN_KEYBOARD_ELEMENT, "#no-keys");
    if (SDL_Init(SDL_INIT_VIDEO) == 0) {
        // A title would become the page's.
        shell().window = SDL_CreateWindow(nullptr, SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, pageProgram().width(), pageProgram().height(), 0);
    }
    if (shell().window == nullptr) {
        std::fprintf(stderr, "slicecast: SDL cannot use the canvas: %s\n", SDL_GetError());
        slicecastCloseCanvas();
        return false;
    }

    // SDL's own listeners take nothing from the page: what is not enabled is neither sent nor prevented.
    SDL_StopTextInput();
    for (const SDL_EventType type : std::to_array<SDL_EventType>(
             {SDL_MOUSEMOTION, SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP, SDL_MOUSEWHEEL, SDL_FINGERDOWN, SDL_FINGERUP, SDL_FINGERMOTION, SDL_WINDOWEVENT})) {
        SDL_EventState(type, SDL_IGNORE);
    }
    const char* canvas = "#canvas";
    emscripten_set_touchend_callback(canvas, nullptr, EM_FALSE, nullptr);
    emscripten_set_touchcancel_callback(canvas, nullptr, EM_FALSE, nullptr);
    emscripten_set_beforeunload_callback(nullptr, nullptr);

    listen(true);
    pageProgram().redraw();
    return true;
}

void endPageProgram() {
    if (shell().window == nullptr) return;
    if (shell().frame != 0) emscripten_cancel_animation_frame(shell().frame);
    shell().frame = 0;
    listen(false);
    pageProgram().releaseKeys();
    pageProgram().pointerHeld(false);
    SDL_DestroyWindow(shell().window);
    shell().window = nullptr;
    SDL_Quit();
    slicecastCloseCanvas();
}

}  // namespace slicecast

#endif

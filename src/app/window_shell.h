// The program in a window of the desktop.
//
// The window can have any size. A picture without a fixed size fills it, enlarged by a whole number
// on large screens. A picture of a fixed size is centred and enlarged by a whole number, with black
// around it.
#pragma once

#ifndef __EMSCRIPTEN__

#include "app/app.h"
#include "app/fit.h"

#include <SDL2/SDL.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace slicecast {

struct WindowSettings {
    std::optional<Size> picture;  // a fixed size of the picture
    bool fullscreen = false;
};

class WindowShell : public Shell {
public:
    explicit WindowShell(const WindowSettings& settings) : settings_(settings) {}
    ~WindowShell() override;

    // Opens the window. Empty on success, else an error message.
    std::string open(App& app, const std::string& title);

    // Plays until the window is closed. Calls `dropped` with each file that is dropped on the
    // window and `record` when the key for it is pressed.
    void run(const std::function<void(const std::filesystem::path&)>& dropped,
             const std::function<void()>& record);

    void setTitle(const std::string& title);
    // For some seconds, in the window.
    void showMessage(const std::string& text);

    double nowSeconds() const override;
    void show(SDL_Surface& picture) override;
    void askForFrame() override {}
    void tell(News news, bool yes) override;
    void tellShown(bool) override {}
    void tellPortal(const std::string&, const std::string&) override {}
    void tellRates(const FrameRates& rates) override { rates_ = rates; }
    void tellSize(int, int) override {}
    void tellHits(Session& game, int width, int height, int column) override;
    void leave() override;

private:
    struct DestroyWindow {
        void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    };

    struct CloseGamepad {
        void operator()(SDL_GameController* gamepad) const { SDL_GameControllerClose(gamepad); }
    };

    static constexpr std::size_t kNoPage = SIZE_MAX;

    std::string shownTitle() const;
    void showNews();
    Size windowSize() const;
    void fitPicture();
    void holdPointer(bool hold);
    void handle(const SDL_Event& event);
    void handleWindow(const SDL_WindowEvent& event);
    void readGamepad();
    void drawPanels(SDL_Surface& picture) const;

    WindowSettings settings_;
    App* app_ = nullptr;
    std::unique_ptr<SDL_Window, DestroyWindow> window_;
    std::unique_ptr<SDL_GameController, CloseGamepad> gamepad_;  // the one connected last
    std::string title_;
    SDL_Rect place_ = {};
    Size pictureSize_;
    std::filesystem::path dropped_;
    FrameRates rates_;
    bool running_ = false;
    bool recordAsked_ = false;
    std::size_t helpPage_ = kNoPage;
    bool showsRate_ = false;
    std::string message_;      // of the world's game or the program
    double messageEnd_ = 0.0;  // when it disappears, by nowSeconds
    int taken_ = 0;            // finds
    int finds_ = 0;            // of the world; 0 shows no count
};

}  // namespace slicecast

#endif

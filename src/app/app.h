// The program: plays one game at a time on one screen. It turns keys, mouse and time into steps of
// the session and draws the view into an SDL surface.
//
//     App app(shell);
//     app.play(std::make_unique<Session>(std::move(world)));
//     app.keyDown(SDL_SCANCODE_W, false);                as they come
//     app.frame(nowSeconds);                             as often as the screen can show a picture
#pragma once

#include "app/frame_meter.h"
#include "app/keys.h"
#include "app/pads.h"
#include "app/shell.h"
#include "app/step_clock.h"
#include "session/recording.h"
#include "session/session.h"

#include <SDL2/SDL_surface.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace slicecast {

inline constexpr double kDefaultDegreesPerPixel = 0.15;  // mouse
inline constexpr int kLargestPictureSide = 4096;         // pixels

class App {
public:
    explicit App(Shell& shell);

    // Plays this game from now on. What was recorded or replayed is over.
    void play(std::unique_ptr<Session> game);
    Session* game() { return game_.get(); }

    // Records the game, which has just begun, under its scene's name.
    void record(const std::string& scene);
    bool isRecording() const { return recorder_.has_value(); }
    // Ends it: what has been recorded, or nothing.
    std::optional<Recording> takeRecording();

    // Plays a recording in the game, which has just begun. Whoever moves takes over, but not by the
    // mouse alone.
    void replay(Recording recording);
    const Replay* replayed() const { return replay_ ? &*replay_ : nullptr; }

    // The size of the picture, clamped to what is allowed.
    void resize(int width, int height);
    int width() const { return width_; }
    int height() const { return height_; }

    void setPaused(bool paused);
    bool paused() const { return paused_; }

    // Nobody sees the screen: time stands still, no pictures are drawn, no key is held.
    void setHidden(bool hidden);

    // Mouse look: degrees for each pixel that the mouse moves (at most 0.5), and whether forward
    // looks down.
    void setMouse(double degreesPerPixel, bool invert);

    void keyDown(SDL_Scancode key, bool repeated);
    void keyUp(SDL_Scancode key);
    void releaseKeys();

    // What the keys do. Whoever changes it is told that no key is held any more.
    const KeyBindings& keys() const { return bindings_; }
    void setKeys(const KeyBindings& keys);

    // The mouse has moved, in pixels of the screen: right and down are positive. Only while it
    // looks around.
    void pointerMoved(double right, double down);
    void pointerHeld(bool held);
    bool holdsPointer() const { return pointerHeld_; }

    // A finger has dragged the picture, in pixels of the screen: like the mouse, whether held or
    // not.
    void dragged(double right, double down);
    // What thumbs on the screen hold down, until they hold down something else.
    void setThumbs(const Input& held) { thumbs_ = held; }
    // A gamepad as it is now. Without one, Gamepad().
    void setGamepad(const Gamepad& gamepad);

    // The cursor's place in the picture turns and looks (see cursorInput), for where the mouse
    // cannot be held, until the focus is lost.
    void setCursorSteering(bool on);
    bool cursorSteers() const { return cursorSteers_; }
    void cursorAt(double x, double y);
    void cursorLeft() { cursor_ = {}; }

    // One step, also while paused. What was replayed is over.
    void step(const Input& input);

    // Something has changed what is to be seen, so a picture is drawn even while paused.
    void redraw();

    // Whether there is anything for frame() to do. It becomes true only by calls of the shell's,
    // which is then asked for a frame.
    bool wantsFrame() const { return game_ && !hidden_ && (stale_ || !paused_); }

    // Plays the steps that are due and draws. True if there is a new picture on the screen. The
    // time is of the clock of Shell::nowSeconds: the moment for which the picture is meant.
    bool frame(double nowSeconds);

private:
    struct FreeSurface {
        void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
    };

    void act(Action action);
    bool actInGame(Action action);
    void look(double right, double down);
    void endReplay();
    Input takeInput();
    void play();
    void tellPortal();
    void changeOption(const ActionInfo& info);
    double optionNow(std::string_view option) const;
    void changeNumber(const char* option, int now, int by, int least, int greatest);
    void changeMinimapLevel(int by);
    void tellChanges();
    bool draw(double nowSeconds);

    Shell& shell_;
    std::optional<Recorder> recorder_;  // outlives the game, which writes to it
    std::optional<Replay> replay_;
    std::unique_ptr<Session> game_;
    std::unique_ptr<SDL_Surface, FreeSurface> surface_;
    int width_ = 640;
    int height_ = 400;
    KeyBindings bindings_;
    HeldKeys keys_;
    StepClock clock_;
    FrameMeter meter_;
    double degreesPerPixel_ = kDefaultDegreesPerPixel;
    bool invert_ = false;
    double turnDegrees_ = 0.0;  // by the mouse since the last step
    double lookHeights_ = 0.0;
    Input thumbs_;
    Input cursor_;
    Gamepad gamepad_;
    bool cursorSteers_ = false;
    bool paused_ = false;
    bool hidden_ = false;
    bool pointerHeld_ = false;
    bool stale_ = true;
    bool ready_ = false;
    std::optional<Eye> shownEye_;  // of the last picture
    bool toldFly_ = false;
    bool toldOverlay_ = false;
};

}  // namespace slicecast

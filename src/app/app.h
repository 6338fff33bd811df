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

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace slicecast {

inline constexpr double kDefaultDegreesPerPixel = 0.15;  // mouse
inline constexpr int kLargestPictureSide = 4096;         // pixels

// The first picture of a game is drawn in slices, so that a page stays alive meanwhile.
inline constexpr double kSliceSeconds = 0.008;
// A unit takes some 40 ns, so light takes as long as 12 simple frames in a picture, and 160 in the
// first one. Of scenes that need more, the rest of the light comes with the next pictures.
inline constexpr LightWork kLightOfPicture = 300'000;
inline constexpr LightWork kLightOfFirstPicture = 4'000'000;
// A later picture in which something has no light at all is not shown, but at most so many in turn:
// after a leap into another map, or another time of day, the next one has it all.
inline constexpr int kMostUnlitPictures = 8;

class App {
public:
    explicit App(Shell& shell);

    // Plays this game from now on. Ends recording and replay.
    void play(std::unique_ptr<Session> game);
    Session* game() { return game_.get(); }

    // Starts recording the game, which must have just begun, under its scene's name.
    void record(const std::string& scene);
    bool isRecording() const { return recorder_.has_value(); }
    // Stops recording and returns the recording, or nothing.
    std::optional<Recording> takeRecording();

    // Replays a recording in the game, which must have just begun. Any input of the player ends the
    // replay; the mouse alone does not.
    void replay(Recording recording);
    const Replay* replayed() const { return isReplaying_ ? &*replay_ : nullptr; }
    // Goes to the moment after so many steps of the recording, and replays on from there; also when
    // the replay has ended. The next frames do it, each in little more than kSliceSeconds, and show
    // no picture on the way. False without a recording, and while recording.
    bool seek(std::int64_t step);
    bool isSeeking() const { return seekedStep_.has_value(); }

    // The size of the picture, clamped to 1 to kLargestPictureSide.
    void resize(int width, int height);
    int width() const { return width_; }
    int height() const { return height_; }

    void setPaused(bool paused);
    bool paused() const { return paused_; }

    // While hidden, time stands still, nothing is drawn and no key is held.
    void setHidden(bool hidden);

    // Mouse look: degrees per pixel of mouse motion (at most 0.5), and whether moving it forward
    // looks down.
    void setMouse(double degreesPerPixel, bool invert);

    void keyDown(SDL_Scancode key, bool repeated);
    void keyUp(SDL_Scancode key);
    void releaseKeys();

    // The keys of all actions. Changing them releases all held keys.
    const KeyBindings& keys() const { return bindings_; }
    void setKeys(const KeyBindings& keys);

    // The mouse has moved, in pixels of the screen, right and down positive. Ignored unless the
    // pointer is held.
    void pointerMoved(double right, double down);
    void pointerHeld(bool held);
    bool holdsPointer() const { return pointerHeld_; }

    // A finger has dragged the picture, in pixels of the screen. Works like the mouse, whether the
    // pointer is held or not.
    void dragged(double right, double down);
    // The input of touch controls; it stays until the next call.
    void setThumbs(const Input& held) { thumbs_ = held; }
    // The gamepad's present state; Gamepad() without one.
    void setGamepad(const Gamepad& gamepad);

    // Steers by the cursor's place in the picture (see cursorInput) until the focus is lost. For
    // places where the mouse cannot be captured.
    void setCursorSteering(bool on);
    bool cursorSteers() const { return cursorSteers_; }
    void cursorAt(double x, double y);
    void cursorLeft() { cursor_ = {}; }

    // One step, also while paused. Ends a replay.
    void step(const Input& input);

    // Asks for a new picture, even while paused.
    void redraw();

    // Whether frame() has anything to do. Only calls of the shell can make it true; the shell is
    // then asked for a frame.
    bool wantsFrame() const { return game_ && !hidden_ && (stale_ || !paused_); }

    // Whether the game's first picture is being drawn: until it is shown, the screen keeps what it
    // shows, and time stands still. Each frame() draws a part of it within kSliceSeconds or little
    // more.
    bool isBeginning() const { return game_ && beginning_.has_value(); }

    // Plays the steps that are due and draws. True if the screen shows a new picture. `nowSeconds`
    // is the moment for which the picture is meant, by the clock of Shell::nowSeconds.
    bool frame(double nowSeconds);

private:
    struct FreeSurface {
        void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
    };

    void act(Action action);
    bool actInGame(Action action);
    void look(double right, double down);
    void beginReplay();
    void endReplay();
    __attribute__((noinline)) bool seekOn();  // no first picture needs it
    Input takeInput();
    void play();
    void tellStep();
    void changeOption(const ActionInfo& info);
    double optionNow(std::string_view option) const;
    void changeNumber(const char* option, int now, int by, int least, int greatest);
    void changeMinimapLevel(int by);
    void tellChanges();
    bool draw(double nowSeconds);
    bool drawBeginning(const Picture& picture);

    Shell& shell_;
    std::optional<Recorder> recorder_;  // outlives the game, which writes to it
    std::optional<Replay> replay_;      // also when it has ended, to go back to it
    bool isReplaying_ = false;
    std::optional<std::int64_t> seekedStep_;
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
    double turnDegrees_ = 0.0;  // turned by the mouse since the last step
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
    // The first picture of a game, as far as it is drawn.
    struct Beginning {
        int column = 0;
        LightWork lightLeft = 0;
    };
    std::optional<Beginning> beginning_;
    int unlitPictures_ = 0;        // in turn
    std::optional<Eye> shownEye_;  // of the last picture
    bool toldFly_ = false;
    bool toldOverlay_ = false;
};

}  // namespace slicecast

// What JavaScript may call in the WebAssembly module: the same functions serve a page, where the
// program draws into a canvas, and Node, where there is no canvas. Plain C; each function
// `slicecast_NAME` is `module._slicecast_NAME` in JavaScript.
//
//     const module = await createModule(program, {canvas, onSlicecast(event, value) {...}});   //
//     web/engine/engine-module.js; without a canvas under Node
//
//     const session = module._slicecast_programSession();                                     // or
//     module._slicecast_create() without the program {files, faults} =
//     JSON.parse(module.UTF8ToString(module._slicecast_parse(session, text, textBytes, name))); for
//     each of the files:    module._slicecast_supply(session, fileName, bytes, byteCount);  // no
//     call: the file could not be read {faults, warnings} =
//     JSON.parse(module.UTF8ToString(module._slicecast_start(session)));  // no faults: it plays
//     module._slicecast_begin();                                                              //
//     once, in a page: the program begins to draw and listen
//
// Strings in are UTF-8; those without a byte count end in a zero byte. What goes in is copied: the
// caller frees its own memory at once. Strings out belong to the session and hold until the next
// call for the same session that returns a string. A fault is
// {"file", "pointer", "line", "column", "row", "character", "found", "expected", "message"} as
// scene/scene.h describes it; `message` says all in one line.
//
// The program tells the page what happens by calling onSlicecast(event, value), if there is one:
//
//     "ready"       true          the first picture is on the canvas
//     "pause"       true, false   play stands still or goes on (P, slicecast_pause); a hidden tab
//     stands still without this event "pointer"     true, false   the canvas holds the pointer (a
//     click) or has lost it (Escape) "cursor"      true, false   the cursor's place in the picture
//     steers (N, or a refusal to hold the pointer), or not "recording"   true, false   the game is
//     recorded, or no more "replay"      true, false   a recording is played, or it is over: it has
//     ended, or somebody moves "fly"         true, false   fly or walk mode (V), after every
//     change; false in the beginning "overlay"     true, false   some overlay (a key of M, B, O, J,
//     U, G, K, Y) is on, or none, after every change; false in the beginning "help"        true H
//     was pressed: the page shows or hides the keys "rate"        true          I was pressed: the
//     page shows or hides the frame rate "fullscreen"  true          F was pressed: the page enters
//     or leaves full screen "record"      true          F9 was pressed: the page opens the scene
//     anew and records it, or saves what was recorded "hits"        {...}         T was pressed:
//     what the inspected slice meets, as slicecast_hits gives it "frames"      {"framesPerSecond",
//     "drawMilliseconds", "longestMilliseconds"}   twice a second, over the time since the last one
//     "frame"       true          a picture has been put on the canvas
//     "view"        true          before it: the eye is not where it was in the picture before
//     "portal"      {"from", "to"}   the player has gone through a portal; names of the maps, which
//     may be the same
//
// While it stands still or its page is hidden, the program asks for no frame of the browser's and
// no timer; whatever changes what is to be seen asks for one frame.
//
// The program looks after the input of its canvas, which the page makes focusable: it focuses it on
// a press, holds the pointer after a click, and takes the keys that it knows only while the canvas
// has the focus. Tab and anything with Ctrl, Alt or Meta stay the page's; Escape frees the pointer,
// then gives the focus back. Of the canvas's CSS size it takes only where in the picture the cursor
// is.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// A scene being loaded, or one running game with its world, player and options.
typedef struct SlicecastSession SlicecastSession;

// "1.2.3", the version of the project. Never freed.
const char* slicecast_version(void);

// A session without a game. Free it with slicecast_free.
SlicecastSession* slicecast_create(void);

// Ends a session that slicecast_create made, and all of its memory.
void slicecast_free(SlicecastSession* session);

// The session that the program shows. It exists from the beginning and is never freed.
SlicecastSession* slicecast_programSession(void);

// Checks the text of a scene; `fileName` stands in the faults. Gives {"files": [names of the images
// needed], "faults": [...]}. A game that is already running goes on until slicecast_start. What was
// supplied for an earlier text is forgotten.
const char* slicecast_parse(SlicecastSession* session, const char* text, int32_t textBytes,
                            const char* fileName);

// Supplies the bytes of one of those files, whose picture is decoded at once. Gives where its
// pixels are and how many bytes they have, R, G, B, A each; 0 where it is no picture, which is told
// by slicecast_start. With `blank` 1 nothing is decoded: the caller knows the pixels of these very
// bytes from another module, and writes them there. The place holds until the next call for the
// same session. A file never supplied becomes a fault ("could not be read").
const uint32_t* slicecast_supply(SlicecastSession* session, const char* fileName,
                                 const uint8_t* bytes, int32_t byteCount, int32_t blank);

// Builds the world and begins to play it. Gives {"faults": [...], "warnings": [...]}; with any
// fault the game that ran before, if any, goes on, warnings keep nothing from playing. Options are
// kept.
const char* slicecast_start(SlicecastSession* session);

// How much of the module's memory is in use, in bytes from its beginning. A module whose memory has
// been overwritten with that of another one of the same build then has the scene of the other's
// program by slicecast_adopt: from its start, with all options as in the beginning, and without a
// canvas. 1 on success, 0 if there was no game.
uint32_t slicecast_memoryEnd(void);
int32_t slicecast_adopt(void);

// The running world: {"title", "maps": [{"name", "width", "depth", "levels"}], "gates": how many};
// null without a game.
const char* slicecast_world(SlicecastSession* session);

// One step of exactly 1/120 s. Axes are -1 to 1: forward, strafe (right), turn (right), look (up),
// fly (up; negative crouches in walk mode). turnDegrees (right) and lookHeights (up, in screen
// heights) act at once, for a mouse. `buttons` is a sum of 1 = jump, 2 = fast, 4 = slow, 8 = open
// or close the gates within reach, 16 = open them, 32 = close them. Without a game: nothing. The
// program steps its own session by itself, and by this function also while it stands still; what it
// replayed is then over.
void slicecast_step(SlicecastSession* session, double forward, double strafe, double turn,
                    double look, double fly, double turnDegrees, double lookHeights,
                    int32_t buttons);

// Draws the view, `fraction` (0 to 1) of the way from the last step but one to the last, into the
// session's own picture. 1 on success, 0 if there is no game or the picture cannot be drawn (size
// not within 1 to 8192 pixels a side).
int32_t slicecast_draw(SlicecastSession* session, int32_t width, int32_t height, double fraction);

// The picture last drawn by slicecast_draw: width * height * 4 bytes R, G, B, A, rows from the top,
// no padding. Holds until the next slicecast_draw.
const uint8_t* slicecast_picture(SlicecastSession* session);

// Sets an option by name, as `--set` of the command line tools does. Gives "" on success, else what
// was wrong. Without a game the option waits for it.
const char* slicecast_setOption(SlicecastSession* session, const char* name, const char* value);

// The value of an option; "" where there is no such option.
const char* slicecast_option(SlicecastSession* session, const char* name);

// All options, in the order in which to list them: [{"name", "kind", "label", "group", "least",
// "greatest", "choices", "standard", "description", "value"}]. `label` is for a settings dialog;
// `group` is "view", "light", "overlays", "moving" or "classic". `kind` is "onOff", "number",
// "wholeNumber", "ownOrNumber" ("map" for each map's own value), "ownOrColour" ("map" or "#rrggbb")
// or "choice"; `least` and `greatest` bound the numbers, `choices` are a choice's words with a
// space between them.
const char* slicecast_options(SlicecastSession* session);

// Named settings of the classic method, as a person would ask for them ("Fish eye"): [{"name",
// "description", "options": {"classic.projection": "equalAngles"}}]. All options of the method that
// one does not name are as they are by default.
const char* slicecast_oldWays(SlicecastSession* session);

// What of the world the present method leaves out of the picture: a list of sentences, empty for
// the exact method and without a game.
const char* slicecast_leftOut(SlicecastSession* session);

// Where the player is, after the last step: {"map", "mapName", "x", "y", "z", "feet", "heading",
// "look", "speed", "flying", "swimming", "crouched", "onGround", "intensity", "multiplier",
// "steps", "fingerprint"}: map by its number, x, y, z of the eye and height of the feet in units,
// heading in degrees (0 = east, 90 = south), look in screen heights, speed in units per second. The
// fingerprint is the same text for the same state on every machine. null without a game.
const char* slicecast_state(SlicecastSession* session);

// The eye after the last step, cheap enough for every frame: map by its number, x, y, z, heading,
// look, as in slicecast_state. Holds until the next call. Null without a game.
const double* slicecast_view(SlicecastSession* session);

// Records the game, which has just begun, under the name of the scene's file without its ending.
// Nothing without a game.
void slicecast_record(SlicecastSession* session, const char* sceneName);

// Ends the recording and gives it as text; "" where nothing was recorded.
const char* slicecast_takeRecording(SlicecastSession* session);

// Checks the text of a recording, and keeps it if it has no faults: {"scene", "steps", "marks":
// [{"name", "step"}], "faults": [...]}. `fileName` stands in the faults.
const char* slicecast_readRecording(SlicecastSession* session, const char* text, int32_t textBytes,
                                    const char* fileName);

// Plays the recording that was read in the game, which has just begun. The program does so by
// itself from now on; another session step by step, by slicecast_replayStep. 1 on success, 0
// without a game or a recording.
int32_t slicecast_replay(SlicecastSession* session);

// Up to `count` steps of the replay. Gives how many there were; fewer at its end.
int32_t slicecast_replayStep(SlicecastSession* session, int32_t count);

// {"steps", "stepsDone", "isSame"}: how far a replay has come, and whether the eye was, at every
// mark so far, where it was when the recording was made. null where none is played.
const char* slicecast_replayState(SlicecastSession* session);

// Puts the player's eye somewhere else, flying; inside blocks and outside the grid too. 1 on
// success, 0 if such an eye cannot see (no such map, not above the floor).
int32_t slicecast_setEye(SlicecastSession* session, int32_t map, double x, double y, double z,
                         double headingDegrees, double look);

// Into a map by its number: to the scene's start if it lies in that map, else to the free tile
// nearest to the map's middle. 1 on success, 0 if there is no such map.
int32_t slicecast_goToMap(SlicecastSession* session, int32_t map);

// ---- Questions that figures ask. Those that give numbers have packed their answer as
// session/json_text.h says: slicecast_texts then gives the texts that stand in it, as a JSON list.
// Both hold until the next such call. Null without a game, and for what does not exist.

// The texts of the last packed answer, as a JSON list.
const char* slicecast_texts(SlicecastSession* session);

// Everything that columns of a picture of that size meet: an array of what session/hits_json.h
// describes. "scene" is the scene's title. Null if one of the columns does not exist.
const double* slicecast_hits(SlicecastSession* session, int32_t width, int32_t height,
                             const int32_t* columns, int32_t count);

// Everything that the renderer did for columns of a picture of that size: an array of what
// session/trace_json.h describes. Null if one of the columns does not exist.
const double* slicecast_trace(SlicecastSession* session, int32_t width, int32_t height,
                              const int32_t* columns, int32_t count);

// The same for a picture of that size as a whole, as JSON; "null" without a game.
const char* slicecast_traceFrame(SlicecastSession* session, int32_t width, int32_t height);

// A free ray, as session/cast_json.h describes it; without a height where z is not a number.
const double* slicecast_cast(SlicecastSession* session, int32_t map, double x, double y, double z,
                             double headingDegrees);

// What one pixel of a picture of that size shows, as session/pick.h describes it.
const double* slicecast_pick(SlicecastSession* session, int32_t width, int32_t height,
                             int32_t column, int32_t row);

// Where a point of the world lies in a picture of that size: x and y in pixels, and its depth. Null
// for one that is not before the eye, or in another map.
const double* slicecast_project(SlicecastSession* session, int32_t map, double x, double y,
                                double z, int32_t width, int32_t height);

// The rows of a map's levels, and the blocks of its legend, as JSON (session/cells_json.h); "null"
// if there is no such map.
const char* slicecast_cells(SlicecastSession* session, int32_t map);
const char* slicecast_blueprints(SlicecastSession* session, int32_t map);

// Changes a cell of the running world (session/edit_cells.h) until slicecast_reset; the character
// by its number in Unicode. The eye stays where it is. Gives "" on success, else what was wrong.
const char* slicecast_setCell(SlicecastSession* session, int32_t map, int32_t level, int32_t x,
                              int32_t y, int32_t character);

// Where a place of the world stands in a picture of that size, seen as the last picture was: x and
// y in pixels, perpendicular depth, and 1 if nothing covers it there, else 0
// (world/line_of_sight.h). Holds until the next call. Null for a place that is not before the eye,
// or in another map.
const double* slicecast_spot(SlicecastSession* session, int32_t map, double x, double y, double z,
                             int32_t width, int32_t height);

// Fly mode (1) or walk mode (0).
void slicecast_setFlying(SlicecastSession* session, int32_t flying);

// Back to the scene's start, at rest; every cell is as the scene has it.
void slicecast_reset(SlicecastSession* session);

// ---- The program in a page: these act on it and its session, also before it begins.

// The size of the picture in pixels, 1 to 4096 a side; the page scales the canvas with CSS. 640 x
// 400 until then.
void slicecast_resize(int32_t width, int32_t height);

// Stands still (1) or goes on (0).
void slicecast_pause(int32_t paused);

// 1 while it stands still by P or slicecast_pause.
int32_t slicecast_paused(void);

// Mouse look: degrees turned per CSS pixel of movement (0.15 until set), and whether moving the
// mouse forward looks down (1) rather than up (0).
void slicecast_setMouse(double degreesPerPixel, int32_t invert);

// A gamepad as it is now, by the web's standard mapping: sticks -1 to 1 to the right and down,
// triggers 0 to 1, bit n of the buttons for button n. Dead zones are the program's. All zero where
// there is none.
void slicecast_gamepad(double leftX, double leftY, double rightX, double rightY, double leftTrigger,
                       double rightTrigger, int32_t buttons);

// What thumbs on the screen hold, until the next call or the focus is lost: forward, strafe (right)
// and fly (up) from -1 to 1; buttons as in slicecast_step.
void slicecast_thumbs(double forward, double strafe, double fly, int32_t buttons);

// A finger has dragged the picture by so many CSS pixels: it turns and looks as the mouse does.
void slicecast_drag(double right, double down);

// Lets the cursor's place in the picture turn and look (1), or not (0): beyond a fifth of the way
// from the middle to an edge, more the further out.
void slicecast_steerByCursor(int32_t on);

// What the keys do, a line for each row of a help text: [{"keys": ["W", "S"], "does", "group",
// "scope", "actions": [{"name": "forward", "does", "press", "keys": [{"code": "KeyW", "label":
// "W"}]}]}] in the order in which to show them. `group` is "move", "look", "gates", "light", "show"
// or "program"; `scope` is "move", "element" or "page" (see app/actions.h); `press` is "hold",
// "press" or "repeat". A line without keys has none at the moment. Holds until the next call of
// these two.
const char* slicecast_keys(void);

// From now on a key (a KeyboardEvent.code) does that action and nothing else; "" for nothing at
// all. Gives "" on success, else what was wrong.
const char* slicecast_bindKey(const char* code, const char* action);

// Every key does what it does in the beginning.
void slicecast_standardKeys(void);

// The scope of what a key does; "" if it does nothing.
const char* slicecast_keyScope(const char* code);

// Begins to draw into the canvas and to listen to it; the second call does nothing. 0 if there is
// no canvas.
int32_t slicecast_begin(void);

// Ends the program: no picture, no listener, no timer remains, and the module may be dropped.
void slicecast_stop(void);

#ifdef __cplusplus
}
#endif

// The functions of the WebAssembly module for JavaScript. They serve both a page, where the
// program draws into a canvas, and Node, where there is no canvas. Plain C; each function
// `slicecast_NAME` is `module._slicecast_NAME` in JavaScript.
//
//     // web/engine/engine-module.js; under Node without a canvas
//     const module = await createModule(program, {canvas, onSlicecast(event, value) {...}});
//     // Without the program: module._slicecast_create()
//     const session = module._slicecast_programSession();
//     {files, faults} = JSON.parse(module.UTF8ToString(
//         module._slicecast_parse(session, text, textBytes, name)));
//     // For each of the files that could be read:
//     module._slicecast_supply(session, fileName, bytes, byteCount);
//     // Without faults it plays:
//     {faults, warnings} = JSON.parse(module.UTF8ToString(module._slicecast_start(session)));
//     // Once, in a page: the program starts to draw and listen
//     module._slicecast_begin();
//
// Strings passed in are UTF-8; those without a byte count end in a zero byte. Arguments are copied,
// so the caller may free its memory at once. Returned strings belong to the session and are valid
// until its next call that returns a string. A fault is
// {"file", "pointer", "line", "column", "row", "character", "found", "expected", "message"} as in
// scene/scene.h; `message` has all of it in one line.
//
// The program reports events to the page by calling onSlicecast(event, value), if it is given:
//
//     "ready"       true          the first picture is on the canvas
//     "pause"       true, false   paused or continued (P, slicecast_pause); a hidden tab pauses
//                                 without this event
//     "pointer"     true, false   the canvas has captured the pointer (a click) or lost it (Escape)
//     "cursor"      true, false   the cursor's place in the picture steers (N, or after a refusal
//                                 to capture the pointer), or not
//     "recording"   true, false   recording has started or stopped
//     "replay"      true, false   a replay has started, or ended by itself or by a player's input
//     "fly"         true, false   fly or walk mode (V), after every change; initially false
//     "overlay"     true, false   whether some overlay (keys M, B, O, J, U, G, K, Y) is on, after
//                                 every change; initially false
//     "help"        true          H was pressed: the page shows or hides the keys
//     "rate"        true          I was pressed: the page shows or hides the frame rate
//     "sound"       true          ; was pressed: the page switches its sound on or off
//     "fullscreen"  true          F was pressed: the page enters or leaves full screen
//     "record"      true          F9 was pressed: the page reopens the scene and records it, or
//                                 saves the recording
//     "hits"        {...}         T was pressed: the hits of the inspected slice, as slicecast_hits
//                                 returns them
//     "quest"       true          slicecast_news has something to tell
//     "frames"      {"framesPerSecond", "drawMilliseconds", "longestMilliseconds"}
//                                 twice a second, over the time since the last one
//     "frame"       true          a picture has been put on the canvas
//     "view"        true          before "frame": the eye has moved since the last picture
//     "portal"      {"from", "to"}   the player has gone through a portal; names of the maps, which
//                                 may be the same
//
// While it is paused or hidden, the program requests no frames and sets no timers; anything that
// changes the picture requests one frame.
//
// The program handles the input of its canvas, which the page makes focusable. It focuses the
// canvas on a press, captures the pointer after a click, and takes the keys that it knows only
// while the canvas has the focus. Tab and anything with Ctrl, Alt or Meta stay the page's; Escape
// releases the pointer, then gives the focus back. It uses the canvas's CSS size only to place the
// cursor in the picture.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// A scene that is being loaded, or a running game with its world, player and options.
typedef struct SlicecastSession SlicecastSession;

// "1.2.3", the version of the project. Never freed.
const char* slicecast_version(void);

// A session without a game. Free it with slicecast_free.
SlicecastSession* slicecast_create(void);

// Frees a session that slicecast_create made, with all of its memory.
void slicecast_free(SlicecastSession* session);

// The session of the program. It always exists and is never freed.
SlicecastSession* slicecast_programSession(void);

// Begins to check the text of a scene; `fileName` is used in the faults. The answer is {"files":
// [names of the images needed], "faults": [...]}. A running game continues until the end of
// slicecast_start. Forgets the images supplied for an earlier text, and what is still to do.
void slicecast_parse(SlicecastSession* session, const char* text, int32_t textBytes,
                     const char* fileName);

// Takes assets/pictures.json, the table of shipped pictures, or "{}" in its place, and keeps it. If
// the answer to slicecast_parse is {}, the scene needs it: then parse the scene again.
void slicecast_takePictures(SlicecastSession* session, const char* table, int32_t tableBytes);

// Does a small part of what slicecast_parse or slicecast_start has begun: some milliseconds, so
// that a page can do something else in between. Returns the share that is done: below 1, or 1 when
// slicecast_answer has the answer.
double slicecast_next(SlicecastSession* session);

// Instead of slicecast_next from slicecast_parse on: the session does not play what it loads, but
// more probable mistakes are looked for, also those that take long to find. The answer of
// slicecast_start is {"warnings": [...], "spares": [...]} then, without what loading warns of;
// spares are what nothing uses. A scene with faults has no mistakes. One session at a time; without
// a session it ends the search.
double slicecast_nextMistakes(SlicecastSession* session);

// Valid until the session's next answer of any kind.
const char* slicecast_answer(SlicecastSession* session);

// Supplies the bytes of one of those files and decodes the picture at once. Returns two numbers:
// the address of its pixels and their size in bytes (R, G, B, A for each pixel). Both are 0 if it
// is not a picture, which slicecast_start reports. With `blank` 1 it decodes nothing: the caller
// writes the pixels there, which another module has decoded from the same bytes. The address is
// valid until the session's next call. A file that is not supplied becomes a fault ("could not be
// read").
const uint32_t* slicecast_supply(SlicecastSession* session, const char* fileName,
                                 const uint8_t* bytes, int32_t byteCount, int32_t blank);

// Begins to build the world, which is played at the end. The answer is {"faults": [...],
// "warnings": [...]}. With any fault the game that ran before continues; warnings do not prevent
// playing. Options are kept. With `keepsLight` 1 pictures have the light of the game before until
// theirs is worked out: for a scene that has changed a little.
void slicecast_start(SlicecastSession* session, int32_t keepsLight);

// The size of the module's memory in use, in bytes from its start.
uint32_t slicecast_memoryEnd(void);

// Makes this module a copy of another one of the same build, after its memory has been overwritten
// with that of the other. Plays the other's scene from the beginning, with default options and
// without a canvas. 1 on success, 0 if the other had no game.
int32_t slicecast_adopt(void);

// The running world: {"title", "maps": [{"name", "width", "depth", "levels"}], "gates": how many};
// null without a game.
const char* slicecast_world(SlicecastSession* session);

// One step of exactly 1/120 s. Axes are -1 to 1: forward, strafe (right), turn (right), look (up),
// fly (up; negative crouches in walk mode). turnDegrees (right) and lookHeights (up, in screen
// heights) act at once, for a mouse. `buttons` is a sum of 1 = jump, 2 = fast, 4 = slow, 8 = open
// or close the gates within reach, 16 = open them, 32 = close them. Does nothing without a game.
// The program steps its own session by itself; this call adds a step, also while paused, and ends a
// replay.
void slicecast_step(SlicecastSession* session, double forward, double strafe, double turn,
                    double look, double fly, double turnDegrees, double lookHeights,
                    int32_t buttons);

// Draws the view between the last two steps into the session's own picture: `fraction` is 0 for the
// last step but one, 1 for the last. 1 on success, 0 if there is no game or the size is not 1 to
// 8192 pixels a side.
int32_t slicecast_draw(SlicecastSession* session, int32_t width, int32_t height, double fraction);

// The picture last drawn by slicecast_draw: width * height * 4 bytes R, G, B, A, rows from the top,
// no padding. Valid until the next slicecast_draw.
const uint8_t* slicecast_picture(SlicecastSession* session);

// Sets an option by name, like `--set` of the command line tools. Returns "" on success, else a
// message. Without a game the option is kept for the next one.
const char* slicecast_setOption(SlicecastSession* session, const char* name, const char* value);

// The value of an option; "" for an unknown name.
const char* slicecast_option(SlicecastSession* session, const char* name);

// All options, in the order of a list: [{"name", "kind", "label", "group", "least", "greatest",
// "choices", "standard", "description", "value"}]. `label` is for a settings dialog; `group` is
// "view", "light", "overlays", "moving" or "classic". `kind` is "onOff", "number", "wholeNumber",
// "ownOrNumber" ("map" for each map's own value), "ownOrColour" ("map" or "#rrggbb") or "choice";
// `least` and `greatest` bound the numbers, `choices` has a choice's words, separated by spaces.
const char* slicecast_options(SlicecastSession* session);

// Named settings of the classic method ("Fish eye"), each with the defect that it shows: [{"name",
// "description", "options": {"classic.projection": "equalAngles"}}]. All other options of the
// method have their defaults.
const char* slicecast_oldWays(SlicecastSession* session);

// The features of the world that the present method does not draw: a list of sentences, empty for
// the exact method and without a game.
const char* slicecast_leftOut(SlicecastSession* session);

// Draws a small picture of the scene with the options of the classic method, as they are, and one
// without them: the share of the pixels that look different, less close to a wall; then the view,
// as for slicecast_setEye, and 1 if it is one of a player who flies. The views are numbered from 0,
// which is the present one. Valid until the session's next slicecast_tryOldWay. Null behind the
// last view, and without a game.
const double* slicecast_tryOldWay(SlicecastSession* session, int32_t number);

// The player after the last step: {"map", "mapName", "x", "y", "z", "feet", "heading", "look",
// "speed", "flying", "swimming", "crouched", "onGround", "gate", "intensity", "multiplier",
// "steps", "fingerprint"}: the map's number, x, y, z of the eye and height of the feet in units,
// heading in degrees (0 = east, 90 = south), look in screen heights, speed in units per second;
// "gate" is "open" or "close" if the use key would do that, else "". The fingerprint is the same
// text for the same state on every machine. null without a game.
const char* slicecast_state(SlicecastSession* session);

// The eye after the last step, fast enough for every frame: map number, x, y, z, heading, look, as
// in slicecast_state. Valid until the session's next slicecast_view. Null without a game.
const double* slicecast_view(SlicecastSession* session);

// The world's game: what is to be found and reached, and how far the player is. What has happened
// in it since the last call. Both as JSON, see answers/quest_json.h; "null" without a game, and
// "[]".
const char* slicecast_game(SlicecastSession* session);
const char* slicecast_news(SlicecastSession* session);

// What the player hears, first what sounded once since the last call, then what lasts now: how many
// numbers follow, then for each sound its kind, material, gain and pan. Order, ranges and limits as
// in slicecast/sound.h and world/hearing.h. The first call begins to listen. Valid until the
// session's next slicecast_hear; no sounds without a game.
const double* slicecast_hear(SlicecastSession* session);

// Starts to record the game, which must have just begun. `sceneName` is the name of the scene's
// file without its extension. Does nothing without a game.
void slicecast_record(SlicecastSession* session, const char* sceneName);

// Stops recording and returns the text; "" if nothing was recorded.
const char* slicecast_takeRecording(SlicecastSession* session);

// Checks the text of a recording, and keeps it if it has no faults. Returns {"faults": [], "scene",
// "steps", "marks": [{"name", "step"}]}, or only {"faults": [...]}. `fileName` is used in the
// faults.
const char* slicecast_readRecording(SlicecastSession* session, const char* text, int32_t textBytes,
                                    const char* fileName);

// Replays the recording that was read, in the game, which must have just begun. The program plays
// it by itself; other sessions step it by slicecast_replayStep. 1 on success, 0 without a game or a
// recording.
int32_t slicecast_replay(SlicecastSession* session);

// Plays up to `count` steps of the replay. Returns how many it played; fewer at the end.
int32_t slicecast_replayStep(SlicecastSession* session, int32_t count);

// {"steps", "stepsDone", "isSame", "isSeeking"}: the length of the replay, its progress, whether
// the eye was at the recorded place at every mark so far, and whether slicecast_seekReplay is still
// on its way. null if there is no replay.
const char* slicecast_replayState(SlicecastSession* session);

// Goes to the moment after so many steps of the recording, and replays on from there; also when the
// replay has ended. The program does it in its next frames, other sessions at once. 1 on success, 0
// without a recording and while recording.
int32_t slicecast_seekReplay(SlicecastSession* session, int32_t step);

// Puts the player's eye somewhere else, flying; also inside blocks and outside the grid. Where the
// eye already is, the player only turns. 1 on success, 0 if the eye would see nothing (no such map,
// not above the floor).
int32_t slicecast_setEye(SlicecastSession* session, int32_t map, double x, double y, double z,
                         double headingDegrees, double look);

// Ends flying, or moves a player without room to the nearest ground: 0 if there is none, 1 if the
// player now stands or swims where the eye was, 2 if they fall from there, 3 on the nearest ground.
int32_t slicecast_land(SlicecastSession* session);

// Moves the player into a map by its number: to the scene's start if it lies in that map, else to
// the free tile nearest to the map's middle. 1 on success, 0 if there is no such map.
int32_t slicecast_goToMap(SlicecastSession* session, int32_t map);

// ---- Questions of figures. slicecast_hits, _trace, _cast and _pick return packed answers, as
// numbers (answers/json_text.h); slicecast_texts then returns the texts in them. Both are valid
// until the next packed answer. Null without a game, and for things that do not exist.

// The texts of the last packed answer, as a JSON list.
const char* slicecast_texts(SlicecastSession* session);

// What columns of a picture of this size meet: an array of the objects of answers/hits_json.h.
// "scene" is the scene's title. Null if one of the columns does not exist, or for more of them than
// the widest picture has.
const double* slicecast_hits(SlicecastSession* session, int32_t width, int32_t height,
                             const int32_t* columns, int32_t count);

// All that the renderer did for columns of a picture of this size: an array of the objects of
// answers/trace_json.h. Null if one of the columns does not exist, or for more of them than the
// widest picture has.
const double* slicecast_trace(SlicecastSession* session, int32_t width, int32_t height,
                              const int32_t* columns, int32_t count);

// The same for a whole picture of this size, as JSON; "null" without a game.
const char* slicecast_traceFrame(SlicecastSession* session, int32_t width, int32_t height);

// What a ray from any point meets, see answers/cast_json.h; a ray without a height if z is NaN.
const double* slicecast_cast(SlicecastSession* session, int32_t map, double x, double y, double z,
                             double headingDegrees);

// What one pixel of a picture of this size shows, see answers/pick.h.
const double* slicecast_pick(SlicecastSession* session, int32_t width, int32_t height,
                             int32_t column, int32_t row);

// Where a point of the world lies in a picture of this size, seen from the eye after the last step:
// x and y in pixels, and its depth in units. Valid until the next slicecast_project or
// slicecast_spot. Null for a point in another map, or not in front of the eye.
const double* slicecast_project(SlicecastSession* session, int32_t map, double x, double y,
                                double z, int32_t width, int32_t height);

// The rows of a map's levels, and the blocks of its legend, as JSON (answers/cells_json.h); "null"
// if there is no such map.
const char* slicecast_cells(SlicecastSession* session, int32_t map);
const char* slicecast_blueprints(SlicecastSession* session, int32_t map);

// Changes cells of the running world (session/edit_cells.h) until slicecast_reset, all or none.
// `cells` has four numbers for each: level, x, y and the index of its sign; `signs` are UTF-8, one
// behind the other, each with a zero byte at its end, as many as the greatest index needs. The eye
// stays where it is. Returns "" on success, else a message.
const char* slicecast_setCells(SlicecastSession* session, int32_t map, const int32_t* cells,
                               int32_t count, const char* signs);

// Draws lines over the picture from now on, instead of those before (overlay/marks.h): for each,
// the number of its map, x, y and z of its ends, and its colour as 0xrrggbb. Another scene has
// none.
void slicecast_mark(SlicecastSession* session, const double* lines, int32_t count);

// Where a place of the world appears in a picture of this size, seen from the eye of the last
// picture. The numbers are those of slicecast_project, then 1 if the place is inside the picture
// and nothing hides it, else 0 (world/line_of_sight.h).
const double* slicecast_spot(SlicecastSession* session, int32_t map, double x, double y, double z,
                             int32_t width, int32_t height);

// Fly mode (1) or walk mode (0).
void slicecast_setFlying(SlicecastSession* session, int32_t flying);

// Back to the scene's start, standing; every cell is as the scene has it.
void slicecast_reset(SlicecastSession* session);

// ---- The program in a page: these act on the program and its session, also before it starts.

// The size of the picture in pixels, 1 to 4096 a side, initially 640 x 400; the page scales the
// canvas with CSS.
void slicecast_resize(int32_t width, int32_t height);

// Pauses (1) or continues (0).
void slicecast_pause(int32_t paused);

// 1 while paused by P or slicecast_pause.
int32_t slicecast_paused(void);

// Mouse look: degrees per CSS pixel of motion (initially 0.15), and whether moving the mouse
// forward looks down (1) or up (0).
void slicecast_setMouse(double degreesPerPixel, int32_t invert);

// The gamepad's present state in the web's standard mapping: sticks -1 to 1, right and down
// positive, triggers 0 to 1, bit n of the buttons for button n. The program applies dead zones. All
// zero without a gamepad.
void slicecast_gamepad(double leftX, double leftY, double rightX, double rightY, double leftTrigger,
                       double rightTrigger, int32_t buttons);

// What touch controls hold, until the next call or until the focus is lost: forward, strafe (right)
// and fly (up) from -1 to 1; buttons as in slicecast_step.
void slicecast_thumbs(double forward, double strafe, double fly, int32_t buttons);

// A finger has dragged the picture by this many CSS pixels; turns and looks like the mouse.
void slicecast_drag(double right, double down);

// Steers by the cursor's place in the picture (1), or not (0). It turns and looks beyond a fifth of
// the way from the middle to an edge, faster further out.
void slicecast_steerByCursor(int32_t on);

// All keys, one object for each row of a help text: [{"keys": ["W", "S"], "does", "group", "scope",
// "actions": [{"name": "forward", "does", "press", "keys": [{"code": "KeyW", "label": "W"}]}]}], in
// the order of the help. `group` is "move", "look", "gates", "light", "show" or "program"; `scope`
// is "move", "element" or "page" (see app/actions.h); `press` is "hold", "press" or "repeat".
// `keys` is empty for actions that have no key at present. This string and that of
// slicecast_bindKey belong to the program's session.
const char* slicecast_keys(void);

// Binds a key (a KeyboardEvent.code) to an action instead of its present one; "" removes that.
// Returns "" on success, else a message.
const char* slicecast_bindKey(const char* code, const char* action);

// Restores the standard keys.
void slicecast_standardKeys(void);

// The scope of a key's action; "" if it has none. Never freed.
const char* slicecast_keyScope(const char* code);

// Starts to draw into the canvas and to listen to it; a second call does nothing. 0 if there is no
// canvas.
int32_t slicecast_begin(void);

// Stops the program: no picture, listener or timer remains, and the module may be dropped.
void slicecast_stop(void);

#ifdef __cplusplus
}
#endif

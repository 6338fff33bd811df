// One running engine: the WebAssembly module of src/wasm/bindings.h with JavaScript's names and
// types.
//
//     const engine = await Engine.create({files, canvas, onEvent(event, value) {...}});
//     const faults = await engine.loadScene(source);    // a source, as in source-parts.js
//     engine.begin();                                   // draws, and listens to the canvas
//     engine.setOption('fov', 75);
//     engine.rest();                                    // until it is asked for anything
//     engine.stop();                                    // frees everything
//
// Without a canvas it draws only on request (drawOnce). Any number of engines run side by side and
// share the compiled program.

import { createModule, createModuleNow } from './engine-module.js';
import { withBytes, withStrings } from './module-memory.js';
import { misread, unknown } from './nearest-name.js';
import { Pauses } from './pauses.js';
import { kShippedTable } from './source-parts.js';
import { Trouble } from './trouble.js';

const kAxes = ['forward', 'strafe', 'turn', 'look', 'fly'];
const kMostSteps = 120 * 3600; // per call: an hour of the world's time
// Of the progress of loading; the rest makes the world.
const kTextShare = 0.1;
const kFilesShare = 0.8;
const kAdoptedSlack = 16 << 20; // bytes that playing may add to the scene: picture and view tables
const kLandings = ['none', 'stands', 'falls', 'moved']; // as in src/session/session.h
const kButtons = { jump: 1, fast: 2, slow: 4, use: 8, open: 16, close: 32 };

export class Engine {
  #running; // the module; null while it rests, and once stopped
  #resting = null; // then its memory
  #session;
  #files;
  #page; // what its modules get
  #begun = false;
  #loads = 0;
  #tasks = 0; // that use the module, and last
  #mapNames = [];
  #startMap = 0; // index of the start's map
  #sceneEnd = 0; // end of used memory right after the scene had loaded

  static async create({ files, canvas = null, onEvent = () => {}, takesKey }) {
    let engine;
    const onSlicecast = (event, value) =>
      onEvent(event, event === 'hits' ? engine.#hitsOf(value) : value);
    try {
      const { program, openCanvas, later } = files;
      const page = { canvas, openCanvas, onSlicecast, takesKey, later };
      engine = new Engine(await createModule(program, page), canvas);
      engine.#files = files;
      engine.#page = page;
      engine.Questions = files.Questions ?? null;
      return engine;
    } catch (error) {
      throw new Trouble('The engine does not start', error.message);
    }
  }

  warnings = []; // of the current scene, in the form of faults
  Questions = null; // the class of questions.js, which no first picture needs

  constructor(module, canvas) {
    this.#running = module;
    this.#session =
      canvas === null ? module._slicecast_create() : module._slicecast_programSession();
    this.canvas = canvas;
  }

  get #module() {
    if (this.#resting !== null) this.#wake();
    if (this.#running === null) throw new Error('This engine has been stopped.');
    return this.#running;
  }

  // Returns the scene's faults; an empty list means that it plays now. A scene with faults leaves
  // the running game alone. Returns null if another scene was requested meanwhile or `isWanted`
  // returns false. With `keepEye` the player stays where they are, if the new scene has that
  // place, and light is shown as it was until it is made anew.
  // `onProgress` gets the loaded share, 0 to 1, and the number of bytes. Afterwards `warnings`
  // lists probable mistakes in the scene.
  loadScene(source, how = {}) {
    return this.#during(() => this.#loadScene(source, how));
  }

  async #loadScene(source, { onProgress, keepEye = false, isWanted = () => true }) {
    const load = ++this.#loads;
    const isLatest = () => load === this.#loads && isWanted();
    const loading = new SceneLoading(this, this.#module, this.#session, isLatest);
    const names = await loading.readNames(source, onProgress);
    if (names === null) return null;
    await loading.supplyFiles(names.files, source, onProgress);
    if (!isLatest()) return null;
    const eye = keepEye ? this.state : null;
    const result = await loading.start(onProgress, keepEye);
    if (result === null) return null;
    const { faults, warnings } = result;
    this.warnings = warnings;
    if (faults.length === 0) {
      this.#mapNames = this.world.maps.map(({ name }) => name);
      this.#startMap = this.state.map;
      this.#sceneEnd = this.#module._slicecast_memoryEnd();
    }
    if (eye !== null && faults.length === 0) this.restore(eye);
    return faults;
  }

  // Takes over the scene of another engine of the same build, from its start, by copying its
  // memory: a fraction of the time of loading. Call it before begin() and while nothing loads.
  // Returns false if the other engine has no scene or has used much more memory since it loaded.
  adopt(other) {
    const memory = other?.#memory ?? null;
    if (memory === null) return false;
    const end = memory.length;
    if (end > other.#sceneEnd + kAdoptedSlack) return false;
    if (
      end > this.memoryBytes &&
      this.#module._malloc(end - this.#module._slicecast_memoryEnd()) === 0
    )
      return false;
    this.#module.HEAPU8.set(memory);
    this.warnings = other.warnings;
    this.#mapNames = other.#mapNames;
    this.#startMap = other.#startMap;
    this.#sceneEnd = other.#sceneEnd;
    return this.#module._slicecast_adopt() === 1;
  }

  // Gives back the module, of which a browser can have only some hundred, and keeps its memory. The
  // canvas keeps the picture. Whatever is asked next wakes it, as it was, and tells the event
  // 'wake'. Returns false if it cannot rest: before its first picture, and while it plays.
  rest() {
    const module = this.#running;
    if (!this.#begun || module === null || this.#files.canCompileNow !== true) return false;
    if (this.#tasks > 0 || module._slicecast_paused() === 0) return false;
    if (this.canvas.ownerDocument.hidden) return false; // nothing is drawn
    if (module.awaitsFrame) module.frameNow(performance.now());
    if (module.awaitsFrame) return false;
    module._slicecast_stop();
    this.#resting = this.#memory.slice();
    this.#running = null;
    // Else the canvas would stay black.
    this.canvas.addEventListener('contextrestored', this.#drawAnew);
    return true;
  }

  get rests() {
    return this.#resting !== null;
  }

  #wake() {
    const memory = this.#resting;
    this.#page.onSlicecast('wake', true);
    this.#running = createModuleNow(this.#files.program, this.#page, memory);
    this.#resting = null;
    this.canvas.removeEventListener('contextrestored', this.#drawAnew);
    this.#running._slicecast_begin();
  }

  #drawAnew = () => {
    const { width, height } = this.canvas;
    this.resize(width, height);
    this.drawNow(performance.now());
  };

  // A module in use does not rest.
  async #during(act) {
    this.#tasks += 1;
    try {
      return await act();
    } finally {
      this.#tasks -= 1;
    }
  }

  // All that the scene and the game need.
  get #memory() {
    const module = this.#running;
    return this.#resting ?? module?.HEAPU8.subarray(0, module._slicecast_memoryEnd()) ?? null;
  }

  // Whether the whole program is there.
  get isComplete() {
    return this.#module.isComplete;
  }

  // Loads the rest of the program, if there is one. Throws a Trouble.
  async complete() {
    await this.#files.later?.load();
    await this.#running?.complete();
  }

  // Starts drawing into the canvas and listening to it. Later calls do nothing.
  begin() {
    if (this.#begun) return;
    if (this.#module._slicecast_begin() === 0) throw new Error('There is no canvas.');
    this.#begun = true;
  }

  get hasBegun() {
    return this.#begun;
  }

  // Looks for probable mistakes in a scene: see questions.js.
  findMistakes(source, isWanted) {
    return this.#during(() =>
      this.questions.findMistakes(source, isWanted, (...where) => new SceneLoading(this, ...where)),
    );
  }

  // Draws the current view in any size: ImageData, or null without a game.
  drawOnce(width, height, fraction = 1) {
    return imageOf(this.drawPixels(width, height, fraction), width, height);
  }

  // The same as bytes, for environments without ImageData.
  drawPixels(width, height, fraction = 1) {
    return drawPixels(this.#module, this.#session, width, height, fraction);
  }

  // Draws the view once in that size; returns the milliseconds, or null without a game.
  timeDrawing(width, height) {
    const begin = performance.now();
    const isDrawn = this.#module._slicecast_draw(this.#session, width, height, 1) === 1;
    return isDrawn ? performance.now() - begin : null;
  }

  // Advances the world by steps of exactly 1/120 s, also while paused; draws the last one's view.
  // The input is held during all steps: {forward, strafe, turn, look, fly} from -1 to 1, {jump,
  // fast, slow, use, open, close} true or false. Ends a replay.
  step(input = {}, count = 1) {
    const [axes, buttons] = readInput(input);
    if (!Number.isInteger(count) || count < 0 || count > kMostSteps)
      throw misread('step', `count ${count}`, `a whole number from 0 to ${kMostSteps}`);
    for (let i = 0; i < count; ++i)
      this.#module._slicecast_step(this.#session, ...axes, 0, 0, buttons);
  }

  // Takes the options of `--set`; true and false mean "on" and "off". Throws if the engine refuses
  // the name or value.
  setOption(name, value) {
    const text = value === true ? 'on' : value === false ? 'off' : String(value);
    const refusal = withStrings(this.#module, [name, text], (nameAt, valueAt) =>
      this.#module.UTF8ToString(this.#module._slicecast_setOption(this.#session, nameAt, valueAt)),
    );
    if (refusal !== '') throw new Error(refusal);
  }

  option(name) {
    return withStrings(this.#module, [name], (nameAt) =>
      this.#module.UTF8ToString(this.#module._slicecast_option(this.#session, nameAt)),
    );
  }

  // The same, but throws for an unknown option.
  knownOption(name) {
    const value = this.option(name);
    if (value !== '') return value;
    throw new Error(
      unknown(
        'option',
        String(name),
        this.options.map((option) => option.name),
      ),
    );
  }

  // All options in the order to list them: [{name, kind, least, greatest, choices: [...], standard,
  // description, value}] (src/wasm/bindings.h).
  get options() {
    return this.#json(this.#module._slicecast_options(this.#session)).map((option) => ({
      ...option,
      choices: option.choices.split(' ').filter(Boolean),
    }));
  }

  // Presets of the classic method: [{name, description, options: {name: value}}]. Options that a
  // preset does not name have their standard values.
  get oldWays() {
    return this.#json(this.#module._slicecast_oldWays(this.#session));
  }

  // Sentences: what the current method leaves out of the picture.
  get leftOut() {
    return this.#json(this.#module._slicecast_leftOut(this.#session));
  }

  // {title, maps: [{name, width, depth, levels}]}, or null.
  get world() {
    return this.#json(this.#module._slicecast_world(this.#session));
  }

  // {map, x, y, z, heading, look, flying, steps}, or null.
  get state() {
    return this.#json(this.#module._slicecast_state(this.#session));
  }

  // The world's game, {aim, finds, of, ...} as in src/answers/quest_json.h, or null.
  get game() {
    return this.#json(this.#module._slicecast_game(this.#session));
  }

  // What has happened in it since the last call: [{kind, text, name, finds, of, seconds}].
  takeNews() {
    return this.#json(this.#module._slicecast_news(this.#session));
  }

  // The eye after the last step: {map (its name), x, y, z, heading, look}, or null. Cheap enough to
  // read every frame.
  get view() {
    const at = this.#module._slicecast_view(this.#session);
    if (at === 0) return null;
    const [map, x, y, z, heading, look] = new Float64Array(this.#module.HEAPU8.buffer, at, 6);
    return { map: this.#mapNames[map], x, y, z, heading, look };
  }

  // What the player hears, from the first call on, as numbers for web/sound/heard.js.
  get heard() {
    const { HEAPU8, _slicecast_hear: hear } = this.#module;
    const at = hear(this.#session);
    const [count] = new Float64Array(HEAPU8.buffer, at, 1);
    return new Float64Array(HEAPU8.buffer, at + 8, count).slice();
  }

  // Where a place {x, y, z, map} appears in the last picture, scaled to {width, height}: {x, y,
  // depth, isSeen}; null if it is behind the eye or in another map. `map` is a name; null means the
  // map of the start.
  spot({ x, y, z, map }, { width, height }) {
    const index = map === null ? this.#startMap : this.#mapNames.indexOf(map);
    const at = this.#module._slicecast_spot(this.#session, index, x, y, z, width, height);
    if (at === 0) return null;
    const [column, row, depth, seen] = new Float64Array(this.#module.HEAPU8.buffer, at, 4);
    return { x: column, y: row, depth, isSeen: seen === 1 };
  }

  // Moves the eye; fields that the view leaves out stay, and so does walking or flying. An eye that
  // stays where it is only turns. Returns false if there is no room for the eye.
  look(view) {
    const state = this.state;
    if (state === null) return false;
    const changes = Object.fromEntries(
      Object.entries(view).filter(([, value]) => (value ?? null) !== null),
    );
    if (changes.map !== undefined) changes.map = this.#mapNames.indexOf(changes.map);
    return this.restore({ ...state, ...changes });
  }

  // Ends flying where the eye is, or on the nearest ground if there is no room: 'stands' (or swims)
  // or 'falls' there, 'moved', or 'none' in a map without ground.
  land() {
    return kLandings[this.#module._slicecast_land(this.#session)];
  }

  // Draws changes already in the frame that began at that time, not in the next one.
  drawNow(time) {
    this.#module.frameNow(time);
  }

  // True for fly mode, false for walk mode.
  set flying(flying) {
    this.#module._slicecast_setFlying(this.#session, flying ? 1 : 0);
  }

  // Records the game that was just loaded. `sceneName` is the name of the scene's file.
  record(sceneName) {
    withStrings(this.#module, [sceneName], (nameAt) =>
      this.#module._slicecast_record(this.#session, nameAt),
    );
  }

  // Ends the recording and returns its text, or '' if there was none.
  takeRecording() {
    return this.#module.UTF8ToString(this.#module._slicecast_takeRecording(this.#session));
  }

  // Checks a recording: {scene, steps, marks: [{name, step}], faults}. Keeps it for replay() if it
  // has no faults.
  readRecording(bytes, name) {
    return withBytes(this.#module, bytes, (at) =>
      withStrings(this.#module, [name], (nameAt) =>
        this.#json(this.#module._slicecast_readRecording(this.#session, at, bytes.length, nameAt)),
      ),
    );
  }

  // Replays the recording in the game that was just loaded; any movement of the player takes over.
  // Returns false without a recording.
  replay() {
    return this.#module._slicecast_replay(this.#session) === 1;
  }

  // Goes to the moment after so many steps of the recording, and replays on from there; also when
  // the replay has ended. Returns false without a recording, and while recording.
  seek(step) {
    if (!(step >= 0)) throw misread('seek', step, 'a number of steps');
    return this.#module._slicecast_seekReplay(this.#session, step) === 1;
  }

  // {steps, stepsDone, isSame, isSeeking}, or null if nothing is replayed.
  get replayState() {
    return this.#json(this.#module._slicecast_replayState(this.#session));
  }

  // Moves the eye to where a state says, walking or flying as there. Returns false if there is no
  // room for it.
  restore({ map, x, y, z, heading, look, flying }) {
    if (this.#module._slicecast_setEye(this.#session, map, x, y, z, heading, look) === 0)
      return false;
    this.#module._slicecast_setFlying(this.#session, flying ? 1 : 0);
    return true;
  }

  #hitsOf({ width, height, column }) {
    return this.questions.hits(width, height, column);
  }

  // Questions about rays, pixels, points and cells.
  get questions() {
    return new this.Questions(this.#module, this.#session, this.#mapNames);
  }

  reset() {
    this.#module._slicecast_reset(this.#session);
  }

  // The picture's size in pixels.
  resize(width, height) {
    this.#module._slicecast_resize(width, height);
  }

  set paused(paused) {
    if (paused && this.rests) return;
    this.#module._slicecast_pause(paused ? 1 : 0);
  }

  get paused() {
    return this.#module._slicecast_paused() === 1;
  }

  setMouse({ degreesPerPixel, invert }) {
    this.#module._slicecast_setMouse(degreesPerPixel, invert ? 1 : 0);
  }

  // A gamepad as gamepads.js describes it.
  setGamepad({ leftX, leftY, rightX, rightY, leftTrigger, rightTrigger, buttons }) {
    this.#module._slicecast_gamepad(
      leftX,
      leftY,
      rightX,
      rightY,
      leftTrigger,
      rightTrigger,
      buttons,
    );
  }

  // What thumbs hold on the touch screen, until the next call.
  setThumbs({ forward = 0, strafe = 0, fly = 0, jump = false, fast = false, use = false }) {
    this.#module._slicecast_thumbs(
      forward,
      strafe,
      fly,
      (jump ? 1 : 0) + (fast ? 2 : 0) + (use ? 8 : 0),
    );
  }

  // A finger dragged the picture by so many CSS pixels.
  drag(right, down) {
    this.#module._slicecast_drag(right, down);
  }

  // The keys, one entry per line of the help, with the names of their actions:
  // [{keys: ['W', 'S'], does: 'walk ahead and back', group: 'move', scope: 'move', actions: [{name:
  // 'forward', does: 'walk ahead', press: 'hold', keys: [{code: 'KeyW', label: 'W'}]}]}]
  get keys() {
    return this.#json(this.#module._slicecast_keys());
  }

  // Binds the key (a KeyboardEvent.code) to that action alone. Throws if either is unknown.
  bindKey(code, action) {
    const refusal = withStrings(this.#module, [code, action], (codeAt, actionAt) =>
      this.#module.UTF8ToString(this.#module._slicecast_bindKey(codeAt, actionAt)),
    );
    if (refusal) throw new Error(refusal);
  }

  // Makes the key do nothing.
  unbindKey(code) {
    this.bindKey(code, '');
  }

  // Restores all standard keys.
  standardKeys() {
    this.#module._slicecast_standardKeys();
  }

  // The scope of what a key does: 'move', 'element' or 'page' (src/app/actions.h); '' if it does
  // nothing.
  keyScope(code) {
    return withStrings(this.#module, [code], (codeAt) =>
      this.#module.UTF8ToString(this.#module._slicecast_keyScope(codeAt)),
    );
  }

  // The size of its WebAssembly memory.
  get memoryBytes() {
    return (this.#resting ?? this.#module.HEAPU8).length;
  }

  // Removes all listeners and frames, so that the memory can be freed. Later calls throw.
  stop() {
    ++this.#loads;
    this.#running?._slicecast_stop();
    this.canvas?.removeEventListener?.('contextrestored', this.#drawAnew);
    this.#running = this.#resting = this.canvas = null;
  }

  #json(at) {
    return JSON.parse(this.#module.UTF8ToString(at));
  }
}

// Loads a scene in three steps, in slices: in between, the page and the old scene go on. Each step
// gives null if the scene is no longer wanted.
class SceneLoading {
  #engine;
  #module;
  #session;
  #isWanted;
  #pauses = new Pauses();
  #bytes = 0;

  constructor(engine, module, session, isWanted = () => true) {
    this.#engine = engine;
    this.#module = module;
    this.#session = session;
    this.#isWanted = isWanted;
  }

  // The text: {files, faults}.
  async readNames(source, onProgress = () => {}) {
    const text = await source.readText();
    const parse = () => {
      if (!this.#isWanted()) return null;
      withBytes(this.#module, text, (textAt) =>
        withStrings(this.#module, [source.name], (nameAt) =>
          this.#module._slicecast_parse(this.#session, textAt, text.length, nameAt),
        ),
      );
      return this.#finish((share) => onProgress(kTextShare * share, 0));
    };
    const names = await parse();
    if (names === null || names.files) return names;
    // The program's later part reads it.
    const [table] = await Promise.all([source.readFile(kShippedTable), this.#engine.complete()]);
    if (!this.#isWanted()) return null;
    const pictures = table ?? new TextEncoder().encode('{}');
    withBytes(this.#module, pictures, (at) =>
      this.#module._slicecast_takePictures(this.#session, at, pictures.length),
    );
    return parse();
  }

  // The files that the text names: each is decoded as it arrives, while the others load.
  async supplyFiles(files, source, onProgress = () => {}) {
    const shares = new Array(files.length).fill(0);
    let isOver = false;
    const report = () =>
      onProgress(
        kTextShare +
          (kFilesShare * shares.reduce((sum, share) => sum + share, 0)) /
            Math.max(1, shares.length),
        this.#bytes,
      );
    const supply = async (name, index) => {
      let before = 0;
      const bytes = await source.readFile(name, (loaded, total) => {
        this.#bytes += loaded - before;
        before = loaded;
        shares[index] = loaded / total;
        report();
      });
      await this.#pauses.mayCome();
      if (isOver || !this.#isWanted()) return;
      if (bytes !== null) supplyFile(this.#module, this.#session, name, bytes, source.pictures);
      shares[index] = 1;
      report();
    };
    report();
    try {
      await Promise.all(files.map(supply));
    } finally {
      isOver = true;
    }
  }

  // The world: {faults, warnings}. A file that could not be read becomes a fault at the place that
  // names it.
  async start(onProgress = () => {}, keepsLight = false) {
    this.#module._slicecast_start(this.#session, keepsLight ? 1 : 0);
    const result = await this.#finish((share) =>
      onProgress(kTextShare + kFilesShare + share * (1 - kTextShare - kFilesShare), this.#bytes),
    );
    if (result !== null) onProgress(1, this.#bytes);
    return result;
  }

  async #finish(onShare = () => {}) {
    for (;;) {
      const share = this.#module._slicecast_next(this.#session);
      if (share === 1)
        return JSON.parse(this.#module.UTF8ToString(this.#module._slicecast_answer(this.#session)));
      if (!this.#pauses.isDue) continue;
      onShare(share);
      await this.#pauses.mayCome();
      if (!this.#isWanted()) return null;
    }
  }
}

// Takes over pixels that another engine has decoded. A file that is not a picture has none.
function supplyFile(module, session, name, bytes, pictures) {
  const known = pictures?.get(bytes);
  const place = withBytes(module, bytes, (at) =>
    withStrings(module, [name], (nameAt) =>
      module._slicecast_supply(session, nameAt, at, bytes.length, known !== undefined),
    ),
  );
  const [at, length] = new Uint32Array(module.HEAPU8.buffer, place, 2);
  if (length === 0) return;
  if (known === undefined) pictures?.keep(bytes, module.HEAPU8.subarray(at, at + length));
  else module.HEAPU8.set(known, at);
}

function drawPixels(module, session, width, height, fraction) {
  if (module._slicecast_draw(session, width, height, fraction) === 0) return null;
  const at = module._slicecast_picture(session);
  return new Uint8ClampedArray(module.HEAPU8.slice(at, at + width * height * 4).buffer);
}

function imageOf(pixels, width, height) {
  return pixels === null ? null : new ImageData(pixels, width, height);
}

// Returns the five axes and the buttons as one bit mask.
function readInput(input) {
  for (const name of Object.keys(input ?? { [input]: 0 })) {
    if (!kAxes.includes(name) && !Object.hasOwn(kButtons, name))
      throw misread('step', `"${name}"`, [...kAxes, ...Object.keys(kButtons)].join(', '));
  }
  const axes = kAxes.map((name) => {
    const value = input[name] ?? 0;
    if (!(Math.abs(value) <= 1)) throw misread('step', `${name} ${value}`, 'a number from -1 to 1');
    return value;
  });
  return [
    axes,
    Object.entries(kButtons).reduce((sum, [name, bit]) => sum + (input[name] ? bit : 0), 0),
  ];
}

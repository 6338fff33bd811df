// One running engine: the WebAssembly module of slicecast (src/wasm/bindings.h), with names and
// types of JavaScript.
//
//     const engine = await Engine.create({files, canvas, onEvent(event, value) {...}});
//     const {faults} = await engine.loadScene(source);        // a source, as in source-parts.js
//     engine.begin();                                         // once: it draws, and listens to the canvas
//     engine.setOption('fov', 75);
//     engine.stop();                                          // at the end: nothing of it is left
//
// Without a canvas it draws only when asked to (drawOnce). Any number of engines live side by side;
// they share the compiled program.

import { createModule } from './engine-module.js';
import { withBytes, withStrings } from './module-memory.js';
import { unknown } from './nearest-name.js';
import { Questions } from './questions.js';
import { Trouble } from './trouble.js';

const kAxes = ['forward', 'strafe', 'turn', 'look', 'fly'];
const kMostSteps = 120 * 3600; // in one call: an hour of the world's time
const kAdoptedSlack = 16 << 20; // bytes that playing takes beside the scene: the picture, and what is noted of the view
const kButtons = { jump: 1, fast: 2, slow: 4, use: 8, open: 16, close: 32 };

export class Engine {
  #running; // the module; null at the end
  #session;
  #begun = false;
  #loads = 0;
  #mapNames = [];
  #startMap = 0; // its number
  #sceneEnd = 0; // of the memory, once the scene was there

  static async create({ files, canvas = null, onEvent = () => {}, takesKey }) {
    let engine;
    const onSlicecast = (event, value) =>
      onEvent(event, event === 'hits' ? engine.#hitsOf(value) : value);
    try {
      const { program, openCanvas } = files;
      const module = await createModule(program, { canvas, openCanvas, onSlicecast, takesKey });
      engine = new Engine(module, canvas);
      return engine;
    } catch (error) {
      throw new Trouble('The engine does not start', error.message);
    }
  }

  warnings = []; // of the scene that plays, in the form of faults

  constructor(module, canvas) {
    this.#running = module;
    this.#session =
      canvas === null ? module._slicecast_create() : module._slicecast_programSession();
    this.canvas = canvas;
  }

  get #module() {
    if (this.#running === null) throw new Error('This engine has been stopped.');
    return this.#running;
  }

  // The list of the scene's faults; empty if it plays now. A scene with faults leaves the game that
  // was running alone. Gives null if another scene was asked for meanwhile, or `isWanted` says so.
  // With `keepEye` the player goes on from where they are, if the new scene has such a place.
  // `onProgress` hears the share that has come, 0 to 1, and the number of bytes. `warnings` then
  // tells what in the scene is probably not meant so.
  async loadScene(source, { onProgress, keepEye = false, isWanted = () => true } = {}) {
    const load = ++this.#loads;
    const isLatest = () => load === this.#loads && isWanted();
    const names = await readNames(this.#module, this.#session, source, isLatest);
    if (names === null) return null;
    if (names.faults.length > 0) return names.faults;
    await supplyFiles(this.#module, this.#session, names.files, source, {
      onProgress,
      isWanted: isLatest,
    });
    if (!isLatest()) return null;
    const eye = keepEye ? this.state : null;
    const { faults, warnings } = start(this.#module, this.#session);
    this.warnings = warnings;
    if (faults.length === 0) {
      this.#mapNames = this.world.maps.map(({ name }) => name);
      this.#startMap = this.state.map;
      this.#sceneEnd = this.#module._slicecast_memoryEnd();
    }
    if (eye !== null && faults.length === 0) this.restore(eye);
    return faults;
  }

  // Has the scene of another engine of the same build, from its start, in a fraction of the time
  // that loading takes: the other's memory is all that there is of it. Only before begin(), and
  // nothing of another load may be under way. False if the other has none, or has taken much more
  // memory since.
  adopt(other) {
    if ((other?.#running ?? null) === null) return false;
    const end = other.#running._slicecast_memoryEnd();
    if (end > other.#sceneEnd + kAdoptedSlack) return false;
    if (
      end > this.memoryBytes &&
      this.#module._malloc(end - this.#module._slicecast_memoryEnd()) === 0
    )
      return false;
    this.#module.HEAPU8.set(other.#running.HEAPU8.subarray(0, end));
    this.warnings = other.warnings;
    this.#mapNames = other.#mapNames;
    this.#startMap = other.#startMap;
    this.#sceneEnd = other.#sceneEnd;
    return this.#module._slicecast_adopt() === 1;
  }

  // Begins to draw into the canvas and to listen to it. The second call does nothing.
  begin() {
    if (this.#begun) return;
    this.#begun = true;
    if (this.#module._slicecast_begin() === 0) throw new Error('There is no canvas.');
  }

  get hasBegun() {
    return this.#begun;
  }

  // One picture of a scene from its start, drawn aside: ImageData, or null if the scene has faults.
  async drawAside(source, width, height) {
    const module = this.#module;
    const session = module._slicecast_create();
    try {
      const { files, faults } = await readNames(module, session, source);
      if (faults.length > 0) return null;
      await supplyFiles(module, session, files, source);
      return start(module, session).faults.length === 0
        ? imageOf(drawPixels(module, session, width, height, 1), width, height)
        : null;
    } finally {
      module._slicecast_free(session);
    }
  }

  // The view as it would be drawn now, in any size: ImageData, or null without a game.
  drawOnce(width, height, fraction = 1) {
    return imageOf(this.drawPixels(width, height, fraction), width, height);
  }

  // The same as bytes, for where there is no ImageData.
  drawPixels(width, height, fraction = 1) {
    return drawPixels(this.#module, this.#session, width, height, fraction);
  }

  // How long it takes to draw the view once in that size, milliseconds; null without a game.
  timeDrawing(width, height) {
    const begin = performance.now();
    const isDrawn = this.#module._slicecast_draw(this.#session, width, height, 1) === 1;
    return isDrawn ? performance.now() - begin : null;
  }

  // Steps of exactly 1/120 s each, also while it stands still; the last one's view is drawn. The
  // input is held during all of them: {forward, strafe, turn, look, fly} from -1 to 1, {jump, fast,
  // slow, use, open, close} true or false. What was replayed is over.
  step(input = {}, count = 1) {
    const [axes, buttons] = readInput(input);
    if (!Number.isInteger(count) || count < 0 || count > kMostSteps)
      throw new RangeError(
        `step: found count ${count}, expected a whole number from 0 to ${kMostSteps}.`,
      );
    for (let i = 0; i < count; ++i)
      this.#module._slicecast_step(this.#session, ...axes, 0, 0, buttons);
  }

  // Options are those of `--set`; true and false are "on" and "off". Throws if the engine refuses
  // the value.
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

  // The same; throws where there is no such option.
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

  // All options, in the order in which to list them: [{name, kind, least, greatest, choices: [...],
  // standard, description, value}] (src/wasm/bindings.h).
  get options() {
    return this.#json(this.#module._slicecast_options(this.#session)).map((option) => ({
      ...option,
      choices: option.choices.split(' ').filter(Boolean),
    }));
  }

  // Named settings of the classic method, as a person would ask for them: [{name, description,
  // options: {name: value}}]; its other options are as they are by default.
  get oldWays() {
    return this.#json(this.#module._slicecast_oldWays(this.#session));
  }

  // What of the world the present method leaves out of the picture: sentences.
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

  // {map (its name), x, y, z, heading, look} of the eye after the last step, cheap enough for every
  // frame; or null.
  get view() {
    const at = this.#module._slicecast_view(this.#session);
    if (at === 0) return null;
    const [map, x, y, z, heading, look] = new Float64Array(this.#module.HEAPU8.buffer, at, 6);
    return { map: this.#mapNames[map], x, y, z, heading, look };
  }

  // Where a place {x, y, z, map} stands in the picture that was drawn last, taken as large as
  // {width, height}: {x, y, depth, isSeen}, null where it is not before the eye or in another map.
  // The map is named; null is that of the start.
  spot({ x, y, z, map }, { width, height }) {
    const index = map === null ? this.#startMap : this.#mapNames.indexOf(map);
    const at = this.#module._slicecast_spot(this.#session, index, x, y, z, width, height);
    if (at === 0) return null;
    const [column, row, depth, seen] = new Float64Array(this.#module.HEAPU8.buffer, at, 4);
    return { x: column, y: row, depth, isSeen: seen === 1 };
  }

  // Puts the eye elsewhere, walking or flying as it was where there is room for that; what the view
  // leaves out stays. False if such an eye cannot see.
  look(view) {
    const state = this.state;
    if (state === null) return false;
    const given = Object.fromEntries(
      Object.entries(view).filter(([, value]) => (value ?? null) !== null),
    );
    if (given.map !== undefined) given.map = this.#mapNames.indexOf(given.map);
    return this.restore({ ...state, ...given });
  }

  // Draws what has changed in the frame that began at that time, not in the next one.
  drawNow(time) {
    this.#module.frameNow(time);
  }

  // Fly mode, or walk mode.
  set flying(flying) {
    this.#module._slicecast_setFlying(this.#session, flying ? 1 : 0);
  }

  // Records the game that has just been loaded, under the name of its scene's file.
  record(sceneName) {
    withStrings(this.#module, [sceneName], (nameAt) =>
      this.#module._slicecast_record(this.#session, nameAt),
    );
  }

  // Ends the recording: its text, or '' if there was none.
  takeRecording() {
    return this.#module.UTF8ToString(this.#module._slicecast_takeRecording(this.#session));
  }

  // Checks a recording's bytes: {scene, steps, marks: [{name, step}], faults}. One without faults
  // is kept for replay().
  readRecording(bytes, name) {
    return withBytes(this.#module, bytes, (at) =>
      withStrings(this.#module, [name], (nameAt) =>
        this.#json(this.#module._slicecast_readRecording(this.#session, at, bytes.length, nameAt)),
      ),
    );
  }

  // Plays the recording that was read in the game that has just been loaded; whoever moves takes
  // over. False if there is none.
  replay() {
    return this.#module._slicecast_replay(this.#session) === 1;
  }

  // {steps, stepsDone, isSame}, or null while no recording is played.
  get replayState() {
    return this.#json(this.#module._slicecast_replayState(this.#session));
  }

  // Puts the eye back where a state says, walking or flying as it was. False if it may not be
  // there.
  restore({ map, x, y, z, heading, look, flying }) {
    if (this.#module._slicecast_setEye(this.#session, map, x, y, z, heading, look) === 0)
      return false;
    this.#module._slicecast_setFlying(this.#session, flying ? 1 : 0);
    return true;
  }

  #hitsOf({ width, height, column }) {
    return this.questions.hits(width, height, column);
  }

  // Rays, pixels, points and cells.
  get questions() {
    return new Questions(this.#module, this.#session, this.#mapNames);
  }

  reset() {
    this.#module._slicecast_reset(this.#session);
  }

  // The picture's size in pixels.
  resize(width, height) {
    this.#module._slicecast_resize(width, height);
  }

  set paused(paused) {
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

  // What thumbs hold on the screen, until they hold something else.
  setThumbs({ forward = 0, strafe = 0, fly = 0, jump = false, fast = false, use = false }) {
    this.#module._slicecast_thumbs(
      forward,
      strafe,
      fly,
      (jump ? 1 : 0) + (fast ? 2 : 0) + (use ? 8 : 0),
    );
  }

  // A finger has dragged the picture, in CSS pixels.
  drag(right, down) {
    this.#module._slicecast_drag(right, down);
  }

  // What the keys do, a line for each row of a help text, with the names of their actions:
  // [{keys: ['W', 'S'], does: 'walk ahead and back', group: 'move', scope: 'move', actions: [{name:
  // 'forward', does: 'walk ahead', press: 'hold', keys: [{code: 'KeyW', label: 'W'}]}]}]
  get keys() {
    return this.#json(this.#module._slicecast_keys());
  }

  // From now on the key (a KeyboardEvent.code) does that action and nothing else. Throws what is
  // wrong.
  bindKey(code, action) {
    const refusal = withStrings(this.#module, [code, action], (codeAt, actionAt) =>
      this.#module.UTF8ToString(this.#module._slicecast_bindKey(codeAt, actionAt)),
    );
    if (refusal) throw new Error(refusal);
  }

  // The key does nothing.
  unbindKey(code) {
    this.bindKey(code, '');
  }

  // Every key does what it does in the beginning.
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

  // What it holds of the browser's memory.
  get memoryBytes() {
    return this.#module.HEAPU8.length;
  }

  // Ends everything: no listener and no frame remains, and the memory can be freed. Whoever asks it
  // for anything then gets an Error.
  stop() {
    ++this.#loads;
    this.#running?._slicecast_stop();
    this.#running = this.canvas = null;
  }

  #json(at) {
    return JSON.parse(this.#module.UTF8ToString(at));
  }
}

// A scene is loaded in three steps. The text: {files, faults}, or null if nobody wants it any more.
async function readNames(module, session, source, isWanted = () => true) {
  const text = await source.readText();
  if (!isWanted()) return null;
  return withBytes(module, text, (textAt) =>
    withStrings(module, [source.name], (nameAt) =>
      JSON.parse(
        module.UTF8ToString(module._slicecast_parse(session, textAt, text.length, nameAt)),
      ),
    ),
  );
}

// The files that it names: each is handed over when it comes, and its picture decoded while the
// others are on their way.
async function supplyFiles(
  module,
  session,
  files,
  source,
  { onProgress = () => {}, isWanted = () => true } = {},
) {
  const shares = new Array(files.length).fill(0);
  let bytesLoaded = 0;
  let isOver = false;
  const report = () =>
    onProgress(
      shares.reduce((sum, share) => sum + share, 0) / Math.max(1, shares.length),
      bytesLoaded,
    );
  const supply = async (name, index) => {
    let before = 0;
    const bytes = await source.readFile(name, (loaded, total) => {
      bytesLoaded += loaded - before;
      before = loaded;
      shares[index] = loaded / total;
      report();
    });
    if (isOver || !isWanted()) return;
    if (bytes !== null) supplyFile(module, session, name, bytes, source.pictures);
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

// What another engine has decoded is handed over. A file that is no picture has no pixels.
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

// The world: {faults, warnings}. A file that could not be read becomes one, with the place that
// names it.
function start(module, session) {
  return JSON.parse(module.UTF8ToString(module._slicecast_start(session)));
}

function drawPixels(module, session, width, height, fraction) {
  if (module._slicecast_draw(session, width, height, fraction) === 0) return null;
  const at = module._slicecast_picture(session);
  return new Uint8ClampedArray(module.HEAPU8.slice(at, at + width * height * 4).buffer);
}

function imageOf(pixels, width, height) {
  return pixels === null ? null : new ImageData(pixels, width, height);
}

// The five axes, and the sum of the buttons.
function readInput(input) {
  for (const name of Object.keys(input ?? { [input]: 0 })) {
    if (!kAxes.includes(name) && !(name in kButtons))
      throw new Error(
        `step: found "${name}", expected ${[...kAxes, ...Object.keys(kButtons)].join(', ')}.`,
      );
  }
  const axes = kAxes.map((name) => {
    const value = input[name] ?? 0;
    if (!(Math.abs(value) <= 1))
      throw new Error(`step: found ${name} ${value}, expected a number from -1 to 1.`);
    return value;
  });
  return [
    axes,
    Object.entries(kButtons).reduce((sum, [name, bit]) => sum + (input[name] ? bit : 0), 0),
  ];
}

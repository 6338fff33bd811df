// The engine behind one <ray-caster>: fetches it, loads scenes into it, and keeps its options as
// the attributes say.
//
//     const game = new Game({showCanvas(canvas) {}, hear(event, value) {}, takesKey(code) {}});
//     if (await game.load({key, kind, source, tour, onProgress})) game.engine.begin();
//     game.setOptions([['fov', '75']]);
//     game.stop();
//
// `key` identifies the request: build, scene and tour.

import { Engine } from '../engine/engine.js';
import { finalAddress } from '../engine/fetch-bytes.js';
import { faultOf, orFault } from './faults.js';
import { bringMore } from './later-parts.js';
import { nowPlays, nowStops, nowWakes, players, sharedEngineFiles } from './page-cache.js';
import { namedScene, readTour } from './source.js';
import { readSceneObject } from '../engine/scene-object.js';
import { picturesIn, withReason } from '../engine/source-parts.js';
import { sceneFault } from '../engine/trouble.js';

const kEngineShare = 0.5; // of the progress, if the engine must be fetched

export class Game {
  engine = null; // once a scene is loaded
  source = null; // of the current scene
  #kind = null;
  #key = null; // of the current scene
  #turn = 0;
  #tour = null;
  #pictures = null; // of the current scene, once it is renewed
  #before = new Map(); // option -> its value before an attribute set it

  constructor(actions) {
    this.actions = actions;
  }

  // Returns true if the scene can be played now, false if another one was requested meanwhile.
  // Until then the previous scene stays, with its picture. Throws a Trouble. `source` may be null
  // with a tour, which names its scene; with a source, faults of the tour are only reported to
  // `warn`.
  async load({ key, kind, source, tour, keepEye, warn, onProgress }) {
    const turn = ++this.#turn;
    const isStale = () => turn !== this.#turn;
    const begin = this.engine === null ? kEngineShare : 0;
    let engineBytes = 0;
    onProgress(0, 0);
    // Another element may already play the same scene.
    const findTwin = () => [...players].find(([, played]) => played === key)?.[0];
    const begun =
      source === null || findTwin() !== undefined ? source : beginReading(source, isStale);
    let [files, recording] = await Promise.all([
      sharedEngineFiles(kind, (loaded, total) => {
        if (begin === 0 || isStale()) return;
        engineBytes = loaded;
        onProgress((begin * loaded) / Math.max(1, total), loaded);
      }),
      tour === null
        ? null
        : readTour(tour).catch((error) => {
            if (source === null) throw error;
            warn('tour', error.message);
            return null;
          }),
    ]);
    if (isStale()) return false;
    const isNew = this.engine === null || files.kind !== this.#kind;
    const engine = isNew ? await this.#create(files, isStale) : this.engine;
    if (engine === null) return false;
    let wasPlayer = false;
    try {
      const isAdopted = isNew && engine.adopt(findTwin());
      let found = begun;
      try {
        if (recording !== null) found = sceneOfTour(engine, recording, begun);
      } catch (error) {
        if (begun === null) throw error;
        warn('tour', error.message);
        recording = null;
      }
      wasPlayer = players.delete(engine); // while another scene loads into its memory
      const faults = isAdopted
        ? []
        : await engine.loadScene(found, {
            keepEye,
            isWanted: () => !isStale(),
            onProgress: (share, bytes) =>
              isStale() || onProgress(begin + share * (1 - begin), engineBytes + bytes),
          });
      if (faults === null || isStale()) {
        if (isNew) engine.stop();
        return false;
      }
      if (faults.length > 0)
        throw sceneFault(
          found.name,
          faults.map((fault) => withReason(fault, found.failures)),
        );
      if (isAdopted) onProgress(1, engineBytes);
      // Where it really came from, so that pages can tell.
      this.source = { ...found, address: found.address && finalAddress(found.address) };
      this.#pictures = null;
      this.#tour = recording;
      if (isNew) this.#take(engine, files.kind);
      this.#key = key;
      nowPlays(engine, key);
    } catch (error) {
      if (isNew) engine.stop();
      else if (wasPlayer && !isStale()) nowPlays(engine, this.#key); // the old scene goes on
      throw error;
    }
    if (recording !== null) engine.replay();
    return true;
  }

  // Plays another text of the present scene from where the player stands: {faults, warnings}; with
  // faults the old text goes on. Null if anything else was requested meanwhile. Pictures that the
  // scene has are neither fetched nor decoded again. Aside, it only looks for mistakes in the text.
  async renew(scene, isAside) {
    const { engine, source } = this;
    const turn = isAside ? this.#turn : ++this.#turn;
    const isWanted = () => turn === this.#turn;
    const text = typeof scene === 'string' ? scene : readSceneObject(scene).text;
    this.#pictures ??= keptPictures(source);
    const renewed = {
      ...source,
      ...this.#pictures,
      readText: () => new TextEncoder().encode(text),
    };
    if (isAside) return engine.findMistakes(renewed, isWanted);
    const faults = await engine.loadScene(renewed, { keepEye: true, isWanted });
    if (faults === null) return null;
    if (faults.length > 0)
      return { faults: faults.map((fault) => withReason(fault, source.failures)), warnings: [] };
    this.source = renewed;
    this.#key = {}; // like no other scene
    nowPlays(engine, this.#key);
    return { faults, warnings: engine.warnings };
  }

  async #create(files, isStale) {
    const canvas = document.createElement('canvas');
    const { hear, takesKey } = this.actions;
    const engine = await Engine.create({
      files,
      canvas,
      takesKey,
      onEvent: (event, value) => {
        if (this.engine !== engine) return;
        if (event === 'wake') nowWakes(engine);
        else hear(event, value);
      },
    });
    if (!isStale()) return engine;
    engine.stop();
    return null;
  }

  #take(engine, kind) {
    this.#stopEngine();
    this.engine = engine;
    this.#kind = kind;
    this.#before.clear();
    engine.paused = true;
    this.actions.showCanvas(engine.canvas);
  }

  // Starts drawing. With reduced motion the eye does not bob on water.
  begin() {
    this.engine.begin();
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) this.engine.setOption('bob', 'off');
  }

  // Loads what no first picture needs.
  async complete() {
    const { engine } = this;
    [{ Questions: engine.Questions }] = await Promise.all([bringMore(), engine.complete()]);
  }

  // Sets these options, and restores those that were set before and are no longer named. Refused
  // options are reported to `warn`.
  setOptions(pairs, warn) {
    const wanted = new Map(pairs);
    for (const [name, value] of this.#before) {
      if (wanted.has(name)) continue;
      this.engine.setOption(name, value);
      this.#before.delete(name);
    }
    for (const [name, value] of wanted) {
      const before = this.engine.option(name);
      try {
        this.engine.setOption(name, value);
        if (!this.#before.has(name)) this.#before.set(name, before);
      } catch ({ message }) {
        warn('options', message);
      }
    }
  }

  setOption(name, value) {
    orFault('option', () => this.engine.setOption(name, value));
  }

  // Returns to the start; a tour begins again.
  reset() {
    this.engine.reset();
    if (this.#tour === null) return;
    checkTour(this.engine, this.#tour);
    this.engine.replay();
  }

  get hasTour() {
    return this.#tour !== null;
  }

  stop() {
    ++this.#turn;
    this.#stopEngine();
    this.engine = this.source = this.#tour = null;
  }

  #stopEngine() {
    nowStops(this.engine);
    this.engine?.stop();
  }
}

// Reads each file once, and keeps what is decoded.
function keptPictures({ readFile }) {
  const files = new Map(); // name -> bytes
  const decoded = new Map(); // bytes -> pixels
  return {
    pictures: {
      get: (bytes) => decoded.get(bytes),
      keep: (bytes, pixels) => decoded.set(bytes, pixels.slice()),
    },
    async readFile(name, onBytes) {
      if (!files.has(name)) files.set(name, await readFile(name, onBytes));
      return files.get(name);
    },
  };
}

// Fetches the scene's text and, from the page's own origin, the pictures that it names, while the
// engine loads. Other pictures are asked for when the engine has checked the text. Errors are
// reported later, when the text is read.
function beginReading(source, isStale) {
  const text = source.readText();
  text
    .then(async (bytes) => {
      if (isStale()) return;
      const isOwn = (file) => source.addressOf?.(file).origin === location.origin;
      await Promise.all(
        picturesIn(bytes)
          .filter(isOwn)
          .map((file) => source.readFile(file)),
      );
    })
    .catch(() => {});
  return { ...source, readText: () => text };
}

// The tour's scene: `found`, or the shipped scene that the tour names.
function sceneOfTour(engine, recording, found) {
  const scene = sceneName(checkTour(engine, recording));
  if (found === null) return namedScene(scene);
  if (found.address !== null && sceneName(found.name) !== scene)
    throw faultOf(
      'tour',
      `${recording.name} was recorded in the scene ${scene}, not in ${sceneName(found.name)}.`,
    );
  return found;
}

const sceneName = (file) => file.replace(/\.json$/i, '');

// Returns the name of the tour's scene.
function checkTour(engine, { name, bytes }) {
  const { scene, faults } = engine.readRecording(bytes, name);
  if (faults.length > 0) throw faultOf('tour', `${name} is not a valid recording.`, faults);
  return scene;
}

// Turns the attributes of a <ray-caster> into a scene that can be played: reads them when they
// change, loads what they name, and applies the rest to the current scene. Until the next scene has
// loaded, the previous one stays, paused.
//
//     const loading = new Loading(element, game, actions);
//     loading.update();       // reads the attributes soon, once for all changes of this moment
//     loading.near();         // the element is near the window
//     loading.now();          // the scene is needed: stop waiting
//     loading.again(null);    // try or load again; {keepEye: true} keeps the view
//     loading.stop();
//
// `actions` are {show(wanted), changed(), warn(warning), progress(share, bytes), loaded(),
// done(isNew), failed(error)}.

import { unknown } from '../engine/nearest-name.js';
import { readAttributes } from './attributes.js';
import { roomForEngine } from './page-cache.js';
import { hasParsed, whenParsed } from './parsing.js';
import { findScene, noScene, tourAddress } from './source.js';
import { Warnings } from './warnings.js';

const kIdleMilliseconds = 5000; // without a slice of the first picture: then none comes

export class Loading {
  wanted = null; // the attributes' values, once read
  isLoading = false;
  #host;
  #game;
  #actions;
  #life = new AbortController();
  #loads = 0;
  #asked = null; // the key of the last request
  #loaded = null; // the key of what is loaded
  #failed = null; // the key of what failed to load
  #isReady = false; // done() has been called for what is loaded
  // The attributes' options and view as last applied. They are applied again only when they change,
  // so that changes by methods and keys last.
  #options = null;
  #view = null;
  #isNear = false;
  #isAsked = false;
  #isUpdating = false;
  #again = null; // {keepEye} if the same key is to be loaded again
  #pictureCame = () => {};
  #idle = 0; // the timer that ends waiting for the first picture

  constructor(host, game, actions) {
    this.#host = host;
    this.#game = game;
    this.#actions = actions;
    this.warnings = new Warnings(actions.warn);
    whenParsed(host, () => this.update(), this.#life);
  }

  // Nothing is loading or about to.
  get isSettled() {
    return !this.#isUpdating && !this.isLoading;
  }

  update() {
    if (this.#isUpdating) return;
    this.#isUpdating = true;
    queueMicrotask(() => {
      this.#isUpdating = false;
      if (!this.#life.signal.aborted) this.#take();
    });
  }

  near() {
    this.#isNear = true;
    this.update();
  }

  now() {
    if (this.#isAsked) return;
    this.#isAsked = true;
    this.update();
  }

  again(how) {
    this.#again = how;
    this.#failed = null;
    this.#isAsked = true;
    this.update();
  }

  // With loading="click" nothing may be fetched before a click.
  get waitsForClick() {
    return !this.#isAsked && this.wanted?.loading !== 'lazy' && this.wanted?.loading !== 'eager';
  }

  get mayLoad() {
    const { loading } = this.wanted;
    return this.#isAsked || loading === 'eager' || (loading === 'lazy' && this.#isNear);
  }

  stop() {
    this.#life.abort();
  }

  // What was loaded is lost and must be loaded again.
  forget() {
    ++this.#loads;
    this.#asked = this.#loaded = null;
  }

  // A picture has been drawn.
  pictureCame() {
    this.#pictureCame();
  }

  // A slice of one has been drawn.
  pictureGoesOn() {
    clearTimeout(this.#idle);
    this.#idle = setTimeout(this.#pictureCame, kIdleMilliseconds);
  }

  // Applies the view of the attribute again.
  applyView() {
    this.#view = null;
    if (this.wanted !== null) this.#apply();
  }

  #take() {
    const host = this.#host;
    try {
      const wanted = readAttributes(host, this.warnings.renew('attributes'));
      this.wanted = wanted;
      this.#actions.show(wanted);
      if (!this.mayLoad) {
        this.#actions.changed();
        return;
      }
      if (!isSceneParsed(host)) return; // the constructor waits for it
      const scene = findScene(host);
      const tour = host.tour === '' ? null : tourAddress(host);
      if (scene === null && tour === null) throw noScene(host);
      const key = [scene?.key, tour?.href, wanted.engine].join('\n');
      if (key === this.#failed) return;
      const again = this.#again;
      this.#again = null;
      if (key !== this.#asked || again !== null) {
        const keepEye = again?.keepEye === true && key === this.#loaded;
        const source = scene?.source() ?? null;
        this.#load(key, { key, kind: wanted.engine, source, tour, keepEye });
      } else if (key === this.#loaded && !this.isLoading) this.#settle();
    } catch (error) {
      this.#failed = null;
      this.#actions.failed(error);
    }
  }

  async #load(key, request) {
    const load = ++this.#loads;
    const isStale = () => load !== this.#loads || this.#life.signal.aborted;
    let reported = '';
    const onProgress = (share, bytes) => {
      if (isStale() || `${share} ${bytes}` === reported) return;
      reported = `${share} ${bytes}`;
      this.#actions.progress(share, bytes);
    };
    this.#asked = key;
    this.#failed = null;
    this.isLoading = true;
    this.#actions.changed();
    const settled = this.#game.engine === null ? await roomForEngine() : null;
    try {
      if (isStale()) return;
      const warn = this.warnings.renew('tour');
      const isThere = await this.#game.load({ ...request, warn, onProgress });
      if (!isThere || isStale()) return;
      this.#loaded = key;
      const warnOfScene = this.warnings.renew('scene');
      for (const { message } of this.#game.engine.warnings) warnOfScene('scene', message);
      if (!request.keepEye) this.#options = this.#view = null;
      this.#isReady = false;
      this.#actions.loaded();
      this.#apply();
      const waiting = new AbortController();
      const picture = new Promise((resolve) => {
        this.#pictureCame = resolve;
        this.pictureGoesOn();
        // Hidden pages draw no picture to wait for.
        if (document.hidden) resolve();
        document.addEventListener('visibilitychange', resolve, { signal: waiting.signal });
      });
      this.#game.begin();
      await picture;
      waiting.abort();
      clearTimeout(this.#idle);
      if (isStale()) return;
      await this.#game.complete();
      if (isStale()) return;
      this.isLoading = false;
      this.#settle();
    } catch (error) {
      if (isStale()) return;
      if (this.#loaded !== key) this.#failed = key;
      this.#asked = this.#loaded;
      this.isLoading = false;
      this.#actions.failed(error);
    } finally {
      settled?.(this.#game.engine);
    }
  }

  // Applies options, overlays and the view.
  #apply() {
    const { view } = this.wanted;
    const options = [...this.wanted.options, ...this.wanted.overlay.map((name) => [name, 'on'])];
    const all = String(options);
    if (all !== this.#options) this.#game.setOptions(options, this.warnings.renew('options'));
    this.#options = all;
    const text = view === null ? null : this.#host.view;
    if (text === this.#view) return;
    this.#view = text;
    const warn = this.warnings.renew('view');
    // A tour starts where it was recorded.
    if (view === null || this.#game.hasTour || this.#game.engine.look(view)) return;
    const maps = this.#game.engine.world.maps.map(({ name }) => name);
    warn(
      'view',
      view.map === null || maps.includes(view.map)
        ? `The view '${text}' is not above the floor.`
        : unknown('map', view.map, maps),
    );
  }

  // Everything is as the attributes say.
  #settle() {
    this.#apply();
    this.#failed = null;
    this.#game.begin(); // needed if the first try failed
    const isNew = !this.#isReady;
    this.#isReady = true;
    this.#actions.done(isNew);
  }
}

// Whether the part of the page that holds the scene has been parsed: the element's children, or the
// whole page if `scene` refers to another element.
function isSceneParsed(host) {
  const { scene, ownerDocument } = host;
  if (scene === '') return hasParsed(host);
  return typeof scene === 'object' || scene[0] !== '#' || ownerDocument.readyState !== 'loading';
}

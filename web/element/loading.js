// From the attributes of a <ray-caster> to a scene that can be played: reads them when they change,
// loads what they name, and applies the rest to what is there. Until the next scene has come, the
// one before stays, standing still.
//
//     const loading = new Loading(element, game, {show(wanted), changed(), warn(warning), progress(share, bytes), loaded(), done(isNew), failed(error)});
//     loading.update();       // soon
//     loading.near();         // the element is near the window
//     loading.now();          // it is asked for: waits no longer
//     loading.again(null);    // what has failed is tried once more; with {keepEye} what plays is loaded anew, too
//     loading.stop();

import { unknown } from '../engine/nearest-name.js';
import { readAttributes } from './attributes.js';
import { hasParsed, whenParsed } from './parsing.js';
import { findScene, noScene, tourAddress } from './source.js';
import { Warnings } from './warnings.js';

const kFirstPictureMilliseconds = 400; // a hidden page draws none: then the scene counts as ready without

export class Loading {
  wanted = null; // what the attributes say, once they have been read
  isLoading = false;
  #host;
  #game;
  #actions;
  #life = new AbortController();
  #loads = 0;
  #asked = null; // the key of what is loaded or being loaded, and of what is loaded
  #loaded = null;
  #failed = null; // the key of what could not be loaded
  #isReady = false; // what is loaded has been told of
  #options = null; // of the attributes, as they were taken, overlays too: what methods and keys have changed since stays
  #view = null; // the attribute's that was taken
  #isNear = false;
  #isAsked = false;
  #isUpdating = false;
  #again = null; // how, if even the same is to be loaded
  #pictureCame = () => {};

  constructor(host, game, actions) {
    this.#host = host;
    this.#game = game;
    this.#actions = actions;
    this.warnings = new Warnings(actions.warn);
  }

  // Nothing is under way, and nothing will be unless something changes.
  get isSettled() {
    return !this.#isUpdating && !this.isLoading;
  }

  // Soon, once for all that changes now.
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

  // Not a byte may be fetched before.
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

  // What was loaded is lost: it is loaded again.
  forget() {
    ++this.#loads;
    this.#asked = this.#loaded = null;
  }

  // Some picture is on the canvas.
  pictureCame() {
    this.#pictureCame();
  }

  // The view of the attribute, again.
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
      if (!isSceneParsed(host)) {
        whenParsed(host, () => this.update(), this.#life);
        return;
      }
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
      } else if (key === this.#loaded) this.#settle();
    } catch (error) {
      this.#failed = null;
      this.#actions.failed(error);
    }
  }

  async #load(key, request) {
    const load = ++this.#loads;
    const isStale = () => load !== this.#loads || this.#life.signal.aborted;
    let told = '';
    const onProgress = (share, bytes) => {
      if (isStale() || `${share} ${bytes}` === told) return;
      told = `${share} ${bytes}`;
      this.#actions.progress(share, bytes);
    };
    this.#asked = key;
    this.#failed = null;
    this.isLoading = true;
    this.#actions.changed();
    try {
      const warn = this.warnings.renew('tour');
      const isThere = await this.#game.load({ ...request, warn, onProgress });
      if (!isThere || isStale()) return;
      this.#loaded = key;
      if (!request.keepEye) this.#options = this.#view = null;
      this.#isReady = false;
      this.#actions.loaded();
      this.#apply();
      const picture = new Promise((resolve) => {
        this.#pictureCame = resolve;
        setTimeout(resolve, kFirstPictureMilliseconds);
      });
      this.#game.begin();
      await picture;
      if (isStale()) return;
      this.isLoading = false;
      this.#settle();
    } catch (error) {
      if (isStale()) return;
      if (this.#loaded !== key) this.#failed = key;
      this.#asked = this.#loaded;
      this.isLoading = false;
      this.#actions.failed(error);
    }
  }

  // Options, overlays and the view, as they are wanted now.
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
    // A tour begins where it was recorded.
    if (view === null || this.#game.hasTour || this.#game.engine.look(view)) return;
    const maps = this.#game.engine.world.maps.map(({ name }) => name);
    warn(
      'view',
      view.map === null || maps.includes(view.map)
        ? `The view '${text}' is not above the floor.`
        : unknown('map', view.map, maps),
    );
  }

  // All is as the attributes say.
  #settle() {
    this.#apply();
    this.#failed = null;
    this.#game.begin(); // it has, unless the first try had a fault
    const isNew = !this.#isReady;
    this.#isReady = true;
    this.#actions.done(isNew);
  }
}

// Whether what the scene would be found in has been read: the element's children, or all of the
// page where it is another element's.
function isSceneParsed(host) {
  const { scene, ownerDocument } = host;
  if (scene === '') return hasParsed(host);
  return typeof scene === 'object' || scene[0] !== '#' || ownerDocument.readyState !== 'loading';
}

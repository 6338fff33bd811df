// What a <ray-caster> does behind its attributes and methods: it comes to life in the page, loads what the attributes say, and runs the engine while the
// world is asked to play (autoplay, play()) or held (activation.js), and can be seen. The pieces: tree.js (inside), game.js (the engine), controls.js.
//
//     const show = new Show(element, internals);       // with a shadow root
//     show.connect();   show.update();   show.disconnect();
//     show.play();      show.pause();

import { Stage } from '../stage.js';
import { Trouble } from '../trouble.js';
import { Activation } from './activation.js';
import { kOverlays, readAttributes } from './attributes.js';
import { barActions } from './bar-actions.js';
import { Controls } from './controls.js';
import { explain } from './faults.js';
import { Game } from './game.js';
import { hideMessage, showMessage } from './message.js';
import { holdCache } from './page-cache.js';
import { hasParsed, whenParsed } from './parsing.js';
import { findScene, tourAddress } from './source.js';
import { buildTree } from './tree.js';
import { ViewStatus } from './view-status.js';
import { watchVisibility } from './visibility.js';

const kFirstPictureMilliseconds = 400; // a hidden page draws none: then the scene counts as ready without
const kCursorHint = 'The mouse’s place steers; Escape ends it';

export class Show {
  state = 'idle';
  error = null; // ErrorDetail
  ready = null; // ReadyDetail of the scene that plays
  #host;
  #internals;
  #tree;
  #game;
  #activation;
  #controls;
  #viewStatus;
  #life = null; // while the element is in the document: an AbortController
  #stage = null;
  #waiting = null; // of whenReady(): {promise, resolve, reject}
  #wanted = null; // what the attributes say; null while one of them is at fault
  #asked = null; // the key of what is loaded or being loaded, and of what is loaded
  #loaded = null;
  #view = null; // the attribute's that was taken
  #isNear = false;
  #isSeen = false;
  #isAskedToPlay = false;
  #isUpdating = false;
  #stands = true;
  #pictureCame = () => {};

  constructor(host, internals) {
    this.#host = host;
    this.#internals = internals;
    this.#tree = buildTree(host.shadowRoot);
    this.#game = new Game({ showCanvas: (canvas) => this.#showCanvas(canvas), hear: (event, value) => this.#hear(event, value) });
    this.#activation = new Activation(this.#tree, {
      engine: () => this.#game.engine,
      wanted: () => this.#loadNow(),
      canBegin: () => this.#canPlay,
      changed: () => this.#run(),
    });
    this.#controls = new Controls(this.#tree.controls, barActions(host, this));
    this.#viewStatus = new ViewStatus(this.#tree, () => this.engine);
    host.addEventListener('fullscreenchange', () => this.showControls());
    this.#tree.poster.addEventListener('error', () => this.#tree.poster.toggleAttribute('hidden', true));
  }

  get engine() {
    return this.#game.engine;
  }

  get source() {
    return this.#game.source;
  }

  get canvas() {
    return this.#tree.canvas;
  }

  get paused() {
    return !this.#isAskedToPlay && !this.#activation.isHeld;
  }

  get overlays() {
    return this.#wanted?.overlay ?? [];
  }

  // ---- Life

  connect() {
    if (this.#life !== null) return; // it was only moved
    this.#life = new AbortController();
    const { signal } = this.#life;
    const until = (act) => signal.addEventListener('abort', act);
    until(holdCache());
    until(watchVisibility(this.#host, { near: () => this.#loadNow(), seen: (isSeen) => this.#see(isSeen) }));
    const children = new MutationObserver(() => this.update());
    children.observe(this.#host, { childList: true, characterData: true, subtree: true });
    until(() => children.disconnect());
    this.#stage = new Stage(this.#tree.stage, this.#tree.frame, (width, height) => this.engine?.resize(width, height));
    until(() => this.#stage.stop());
    if (this.#host.autoplay) this.autoplay();
    this.update();
  }

  // Moving it within the document takes it out and puts it in again at once.
  disconnect() {
    this.#activation.end();
    queueMicrotask(() => !this.#host.isConnected && this.end());
  }

  end() {
    if (this.#life === null) return;
    this.#life.abort();
    this.#life = this.#stage = null;
    this.#game.stop();
    this.#viewStatus.stop();
    this.#tree.canvas?.remove();
    this.#tree.canvas = this.ready = this.error = this.#asked = this.#loaded = this.#view = null;
    this.#isNear = this.#isSeen = this.#isAskedToPlay = false;
    this.#stands = true;
    hideMessage(this.#tree.message);
    this.#setState('idle');
  }

  // ---- What the attributes say

  // Soon, once for all that changes now.
  update() {
    if (this.#isUpdating || this.#life === null) return;
    this.#isUpdating = true;
    queueMicrotask(() => {
      this.#isUpdating = false;
      if (this.#life !== null) this.#take();
    });
  }

  #take() {
    try {
      this.#wanted = null;
      const wanted = readAttributes(this.#host);
      this.#show(wanted);
      this.#wanted = wanted;
      if (!this.#isNear && wanted.loading === 'lazy') return;
      if (this.#host.scene === '' && !hasParsed(this.#host)) {
        whenParsed(this.#host, () => this.update(), this.#life);
        return;
      }
      const scene = findScene(this.#host);
      const tour = this.#host.tour === '' ? null : tourAddress(this.#host);
      if (scene === null && tour === null) throw new Trouble('There is no scene', 'scene: found nothing, expected an address, or a scene inside the element', [], 'address');
      const key = [scene?.key, tour?.href, wanted.engine].join('\n');
      if (key !== this.#asked) this.#load(key, { kind: wanted.engine, source: scene?.source() ?? null, tour });
      else if (key === this.#loaded) this.#settle();
    } catch (error) {
      this.#fail(error);
    }
  }

  #show({ size, controls, keys, poster }) {
    if (this.#stage.size !== size) this.#stage.setSize(size);
    this.#activation.setKeys(keys);
    this.#controls.show(controls);
    const image = this.#tree.poster;
    image.hidden = poster === '' || this.ready !== null;
    if (poster !== '' && image.getAttribute('src') !== poster) image.src = poster;
    this.#showNames();
  }

  #showNames() {
    const name = this.#host.label || this.ready?.title || 'Raycaster';
    const { cover, canvas, hint } = this.#tree;
    const act = this.state === 'playing' ? 'Move around' : 'Play';
    this.#internals.ariaLabel = name;
    canvas?.setAttribute('aria-label', name);
    cover.setAttribute('aria-label', `${act}: ${name}`);
    hint.textContent = act;
  }

  // ---- Loading

  #loadNow() {
    if (this.#isNear || this.#life === null) return;
    this.#isNear = true;
    this.update();
  }

  async #load(key, request) {
    const isStale = () => this.#asked !== key || this.#life === null;
    this.#asked = key;
    this.#clearError();
    this.#setState('loading');
    this.#run();
    try {
      const isThere = await this.#game.load({ ...request, onProgress: (share, bytes) => !isStale() && this.#showProgress(share, bytes) });
      if (!isThere || isStale()) return;
      this.#loaded = key;
      this.ready = this.#view = null;
      const { engine } = this.#game;
      engine.resize(this.#stage.width, this.#stage.height);
      if (this.#wanted === null) return; // the attribute at fault is shown, and once it is mended, the scene
      this.#apply();
      const picture = new Promise((resolve) => {
        this.#pictureCame = resolve;
        setTimeout(resolve, kFirstPictureMilliseconds);
      });
      engine.begin();
      await picture;
      if (!isStale()) this.#settle();
    } catch (error) {
      if (isStale()) return;
      this.#asked = this.#loaded;
      this.#fail(error);
    }
  }

  // Options, overlays and the view, as they are wanted now.
  #apply() {
    const { options, overlay, view } = this.#wanted;
    this.#game.setOptions([...options, ...overlay.map((name) => [name, 'on'])]);
    if (view === null || this.#host.view === this.#view) return;
    // A tour begins where it was recorded.
    if (!this.#game.hasTour && !this.#game.look(view)) {
      throw new Trouble('There is no such view', `view: found "${this.#host.view}", expected an eye above the floor of one of the scene's maps`, [], 'address');
    }
    this.#view = this.#host.view;
  }

  // All is as the attributes say.
  #settle() {
    const isNew = this.ready === null;
    this.#apply();
    this.engine.begin();
    this.#clearError();
    if (isNew) {
      const { title, maps } = this.engine.world;
      this.ready = { title, maps, memory: this.engine.memoryBytes };
    }
    this.#tree.poster.hidden = true;
    this.#tree.progress.hidden = true;
    this.#setState('paused');
    this.#run();
    this.#showNames();
    this.showControls();
    this.#waiting?.resolve(this.ready);
    this.#waiting = null;
    if (!isNew) return;
    this.#viewStatus.moved();
    this.#tell('ready', this.ready);
    this.#activation.resume();
  }

  #showProgress(share, bytes) {
    const { progress } = this.#tree;
    progress.hidden = share >= 1;
    progress.style.setProperty('--share', String(share));
    progress.setAttribute('aria-valuenow', String(Math.round(share * 100)));
    this.#tell('progress', { share, bytes });
  }

  #fail(error) {
    const detail = explain(error);
    if (error instanceof WebAssembly.RuntimeError) {
      this.#game.stop();
      this.#asked = this.#loaded = this.ready = null;
    }
    this.error = detail;
    this.#activation.end();
    this.#tree.progress.hidden = true;
    showMessage(this.#tree.message, detail, () => this.#retry());
    this.#setState('error');
    this.#run();
    this.#waiting?.reject(Object.assign(new Error(detail.message), detail));
    this.#waiting = null;
    this.#tell('error', detail);
  }

  #retry() {
    this.#clearError();
    this.#loadNow();
    this.update();
  }

  #clearError() {
    this.error = null;
    hideMessage(this.#tree.message);
  }

  // ---- Playing

  get #canPlay() {
    return this.ready !== null && this.error === null && this.state !== 'loading';
  }

  autoplay() {
    if (!matchMedia('(prefers-reduced-motion: reduce)').matches) this.play();
  }

  #see(isSeen) {
    this.#isSeen = isSeen;
    this.#run();
  }

  // The state, and the engine, as they must be now.
  #run() {
    if (this.#canPlay) this.#setState(this.paused ? 'paused' : 'playing');
    this.#stands = this.state !== 'playing' || !this.#isSeen;
    if (this.engine !== null) this.engine.paused = this.#stands;
  }

  #setState(state) {
    if (state === this.state) return;
    this.state = state;
    this.#tree.box.dataset.state = state;
    this.#showNames();
    this.showControls();
    this.#tell('statechange', { state });
  }

  play() {
    this.#isAskedToPlay = true;
    this.#loadNow();
    this.#run();
  }

  pause() {
    this.#isAskedToPlay = false;
    this.#activation.end();
    this.#run();
  }

  // By the cover or the bar: as a click on the picture.
  hold() {
    this.#activation.begin();
  }

  // Where the scene begins for this element.
  reset() {
    this.#game.reset();
    this.#view = null;
    this.#apply();
  }

  setOption(name, value) {
    this.#game.setOption(name, value);
    this.showControls();
  }

  focus(options) {
    this.#activation.focus(options);
  }

  toggleFullScreen() {
    if (this.#host.matches(':fullscreen')) document.exitFullscreen();
    else this.#host.requestFullscreen?.().catch(() => this.showStatus('This page does not allow full screen'));
  }

  whenReady() {
    if (this.#canPlay && !this.#isUpdating) return Promise.resolve(this.ready);
    this.#loadNow();
    this.#waiting ??= withResolvers();
    return this.#waiting.promise;
  }

  // ---- What the engine tells

  #showCanvas(canvas) {
    canvas.setAttribute('part', 'picture');
    canvas.setAttribute('aria-describedby', 'seen');
    this.#tree.canvas?.remove();
    this.#tree.canvas = canvas;
    this.#tree.frame.append(canvas);
    this.#activation.takeCanvas();
    this.#showNames();
  }

  #hear(event, value) {
    switch (event) {
      case 'ready':
        this.#pictureCame();
        break;
      case 'frame':
        this.#pictureCame();
        if (this.ready !== null) this.#tell('framechange', { steps: this.engine.steps });
        break;
      case 'view':
        this.#viewStatus.moved();
        if (this.ready !== null) this.#tell('viewchange', { view: this.engine.view });
        break;
      case 'portal':
        this.#tell('portal', value);
        break;
      case 'pause':
        // Not by us: by its key.
        if (value !== this.#stands) this.pause();
        break;
      case 'fly':
        this.#activation.flying = value;
        break;
      case 'cursor':
        this.showStatus(value ? kCursorHint : '');
        break;
      case 'minimap':
        this.showControls();
        break;
      case 'fullscreen':
        this.toggleFullScreen();
        break;
    }
  }

  showControls() {
    const isReady = this.#canPlay;
    this.#controls.state({
      isReady,
      isPlaying: this.state === 'playing',
      hasOverlay: isReady && kOverlays.some((name) => this.engine.option(name) === 'on'),
      isFullscreen: this.#host.matches(':fullscreen'),
    });
  }

  showStatus(text) {
    this.#tree.status.textContent = text;
  }

  #tell(name, detail) {
    this.#host.dispatchEvent(new CustomEvent(name, { detail }));
  }
}

function withResolvers() {
  const made = {};
  made.promise = new Promise((resolve, reject) => Object.assign(made, { resolve, reject }));
  made.promise.catch(() => {}); // whoever waits hears of it
  return made;
}

// The implementation of <ray-caster>: connects to the page, loads what the attributes name, and
// runs the engine while it is visible and either playing (autoplay, play()) or steered
// (steering.js). Its pieces: tree.js and face.js (what is visible), game.js (the engine),
// loading.js (from attributes to engine).
//
//     const show = new Show(element, internals);       // with a shadow root
//     show.connect();   show.update();   show.disconnect();
//     show.play();      show.pause();

import { kOverlays } from '../engine/address.js';
import { Stage } from './stage.js';
import { Trouble, isEngineFailure } from '../engine/trouble.js';
import { asError, frameDetail, isFinger, withResolvers } from './details.js';
import { Face } from './face.js';
import { explain } from './faults.js';
import { Game } from './game.js';
import { bringMore, bringSteering } from './later-parts.js';
import { Loading } from './loading.js';
import { forgetFiles, holdCache } from './page-cache.js';
import { Styles } from './styles.js';
import { buildTree } from './tree.js';
import { ViewStatus } from './view-status.js';
import { canBeSeen, watchVisibility } from './visibility.js';

const kDeadMilliseconds = 500; // no picture for so long after some engine crashed: it was this one
const kModes = ['recording', 'replay', 'cursor', 'fly'];
const kDegreesPerPixel = 0.15; // of the mouse
const shows = new WeakMap(); // element -> its show
const kFramesToPace = 4; // frames before the automatic size starts
// Options that count columns of the picture: the size must not change meanwhile.
const kCounting = ['grid', 'inspector', 'slow'];
const kNear = ['pointerenter', 'pointerdown', 'focusin']; // somebody may soon steer

export class Show {
  state = 'idle';
  error = null; // ErrorDetail
  ready = null; // ReadyDetail of the current scene
  #host;
  #hotspots = null;
  #partner = null;
  #partnersShow = null;
  #wasNear = false; // one of kNear has happened
  #tree;
  #face;
  #game;
  #styles;
  #steering = null; // once loaded
  #viewStatus;
  #life = null; // while the element is in the document: an AbortController
  #stage = null;
  #pace = null; // after kFramesToPace frames
  #frames = 0; // drawn before that
  #mouse = { speed: 1, invert: false };
  #isMuted = false;
  #waiting = null; // of whenReady(): {promise, resolve, reject}
  #loading = null; // while connected
  #noSteering = null; // why the bar could not load
  #isSeen = false;
  #isAskedToPlay = false;
  #isTouched = false;
  #lastPress = null; // the event
  #pending = null; // {touch, mouse} of a press that waits for steering.js to load
  #stands = true;
  #pictures = 0;

  constructor(host, internals) {
    this.#host = host;
    shows.set(host, this);
    this.#tree = buildTree(host.shadowRoot);
    this.#styles = new Styles(host.shadowRoot);
    this.#face = new Face(this.#tree, internals);
    this.#game = new Game({
      showCanvas: (canvas) => this.#showCanvas(canvas),
      hear: (event, value) => this.#hear(event, value),
      takesKey: (code) => this.#steering?.takesKey(code) === true,
    });
    this.#viewStatus = new ViewStatus(this.#tree, () => this.engine);
    this.#listenToPresses(this.#tree);
    for (const type of kNear) this.#tree.box.addEventListener(type, () => this.#comeNear());
    host.addEventListener('fullscreenchange', () => this.showState());
  }

  get host() {
    return this.#host;
  }

  get engine() {
    return this.#game.engine;
  }

  get source() {
    return this.#game.source;
  }

  get entered() {
    return this.#steering?.isHeld === true;
  }

  get paused() {
    return !this.#isAskedToPlay && !this.entered;
  }

  get warnings() {
    return this.#loading?.warnings.list ?? [];
  }

  get overlays() {
    return this.#loading?.wanted?.overlay ?? [];
  }

  get picture() {
    return this.ready === null
      ? { width: 0, height: 0 }
      : { width: this.#stage.width, height: this.#stage.height };
  }

  // ---- Life

  connect() {
    if (this.#life !== null || !canBeSeen()) return; // only moved, or nothing to do
    this.#life = new AbortController();
    const { signal } = this.#life;
    const until = (act) => signal.addEventListener('abort', act);
    until(holdCache());
    until(
      watchVisibility(this.#host, {
        near: () => this.#loading.near(),
        seen: (isSeen) => this.#see(isSeen),
      }),
    );
    this.#loading = new Loading(this.#host, this.#game, {
      show: (wanted) => this.#show(wanted),
      changed: () => this.#clearError(),
      warn: (warning) => this.#warn(warning),
      progress: (share, bytes) => {
        this.#face.progress(share);
        this.tell('progress', { share, bytes });
      },
      loaded: () => this.#loaded(),
      done: (isNew) => this.#done(isNew),
      failed: (error) => this.#fail(error),
    });
    until(() => this.#loading.stop());
    const children = new MutationObserver(() => this.update());
    children.observe(this.#host, { childList: true, characterData: true, subtree: true });
    until(() => children.disconnect());
    this.#stage = new Stage(this.#tree.stage, this.#tree.frame, (width, height) =>
      this.engine?.resize(width, height),
    );
    until(() => this.#stage.stop());
    window.addEventListener(
      'error',
      ({ error }) => isEngineFailure(error) && this.#findDead(error),
      { signal },
    );
    window.addEventListener('beforeprint', () => this.#loading.near(), { signal });
    // play() or whenReady() was called before it was in the page.
    if (this.#isAskedToPlay || this.#waiting !== null) this.#loading.now();
    if (this.#host.autoplay) this.autoplay();
    this.update();
  }

  // Moving the element disconnects and connects it at once.
  disconnect() {
    this.#letGo();
    queueMicrotask(() => !this.#host.isConnected && this.end());
  }

  adopted() {
    this.end();
    this.#styles.adopt();
  }

  end() {
    if (this.#life === null) return;
    this.#life.abort();
    this.#life = this.#stage = this.#loading = null;
    this.#drop();
    this.#viewStatus.stop();
    this.#face.stop();
    this.#steering?.stop();
    this.#hotspots?.stop();
    this.#partner?.stop();
    this.#pace?.leave();
    this.#pace = null;
    this.#frames = 0;
    this.#hotspots = this.#partner = this.#partnersShow = null;
    this.error = this.#noSteering = null;
    this.#isSeen = this.#isAskedToPlay = false;
    this.run();
  }

  // The game, and the engine with it.
  #drop() {
    this.#game.stop();
    this.#tree.canvas?.remove();
    this.#tree.canvas = this.ready = null;
    this.#loading?.forget();
  }

  // ---- Loading

  update() {
    this.#loading?.update();
  }

  // The scene is in the engine, but has no picture yet.
  #loaded() {
    this.ready = null;
    this.#stage.layOut();
    this.engine.resize(this.#stage.width, this.#stage.height);
    this.#setMouse();
  }

  // Everything is as the attributes say.
  #done(isNew) {
    if (isNew) {
      const { title, maps } = this.engine.world;
      this.ready = { title, maps, memory: this.engine.memoryBytes };
      this.#face.title = title;
      this.#face.hidePoster();
    }
    if (this.#loading.wanted.controls === null) this.#noSteering = null;
    if (this.#noSteering === null) this.#clearError();
    this.#waiting?.resolve(this.ready);
    this.#waiting = null;
    if (isNew) {
      this.#viewStatus.moved();
      this.tell('ready', this.ready);
      this.#steering?.resume();
    }
    if (this.#noSteering !== null) this.#fail(this.#noSteering);
    else if (this.#loading.wanted.controls !== null)
      this.#steered().catch((error) => this.#failWithoutSteering(error));
  }

  #failWithoutSteering(error) {
    this.#noSteering = error;
    if (this.#life !== null) this.#fail(error);
  }

  #show(wanted) {
    this.#styles.size = wanted.size;
    if (this.#stage.size !== wanted.size) this.#stage.setSize(wanted.size);
    this.#face.attributes(wanted, this.ready !== null);
    // interaction="none" hides the play button; but with loading="click" the first click still
    // loads.
    const isShut = wanted.interaction === 'none' && !this.#loading.waitsForClick;
    this.#tree.box.classList.toggle('shut', isShut);
    this.#steering?.attributes(wanted);
    if (this.#loading.mayLoad) this.#bringMore(wanted);
  }

  #comeNear() {
    const { waitsForClick, wanted } = this.#loading ?? { waitsForClick: true };
    if (this.#wasNear || waitsForClick || wanted?.interaction === 'none') return;
    this.#wasNear = true;
    this.#steered().catch(() => {});
  }

  // ---- Hotspots and shared views

  #bringMore({ syncwith }) {
    const hasSpots = this.#host.querySelector(':scope > [data-at]') !== null;
    if (syncwith === '') {
      this.#partner?.stop();
      this.#partner = this.#partnersShow = null;
    }
    if ((!hasSpots || this.#hotspots !== null) && syncwith === '') return;
    const life = this.#life;
    bringMore().then(
      ({ Hotspots, Partner }) => {
        if (this.#life === null || this.#life !== life) return;
        if (hasSpots)
          this.#hotspots ??= new Hotspots(
            this.#host,
            this.#tree,
            () => (this.ready === null || this.error !== null ? null : this.engine),
            () => this.#loading.warnings.renew('data-at'),
          );
        if (syncwith !== '') this.#join(syncwith, Partner);
      },
      (error) => console.warn(error.message),
    );
  }

  #join(selector, Partner) {
    const { ownerDocument: page } = this.#host;
    const warn = this.#loading.warnings.renew('syncwith');
    let found = null;
    try {
      found = this.#host.getRootNode().querySelector(selector);
    } catch {
      // Not a valid selector.
    }
    const other = found === this.#host ? undefined : shows.get(found);
    if (other === undefined && page.readyState === 'loading')
      page.addEventListener('DOMContentLoaded', () => this.update(), { once: true });
    else if (other === undefined) warn('syncwith', `'${selector}' finds no other <ray-caster>.`);
    if (other === this.#partnersShow) return;
    this.#partner?.stop();
    this.#partner = other === undefined ? null : new Partner(this, other);
    this.#partnersShow = other ?? null;
  }

  // Starts the automatic size.
  #keepPace() {
    const life = this.#life;
    const isCounted = () =>
      this.engine !== null &&
      (kCounting.some((name) => this.engine.option(name) === 'on') ||
        this.engine.option('drawnColumns') !== '-1');
    bringMore().then(
      ({ joinPace }) => {
        if (life === null || this.#life !== life) return;
        this.#pace = joinPace({ setScale: (scale) => this.#stage.setScale(scale), isCounted });
        this.#pace.plays(!this.#stands);
      },
      (error) => console.warn(error.message),
    );
  }

  // ---- Errors

  #fail(error) {
    if (isEngineFailure(error)) this.#drop();
    const { root, message } = this.#tree;
    const hadFocus = root.activeElement !== null;
    const before = this.error;
    this.error = explain(error);
    this.#waiting?.reject(asError(this.error));
    this.#waiting = null;
    // Does not report the same error again: a page may react by writing into the element, which
    // then tries again.
    if (JSON.stringify(this.error) === JSON.stringify(before)) return;
    if (this.error.faults.length > 0)
      console.warn(`<ray-caster> ${asError(this.error).message}`, this.#host);
    this.#letGo();
    this.#steering?.stop();
    this.#face.trouble(this.error, () => this.#retry());
    this.run();
    if (hadFocus) message.focus({ preventScroll: true });
    this.tell('error', this.error);
  }

  #retry() {
    this.#noSteering = null;
    this.#again(null);
  }

  // Plays another text of the same scene; see the methods update and findMistakes.
  async renew(scene, isAside = false) {
    const report = await this.#game.renew(scene, isAside);
    if (report?.faults?.length === 0 && this.#life !== null) this.#done(true);
    return report;
  }

  // Fetches the scene again.
  reload({ keepEye = false } = {}) {
    if (this.#loading !== null) this.#again({ keepEye });
  }

  #again(how) {
    forgetFiles();
    this.#clearError();
    this.#loading.again(how);
  }

  #clearError() {
    const { root, message, cover } = this.#tree;
    const hadFocus = message.contains(root.activeElement);
    this.error = null;
    this.#face.noTrouble();
    this.run();
    if (hadFocus) cover.focus({ preventScroll: true });
  }

  #warn({ attribute, message }) {
    console.warn(`<ray-caster> ${attribute}: ${message}`, this.#host);
    this.tell('warning', { attribute, message });
  }

  // Some engine of the page crashed while drawing; the browser does not say which.
  #findDead(error) {
    const { engine } = this;
    const before = this.#pictures;
    if (this.#stands || document.hidden) return;
    setTimeout(
      () =>
        this.engine === engine && this.#pictures === before && !this.#stands && this.#fail(error),
      kDeadMilliseconds,
    );
  }

  // ---- Playing

  get canPlay() {
    return this.ready !== null && this.error === null && !this.#loading?.isLoading;
  }

  play() {
    this.#isAskedToPlay = true;
    this.#loading?.now();
    this.run();
  }

  autoplay() {
    // Before connect(): it calls this again.
    if (this.#life === null || matchMedia('(prefers-reduced-motion: reduce)').matches) return;
    this.#isAskedToPlay = true;
    this.run();
  }

  pause() {
    this.#isAskedToPlay = false;
    this.#letGo();
    this.run();
  }

  // Ends steering, and forgets a press that waits.
  #letGo() {
    this.#pending = null;
    this.#tree.box.classList.remove('waiting');
    this.#steering?.end();
  }

  // Acts like a click on the picture; with `mouse` it also captures the mouse, as a second click
  // would.
  hold({ mouse = false, touch = this.#isTouched } = {}) {
    const { root, box, cover } = this.#tree;
    if (!canBeSeen()) return;
    if (this.#loading?.wanted?.interaction === 'none') {
      this.play();
      return;
    }
    // Safari does not focus pressed buttons, but the focus tells whether the press still counts
    // once everything has loaded.
    if (root.activeElement !== cover) cover.focus({ preventScroll: true });
    this.#loading?.now();
    const press = { touch, mouse: mouse || this.#pending?.mouse === true };
    if (this.#steering !== null) {
      this.#steering.begin(press);
      return;
    }
    this.#pending = press;
    box.classList.add('waiting');
    this.#steered().then(
      (steering) => {
        if (this.#pending !== press) return; // cancelled, or a later press
        this.#letGo();
        if (root.activeElement === cover) steering.begin(press);
      },
      (error) => {
        this.#letGo();
        if (this.#life !== null) this.#fail(error);
      },
    );
  }

  // Notes whether the last press was by a finger or a pen, to show thumbs.
  #listenToPresses({ box, cover }) {
    box.addEventListener(
      'pointerdown',
      (event) => {
        this.#isTouched = isFinger(event);
        this.#lastPress = event;
      },
      { capture: true },
    );
    box.addEventListener(
      'keydown',
      () => {
        this.#isTouched = false;
      },
      { capture: true },
    );
    // The page's own listeners come first: it may keep a click by preventDefault().
    cover.addEventListener('click', (event) => {
      const press = event.detail > 0 ? this.#lastPress : null; // none of a key
      setTimeout(() => {
        if (!event.defaultPrevented && press?.defaultPrevented !== true) this.hold();
      });
    });
  }

  // Loads steering.js when somebody may soon steer, or the bar is wanted.
  async #steered() {
    if (this.#steering !== null) return this.#steering;
    const { Steering } = await bringSteering();
    if (this.#steering === null) {
      this.#steering = new Steering(this.#host, this, this.#tree, this.#styles);
      if (this.#loading?.wanted) this.#steering.attributes(this.#loading.wanted);
      if (this.#tree.canvas !== null) this.#steering.takeCanvas();
      this.showState();
      if (this.#noSteering !== null) this.update();
      this.#noSteering = null;
    }
    return this.#steering;
  }

  #see(isSeen) {
    this.#isSeen = isSeen;
    if (isSeen) this.#stage.layOut();
    else this.#steering?.end();
    this.run();
  }

  // Updates the state, and pauses or resumes the engine.
  run() {
    const isReady = this.ready !== null;
    const state =
      this.error !== null
        ? 'error'
        : this.#loading?.isLoading
          ? 'loading'
          : !isReady
            ? 'idle'
            : this.paused
              ? 'paused'
              : 'playing';
    this.#stands = state !== 'playing' || !this.#isSeen;
    if (this.engine !== null) this.engine.paused = this.#stands;
    this.#pace?.plays(!this.#stands);
    if (state === this.state) return;
    this.state = state;
    this.#hotspots?.place();
    this.showState();
    this.tell('statechange', { state });
  }

  showState() {
    const isReady = this.canPlay;
    const hasOverlay = isReady && kOverlays.some((name) => this.engine.option(name) === 'on');
    this.#face.state(this.state);
    this.#steering?.state({
      isReady,
      isPlaying: this.state === 'playing',
      hasOverlay,
      isFullscreen: this.#host.matches(':fullscreen'),
      isMuted: this.muted,
    });
  }

  showStatus(text, how) {
    this.#face.status(text, how);
  }

  // Back to the start, or to the view of the attribute.
  reset() {
    this.#game.reset();
    this.#loading.applyView();
  }

  setOption(name, value) {
    this.#game.setOption(name, value);
    this.showState();
  }

  set mouse(mouse) {
    this.#mouse = mouse;
    this.#setMouse();
  }

  get mouse() {
    return this.#mouse;
  }

  set muted(muted) {
    if (this.#isMuted === Boolean(muted)) return;
    this.#isMuted = !this.#isMuted;
    this.showState();
    this.tell('modechange', { mode: 'sound', on: !this.#isMuted });
  }

  get muted() {
    return this.#isMuted;
  }

  #setMouse() {
    const { speed, invert } = this.#mouse;
    this.engine?.setMouse({ degreesPerPixel: kDegreesPerPixel * speed, invert });
  }

  focus(options) {
    const { message, cover } = this.#tree;
    (this.error !== null ? message : (this.#steering ?? cover)).focus(options);
  }

  whenReady() {
    if (!canBeSeen())
      return Promise.reject(
        new Trouble('There is no browser', 'Nothing is drawn here; slicecast/node draws in Node.'),
      );
    const isSettled = this.#loading?.isSettled === true;
    if (isSettled && this.canPlay) return Promise.resolve(this.ready);
    if (isSettled && this.error !== null) return Promise.reject(asError(this.error));
    this.#loading?.now();
    this.#waiting ??= withResolvers();
    return this.#waiting.promise;
  }

  // ---- Events of the engine

  #showCanvas(canvas) {
    canvas.setAttribute('part', 'picture');
    canvas.setAttribute('aria-describedby', 'seen');
    this.#tree.canvas?.remove();
    this.#tree.canvas = canvas;
    this.#tree.frame.append(canvas);
    // Tab reaches it only during steering; otherwise the cover.
    canvas.tabIndex = -1;
    canvas.setAttribute('role', 'img');
    this.#face.name();
    this.#steering?.takeCanvas();
  }

  #hear(event, value) {
    switch (event) {
      case 'frame':
        ++this.#pictures;
        this.#loading?.pictureCame();
        this.#hotspots?.place();
        if (this.ready !== null) this.tell('framechange', frameDetail(this.engine));
        break;
      case 'animation':
        if (this.ready === null) this.#loading?.pictureGoesOn();
        if (this.#pace !== null) this.#pace.drew(value.time, value.milliseconds);
        else if (++this.#frames === kFramesToPace) this.#keepPace();
        break;
      case 'view':
        this.#viewStatus.moved();
        if (this.ready !== null) this.tell('viewchange', { view: this.engine.view });
        break;
      case 'quest':
        for (const { kind, ...detail } of this.engine.takeNews()) this.tell(kind, detail);
        break;
      case 'portal':
        this.tell('portal', value);
        break;
      case 'pause':
        if (value !== this.#stands) this.pause(); // the pause key
        break;
      case 'overlay':
        this.showState();
        break;
      case 'frames':
        this.tell('pace', { ...value, ...this.picture });
        break;
      default:
        if (kModes.includes(event)) this.tell('modechange', { mode: event, on: value });
        this.#steering?.hear(event, value);
    }
  }

  // Returns false if the page cancelled the event.
  tell(name, detail, cancelable = false) {
    return this.#host.dispatchEvent(new CustomEvent(name, { detail, cancelable }));
  }
}

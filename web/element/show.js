// What a <ray-caster> does behind its attributes and methods: it comes to life in the page, loads
// what the attributes say, and runs the engine while the world is asked to play (autoplay, play())
// or held (steering.js), and can be seen. The pieces: tree.js and face.js (what is seen), game.js
// (the engine), loading.js (from the attributes to the engine).
//
//     const show = new Show(element, internals);       // with a shadow root
//     show.connect();   show.update();   show.disconnect();
//     show.play();      show.pause();

import { kOverlays } from '../engine/address.js';
import { Stage } from './stage.js';
import { isEngineFailure } from '../engine/trouble.js';
import { asError, frameDetail, withResolvers } from './details.js';
import { Face } from './face.js';
import { explain } from './faults.js';
import { Game } from './game.js';
import { bringMore, bringSteering } from './late.js';
import { Loading } from './loading.js';
import { forgetFiles, holdCache } from './page-cache.js';
import { Styles } from './styles.js';
import { buildTree } from './tree.js';
import { ViewStatus } from './view-status.js';
import { watchVisibility } from './visibility.js';

const kDeadMilliseconds = 500; // without a picture after a failure of some engine, it was this one's
const kModes = ['recording', 'replay', 'cursor', 'fly'];
const kDegreesPerPixel = 0.15; // of the mouse
const shows = new WeakMap(); // element -> its show
const kFramesToPace = 4; // drawn one after the other
// Options that count columns of the picture: meanwhile its size stays.
const kCounting = ['grid', 'inspector', 'slow'];
const kNear = ['pointerenter', 'pointerdown', 'focusin']; // who does this may soon steer

export class Show {
  state = 'idle';
  error = null; // ErrorDetail
  ready = null; // ReadyDetail of the scene that plays
  #host;
  #hotspots = null;
  #partner = null;
  #partnersShow = null;
  #wasNear = false; // somebody came who may steer
  #tree;
  #face;
  #game;
  #styles;
  #steering = null; // once it was wanted
  #viewStatus;
  #life = null; // while the element is in the document: an AbortController
  #stage = null;
  #pace = null; // once it moves
  #frames = 0; // drawn before that
  #mouse = { speed: 1, invert: false };
  #waiting = null; // of whenReady(): {promise, resolve, reject}
  #loading = null; // the same
  #noSteering = null; // why there is no bar, although one is wanted; asked for again by who tries again
  #isSeen = false;
  #isAskedToPlay = false;
  #isTouched = false;
  #wish = null; // of who has pressed, and plays once what one steers by has come: {touch, mouse}
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
    if (this.#life !== null) return; // it was only moved
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
    // Asked before it was in the page
    if (this.#isAskedToPlay || this.#waiting !== null) this.#loading.now();
    if (this.#host.autoplay) this.autoplay();
    this.update();
  }

  // Moving it within the document takes it out and puts it in again at once.
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

  // The scene is in the engine; its first picture is to come.
  #loaded() {
    this.ready = null;
    if (this.#stage.width === undefined) this.#stage.layOut();
    this.engine.resize(this.#stage.width, this.#stage.height);
    this.#setMouse();
  }

  // All is as the attributes say.
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
    // Without a sign to press, and the picture as one that is looked at; a first click loads all the
    // same where one is asked for.
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

  // ---- What stands on the picture, and who looks from the same place

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
      // It is no selector, and finds nothing.
    }
    const other = found === this.#host ? undefined : shows.get(found);
    if (other === undefined && page.readyState === 'loading')
      page.addEventListener('DOMContentLoaded', () => this.update(), { once: true });
    else if (other === undefined)
      warn('syncwith', `No other <ray-caster> is found by '${selector}'.`);
    if (other === this.#partnersShow) return;
    this.#partner?.stop();
    this.#partner = other === undefined ? null : new Partner(this, other);
    this.#partnersShow = other ?? null;
  }

  // From now on the picture is as large as the page's budget allows.
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

  // ---- What is wrong

  #fail(error) {
    if (isEngineFailure(error)) this.#drop();
    const { root, message } = this.#tree;
    const hadFocus = root.activeElement !== null;
    const before = this.error;
    this.error = explain(error);
    this.#waiting?.reject(asError(this.error));
    this.#waiting = null;
    // What is wrong already is not told again: the page may write about it into the element, which
    // then looks whether it is still wrong.
    if (JSON.stringify(this.error) === JSON.stringify(before)) return;
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

  // The scene as it is now, fetched anew.
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

  // Some engine of the page has failed while it drew; the browser does not say whose.
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
    if (this.#life === null || matchMedia('(prefers-reduced-motion: reduce)').matches) return; // connect() comes back to it
    this.#isAskedToPlay = true;
    this.run();
  }

  pause() {
    this.#isAskedToPlay = false;
    this.#letGo();
    this.run();
  }

  // Nobody steers, nor is about to.
  #letGo() {
    this.#wish = null;
    this.#tree.box.classList.remove('waiting');
    this.#steering?.end();
  }

  // As a click on the picture; with `mouse` it takes the mouse along, as the next click would.
  hold({ mouse = false, touch = this.#isTouched } = {}) {
    const { root, box, cover } = this.#tree;
    if (this.#loading?.wanted?.interaction === 'none') {
      this.play();
      return;
    }
    // Safari gives pressed buttons no focus; it is what remembers the wish while anything is still
    // to come.
    if (root.activeElement !== cover) cover.focus({ preventScroll: true });
    this.#loading?.now();
    const wish = { touch, mouse: mouse || this.#wish?.mouse === true };
    if (this.#steering !== null) {
      this.#steering.begin(wish);
      return;
    }
    this.#wish = wish;
    box.classList.add('waiting');
    this.#steered().then(
      (steering) => {
        if (this.#wish !== wish) return; // taken back, or another one
        this.#letGo();
        if (root.activeElement === cover) steering.begin(wish);
      },
      (error) => {
        this.#letGo();
        if (this.#life !== null) this.#fail(error);
      },
    );
  }

  // The last press was a finger's: then there are thumbs.
  #listenToPresses({ box, cover }) {
    box.addEventListener(
      'pointerdown',
      ({ pointerType }) => {
        this.#isTouched = pointerType === 'touch';
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
    cover.addEventListener('click', () => this.hold());
  }

  // What one steers by, fetched when somebody comes near or wants the bar.
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
    this.run();
  }

  // The state, and the engine, as they must be now.
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
    });
  }

  showStatus(text, how) {
    this.#face.status(text, how);
  }

  // Where the scene begins for this element.
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

  #setMouse() {
    const { speed, invert } = this.#mouse;
    this.engine?.setMouse({ degreesPerPixel: kDegreesPerPixel * speed, invert });
  }

  focus(options) {
    const { message, cover } = this.#tree;
    (this.error !== null ? message : (this.#steering ?? cover)).focus(options);
  }

  whenReady() {
    const isSettled = this.#loading?.isSettled === true;
    if (isSettled && this.canPlay) return Promise.resolve(this.ready);
    if (isSettled && this.error !== null) return Promise.reject(asError(this.error));
    this.#loading?.now();
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
    // Only who steers it can tab to it; before, there is its cover.
    canvas.tabIndex = -1;
    canvas.setAttribute('role', 'img');
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
        if (this.#pace !== null) this.#pace.drew(value.time, value.milliseconds);
        else if (++this.#frames === kFramesToPace) this.#keepPace();
        break;
      case 'view':
        this.#viewStatus.moved();
        if (this.ready !== null) this.tell('viewchange', { view: this.engine.view });
        break;
      case 'portal':
        this.tell('portal', value);
        break;
      case 'pause':
        if (value !== this.#stands) this.pause(); // by its key
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

  // False if the page has kept it from going on, where it can.
  tell(name, detail, cancelable = false) {
    return this.#host.dispatchEvent(new CustomEvent(name, { detail, cancelable }));
  }
}

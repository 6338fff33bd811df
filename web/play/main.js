// The page: loads the engine and a scene, and carries messages between the engine, the address
// line, the settings and what is to be seen.
//
// Parameters of the address: scene=NAME or a path, view=, options= and overlay= as address.js
// spells them, tour=NAME (a recording of the folder tours, which names its scene), live=1
// (tools/play says when the scene was saved), engine=simd or scalar.

import { parseView } from '../engine/address.js';
import { fetchEngine } from '../engine/engine-files.js';
import { Engine } from '../engine/engine.js';
import { askAnew } from '../engine/fetch-bytes.js';
import { listenForFiles } from './file-drop.js';
import { Gamepads } from '../element/gamepads.js';
import { GivenOptions, lookFrom } from './given.js';
import { showKeys } from './key-help.js';
import { guardLeaving } from './leave-guard.js';
import { saveFile } from '../element/save-file.js';
import { SceneMenu } from './scene-menu.js';
import { listScenes, sceneAmong, sceneAt } from './scene-source.js';
import { Settings } from './settings.js';
import { ShareDialog } from './share.js';
import { withReason } from '../engine/source-parts.js';
import { Stage } from '../element/stage.js';
import { Thumbs } from '../element/thumbs.js';
import { readTour } from './tours.js';
import { Trouble, asTrouble } from '../engine/trouble.js';
import { TroubleSheet } from './trouble-sheet.js';

const kEngineShare = 0.5; // of the loading bar
const kUsualDegreesPerPixel = 0.15; // mouse

const kShareKey = { code: 'KeyZ', keys: ['Z'], does: 'share this view' }; // the page's own, beside the engine's

const kModes = {
  recording: 'Recording; F9 saves it',
  replay: 'A recorded tour; move to take over',
  cursor: "The mouse's place steers; Escape ends it",
};

const find = (id) => document.getElementById(id);
const canvas = find('picture');
const parameters = () => new URLSearchParams(location.search);
const isLive = () => parameters().get('live') === '1';

class Page {
  engine = null;
  scenes = [];
  current = null; // what is open: {source, reference, about, view}; the reference is null for dropped files, the view for the scene's start
  #asked = null; // the same of what was asked for last, be it there or not
  #dropped = null; // files that came before the engine
  #loads = 0;
  #played = false;
  #modes = new Set();

  constructor() {
    this.stage = new Stage(find('stage'), find('frame'), (width, height) =>
      this.engine?.resize(width, height),
    );
    this.settings = new Settings(find('settings').querySelector('form'), (name) =>
      this.applySetting(name),
    );
    this.given = new GivenOptions(this.settings);
    this.share = new ShareDialog(find('share'));
    this.trouble = new TroubleSheet(find('trouble'));
    this.#listen();
  }

  async start() {
    const kind = parameters().get('engine') ?? 'auto';
    try {
      if (!['auto', 'simd', 'scalar'].includes(kind)) {
        throw new Trouble(
          'The address names no such engine',
          `Found engine=${kind}, expected engine=simd or engine=scalar.`,
        );
      }
      this.#showProgress('Fetching the engine', 0, 0);
      const [files, scenes] = await Promise.all([
        fetchEngine({
          kind,
          onBytes: (loaded, total) =>
            this.#showProgress('Fetching the engine', (kEngineShare * loaded) / total, loaded),
        }),
        listScenes().catch((error) => error),
      ]);
      this.engine = await Engine.create({
        files,
        canvas,
        onEvent: (event, value) => this.#hear(event, value),
      });
      this.#prepareEngine();
      this.#takeScenes(scenes);
      await (this.#dropped !== null ? this.#openDropped() : this.openFromAddress());
    } catch (error) {
      this.#fail(asTrouble(error), { again: () => location.reload() });
    }
  }

  // ---- Scenes

  async openFromAddress() {
    ++this.#loads; // what is on its way is overtaken, also by an address that cannot be opened
    const view = parameters().has('view') ? parseView(parameters().get('view')) : null;
    this.given.take(this.engine, parameters());
    const tour = parameters().get('tour');
    if (tour !== null) return this.openTour(tour);
    const reference = parameters().get('scene') ?? this.scenes[0]?.file;
    if (reference === undefined)
      throw new Trouble(
        'There is no scene to open',
        'The address names none, and the list of scenes could not be loaded.',
      );
    await this.open({ ...this.#inAddress(reference), view });
  }

  #openNewAddress() {
    this.openFromAddress().catch((error) => this.#fail(asTrouble(error), { again: null }));
  }

  // A recording of the page's, played in its scene from the start.
  async openTour(name) {
    const bytes = await this.#unlessOvertaken(readTour(name));
    if (bytes === null) return;
    const { scene, faults } = this.engine.readRecording(bytes, `${name}.txt`);
    if (faults.length > 0) throw faultsTrouble(`${name}.txt`, faults);
    if (await this.open(this.#inAddress(scene))) this.engine.replay();
  }

  // What comes, or null if something else was asked for meanwhile: then its failure is nobody's
  // either.
  async #unlessOvertaken(coming) {
    const load = ++this.#loads;
    const isOvertaken = () => load !== this.#loads;
    try {
      const found = await coming;
      return isOvertaken() ? null : found;
    } catch (error) {
      if (isOvertaken()) return null;
      throw error;
    }
  }

  // F9: begins the scene anew and records it, or hands out what was recorded.
  async #record() {
    const text = this.engine.takeRecording();
    const name = this.current.source.name.replace(/\.json$/i, '');
    if (text !== '') saveFile(`${name}-recording.txt`, new Blob([text], { type: 'text/plain' }));
    else if (await this.open({ ...this.current, view: null })) {
      this.engine.record(name);
      this.play();
    }
  }

  #inAddress(reference) {
    const listed = this.scenes.find(
      (scene) => scene.file === reference || scene.file === `${reference}.json`,
    );
    return {
      source: sceneAt(reference),
      reference: listed?.file ?? reference,
      about: listed?.about ?? '',
      view: null,
    };
  }

  // Opens a scene; true if it can be played now. With `keepEye` the player stays where they are,
  // and no more is shown of it than need be.
  async open(scene, { keepEye = false } = {}) {
    const load = ++this.#loads;
    const wasPlaying = this.state === 'playing' || (keepEye && this.playsAfterTrouble);
    this.#asked = scene;
    if (!keepEye) {
      this.trouble.hide();
      this.engine.paused = true;
      this.#setState('loading');
      this.#showProgress(`Opening ${scene.source.name}`, this.hasPicture ? 0 : kEngineShare, 0);
    }
    const begin = this.hasPicture ? 0 : kEngineShare;
    try {
      const faults = await this.engine.loadScene(scene.source, {
        keepEye,
        isWanted: () => load === this.#loads,
        onProgress: (share, bytes) => {
          if (!keepEye)
            this.#showProgress(`Opening ${scene.source.name}`, begin + share * (1 - begin), bytes);
        },
      });
      if (faults === null) return false;
      if (faults.length > 0)
        throw faultsTrouble(
          scene.source.name,
          faults.map((fault) => withReason(fault, scene.source.failures)),
        );
      this.current = scene;
      for (const { message } of this.engine.warnings) console.warn(message);
      this.#showTitle();
      if (scene.view !== null) lookFrom(this.engine, scene.view);
    } catch (error) {
      if (load !== this.#loads) return false;
      this.playsAfterTrouble = wasPlaying;
      const isOver = error instanceof WebAssembly.RuntimeError;
      this.#fail(asTrouble(error), {
        again: isOver ? () => location.reload() : () => this.#openAgain(scene),
      });
      return false;
    }
    this.playsAfterTrouble = false;
    this.trouble.hide();
    this.engine.begin();
    if (keepEye && wasPlaying) this.play();
    else if (this.ready) this.#setState('paused'); // else the first picture is still to come
    return true;
  }

  #openAgain(scene) {
    askAnew();
    scene.source.failures.clear();
    return this.open(scene);
  }

  get hasPicture() {
    return document.body.hasAttribute('data-behind');
  }

  #showTitle() {
    const { title, gates } = this.engine.world;
    this.thumbs.hasGates = gates > 0;
    document.title = `${title} · Slicecast`;
    find('bar-title').textContent = title;
    find('pause-title').textContent = title;
    find('pause-about').textContent = this.current.about;
  }

  #takeScenes(scenes) {
    const isThere = !(scenes instanceof Error);
    this.scenes = isThere ? scenes : [];
    this.menu = new SceneMenu(find('scenes'), this.scenes, {
      missing: isThere ? null : asTrouble(scenes),
      addressOf: (file) => this.#addressOf(file),
      onChoose: (file) => {
        history.pushState(null, '', this.#addressOf(file));
        this.#openNewAddress();
      },
    });
  }

  #addressOf(file) {
    const wanted = new URLSearchParams({ scene: file.replace(/\.json$/, '') });
    const engine = parameters().get('engine');
    if (engine !== null) wanted.set('engine', engine);
    return `?${wanted}`;
  }

  async openFiles(entries) {
    if (this.engine === null) {
      entries.catch(() => {}); // told when it is opened
      this.#dropped = entries;
      return;
    }
    find('scenes').close();
    try {
      const found = await this.#unlessOvertaken(entries);
      if (found !== null)
        await this.open({ source: sceneAmong(found), reference: null, about: '', view: null });
    } catch (error) {
      this.#fail(asTrouble(error), { again: null });
    }
  }

  // Files that came before the engine, instead of the address's scene.
  #openDropped() {
    this.given.take(this.engine, parameters());
    const entries = this.#dropped;
    this.#dropped = null;
    return this.openFiles(entries);
  }

  // ---- Playing

  play() {
    this.#setState('playing');
    canvas.focus({ preventScroll: true });
    this.engine.paused = false;
  }

  #prepareEngine() {
    for (const name of this.settings.names) this.applySetting(name);
    this.engine.resize(this.stage.width, this.stage.height);
    this.engine.paused = true;
    showKeys(find('key-tables'), find('key-table'), [...this.engine.keys, kShareKey]);
  }

  // What the engine tells.
  #hear(event, value) {
    switch (event) {
      case 'ready':
        this.ready = true;
        document.body.setAttribute('data-behind', '');
        this.#setState('paused');
        break;
      case 'pause':
        if (value) document.exitPointerLock?.();
        if (this.ready && this.state !== 'loading' && this.state !== 'trouble')
          this.#setState(value ? 'paused' : 'playing');
        break;
      case 'fly':
        this.thumbs.flying = value;
        break;
      case 'cursor':
        document.body.classList.toggle('steering', value);
        this.#showMode('cursor', value);
        break;
      case 'recording':
      case 'replay':
        this.#showMode(event, value);
        break;
      case 'record':
        this.#record();
        break;
      case 'help':
        this.openDialog('keys');
        break;
      case 'rate':
        this.settings.set('rate', !this.settings.value('rate'));
        break;
      case 'fullscreen':
        this.toggleFullScreen();
        break;
      case 'hits':
        console.info('slice %d', value.column, value);
        break;
      case 'frames':
        find('rate').textContent =
          `${Math.round(value.framesPerSecond)} fps · ${value.drawMilliseconds.toFixed(1)} ms`;
        break;
    }
  }

  // One line for what goes on, the weightiest first.
  #showMode(mode, isOn) {
    if (isOn) this.#modes.add(mode);
    else this.#modes.delete(mode);
    const shown = Object.keys(kModes).find((known) => this.#modes.has(known));
    find('mode').hidden = shown === undefined;
    find('mode').dataset.mode = shown ?? '';
    find('mode').textContent = kModes[shown] ?? '';
  }

  get state() {
    return document.body.dataset.state;
  }

  #setState(state) {
    if (state === 'playing') this.#played = true;
    else if (this.state === 'playing') this.thumbs.release();
    find('play').textContent = this.#played ? 'Continue' : 'Play';
    document.body.dataset.state = state;
  }

  applySetting(name) {
    const value = this.settings.value(name);
    if (name === 'size') this.stage.setSize(value);
    else if (name === 'rate') find('rate').hidden = !value;
    else if (this.engine === null) return;
    else if (name === 'mouse' || name === 'invert') {
      this.engine.setMouse({
        degreesPerPixel: kUsualDegreesPerPixel * this.settings.value('mouse'),
        invert: this.settings.value('invert'),
      });
    } else this.engine.setOption(name, value);
  }

  // What keys have changed since, the dialog shows as it is.
  #takeOptions() {
    if (this.engine === null) return;
    this.settings.set('lightPreset', this.engine.option('lightPreset'));
    this.settings.set('mirrors', Number(this.engine.option('mirrors')));
  }

  // ---- What is to be seen

  #showProgress(step, share, bytes) {
    find('loading-bar').value = Math.max(0, Math.min(1, share));
    find('loading-step').textContent = step;
    find('loading-bytes').textContent = bytes > 0 ? `· ${Math.ceil(bytes / 1024)} KB` : '';
  }

  #fail(trouble, { again }) {
    this.#setState('trouble');
    if (this.engine !== null) this.engine.paused = true;
    this.trouble.show(trouble, {
      again,
      scenes: this.scenes.length > 0 ? () => this.openDialog('scenes') : null,
      back: this.ready ? () => this.#backToPicture() : null,
    });
  }

  #backToPicture() {
    this.trouble.hide();
    this.#setState('paused');
  }

  openDialog(name) {
    if (document.querySelector('dialog[open]') !== null) return;
    document.exitPointerLock?.();
    if (name === 'settings') this.#takeOptions();
    if (name === 'scenes') this.menu?.open(this.engine, this.current?.reference);
    else if (name === 'share') this.#openShare();
    else find(name).showModal();
  }

  #openShare() {
    if (!this.ready) return;
    const { source, reference } = this.current;
    this.share.open({
      engine: this.engine,
      reference,
      name: source.name.replace(/\.json$/i, ''),
      canvas,
    });
  }

  toggleFullScreen() {
    if (document.fullscreenElement !== null) document.exitFullscreen();
    else document.documentElement.requestFullscreen?.().catch(() => {});
  }

  // ---- Listening

  #listen() {
    canvas.addEventListener('focus', () => this.#canvasFocused(true));
    canvas.addEventListener('blur', () => this.#canvasFocused(false));
    // A finger may scroll what the page stands in; only its tap plays.
    for (const type of ['pointerdown', 'click']) {
      canvas.addEventListener(type, (event) => {
        if (type === 'pointerdown' && event.pointerType === 'touch') return;
        if (this.engine !== null && this.state === 'paused') this.play();
      });
    }
    document.addEventListener('keydown', (event) => this.#keyDown(event));
    window.addEventListener('popstate', () => this.engine !== null && this.#openNewAddress());

    find('play').addEventListener('click', () => this.play());
    for (const name of ['scenes', 'keys', 'settings', 'share'])
      find(`open-${name}`).addEventListener('click', () => this.openDialog(name));
    for (const button of document.querySelectorAll('[data-close]'))
      button.addEventListener('click', () => button.closest('dialog').close());
    for (const dialog of document.querySelectorAll('dialog')) {
      // A press on what is behind the dialog closes it.
      dialog.addEventListener('pointerdown', (event) => {
        if (event.target === dialog && !contains(dialog.getBoundingClientRect(), event))
          dialog.close();
      });
    }
    find('keys').addEventListener('keydown', (event) => {
      if (event.code === 'KeyH') find('keys').close();
    });
    find('standard-settings').addEventListener('click', () => this.settings.backToStandard());
    this.thumbs = new Thumbs(find('touch'), {
      hold: (held) => this.engine?.setThumbs(held),
      drag: (right, down) => this.engine?.drag(right, down),
      fly: () => {
        this.engine.flying = !this.engine.state.flying;
      },
    });
    new Gamepads({
      change: (pad) => this.engine?.setGamepad(pad),
      // The first press begins the game, as a click would.
      press: () => {
        const canPlay =
          this.ready &&
          (this.state === 'paused' || this.state === 'playing') &&
          document.querySelector('dialog[open]') === null;
        if (canPlay && document.activeElement !== canvas) this.play();
      },
    });
    this.#listenForFullScreen();
    find('choose-files').addEventListener('click', () => find('files').click());
    listenForFiles({ input: find('files'), onEntries: (entries) => this.openFiles(entries) });
    guardLeaving(canvas);
    this.#listenForFailures();
    if (isLive()) this.#listenForSaves();
  }

  // Keys belong to the canvas: while it has none, play stands still.
  #canvasFocused(focused) {
    if (this.engine !== null && this.ready && (this.state === 'playing' || this.state === 'paused'))
      this.engine.paused = !focused;
  }

  // The canvas has keys of its own; these are for when nothing has the focus.
  #keyDown(event) {
    if (
      event.ctrlKey ||
      event.altKey ||
      event.metaKey ||
      document.querySelector('dialog[open]') !== null
    )
      return;
    const isNowhere = event.target === document.body;
    if (
      event.key === 'Enter' &&
      (isNowhere || event.target === canvas) &&
      this.state === 'paused'
    ) {
      event.preventDefault();
      this.play();
    } else if (isNowhere && event.code === 'KeyH') {
      this.openDialog('keys');
    } else if ((isNowhere || event.target === canvas) && event.code === kShareKey.code) {
      this.openDialog('share');
    } else if (isNowhere && event.code === 'KeyF') {
      this.toggleFullScreen();
    }
  }

  #listenForFullScreen() {
    const button = find('full-screen');
    button.hidden = !document.fullscreenEnabled;
    button.addEventListener('click', () => this.toggleFullScreen());
    document.addEventListener('fullscreenchange', () => {
      button.textContent =
        document.fullscreenElement !== null ? 'Leave full screen' : 'Full screen';
    });
  }

  #listenForFailures() {
    // The engine has failed between two calls of ours, or before its first picture.
    window.addEventListener('error', ({ error }) => {
      if (error instanceof WebAssembly.RuntimeError || (this.engine?.hasBegun && !this.ready))
        this.#fail(asTrouble(error), { again: () => location.reload() });
    });
  }

  // tools/play says when the scene of the address was saved.
  #listenForSaves() {
    const saves = new EventSource(new URL('-/events', document.baseURI));
    saves.addEventListener('scene', () => {
      const reference = parameters().get('scene');
      if (this.engine !== null && this.#asked?.reference === reference)
        this.open(this.#inAddress(reference), { keepEye: this.ready });
    });
  }
}

function contains(box, { clientX, clientY }) {
  return clientX >= box.left && clientX <= box.right && clientY >= box.top && clientY <= box.bottom;
}

function faultsTrouble(name, faults) {
  const count = faults.length === 1 ? 'One fault' : `${faults.length} faults`;
  const next = isLive()
    ? 'It opens by itself as soon as the file is saved without them.'
    : 'It cannot be opened before they are mended.';
  return new Trouble(`${count} in ${name}`, next, faults);
}

if (document.body.dataset.state !== 'impossible') {
  const page = new Page();
  // For the browser's console, and for tests.
  window.slicecast = page;
  page.start();
}

// Shows the element's state around the picture: caption, progress, errors, and modes such as
// recording. `body[data-state]` is loading, paused, playing (somebody steers) or trouble.
//
//     const status = new PageStatus(caster, address, dialogs);
//     status.scenes = list;
//     status.fail(error, again);        an error of the page itself; again() may be null
//     status.isQuiet = true;            the next load shows no progress

import { asTrouble } from '../engine/trouble.js';
import { nearOf } from './address-problems.js';
import { nameFrom, quoted, titleFrom } from './scene-origin.js';
import { TroubleSheet } from './trouble-sheet.js';

const kEngineShare = 0.5; // of the loading bar, for the first scene

const kFixAndSave = 'Fix these faults and save the file: the scene then opens by itself.';

const kAboutLinked = 'Somebody has built this world in the editor. It came with the link.';

const kModes = {
  recording: 'Recording; F9 saves it',
  replay: 'A recorded tour; move to take over',
  cursor: 'The mouse position steers; Escape ends it',
};

const find = (id) => document.getElementById(id);

export class PageStatus {
  isQuiet = false;
  #scenes = [];
  #caster;
  #address;
  #dialogs;
  #trouble = new TroubleSheet(find('trouble'));
  #modes = new Set();
  #attributes = []; // those of the last scene that loaded
  #source = null; // the visitor's own scene, if that was one
  #played = false;

  constructor(caster, address, dialogs) {
    this.#caster = caster;
    this.#address = address;
    this.#dialogs = dialogs;
    const on = (name, act) => caster.addEventListener(name, ({ detail }) => act(detail));
    on('progress', ({ share, bytes }) => this.#progress(share, bytes));
    on('ready', () => this.#ready());
    on('statechange', () => this.#show());
    on('enterchange', () => this.#show());
    on('error', (detail) => this.#fail(detail));
    on('modechange', ({ mode, on: isOn }) => this.#mode(mode, isOn));
    on('pace', ({ framesPerSecond, drawMilliseconds, width, height }) => {
      find('rate').textContent =
        `${Math.round(framesPerSecond)} fps · ${drawMilliseconds.toFixed(1)} ms · ${width} × ${height}`;
    });
  }

  get state() {
    return document.body.dataset.state;
  }

  // The list may arrive after the scene or its error.
  get scenes() {
    return this.#scenes;
  }

  set scenes(scenes) {
    this.#scenes = scenes;
    this.#tellAbout();
    this.#trouble.near(this.#near);
    find('trouble-scenes').hidden = scenes.length === 0;
  }

  // The scene that the address probably means.
  get #near() {
    return ['fetch', 'mime', 'tour'].includes(this.#caster.error?.code)
      ? nearOf(this.#address.parameters, this.#scenes)
      : null;
  }

  // Somebody has built this world and sent it.
  get #isLinked() {
    return this.#caster.source?.link !== undefined;
  }

  #tellAbout() {
    const { reference } = this.#address;
    const known = this.#scenes.find(({ file }) => file === reference);
    find('pause-about').textContent = this.#isLinked ? kAboutLinked : (known?.about ?? '');
  }

  // Shows an error of the page itself.
  fail(error, again = null) {
    const { title, message } = asTrouble(error);
    this.#fail({ title, message, faults: [] }, again);
  }

  #show() {
    const { state, entered } = this.#caster;
    if (state === 'error' || (state === 'loading' && this.isQuiet)) return; // #fail shows errors
    this.#trouble.hide();
    const shown = { idle: 'loading', playing: entered ? 'playing' : 'paused' }[state] ?? state;
    if (shown === 'playing') this.#played = true;
    find('play').textContent = this.#played ? 'Continue' : 'Play';
    document.body.dataset.state = shown;
  }

  #ready() {
    this.isQuiet = false;
    const { address, world } = this.#caster;
    const isLinked = this.#isLinked;
    const title = isLinked
      ? `From a link: ${quoted(world.title)}`
      : titleFrom(address, world.title);
    this.#caster.label = isLinked ? title : nameFrom(address, world.title);
    document.title = `${title} · Slicecast`;
    find('bar-title').textContent = title;
    find('pause-title').textContent = isLinked ? quoted(world.title) : title;
    find('edit-copy').hidden = !isLinked;
    this.#tellAbout();
    document.body.dataset.behind = '';
    this.#attributes = ['scene', 'tour', 'view'].map((name) => [
      name,
      this.#caster.getAttribute(name),
    ]);
    this.#source = this.#caster.source;
    this.#show();
  }

  #progress(share, bytes) {
    const isEngine = share < kEngineShare && this.#caster.world === null;
    const { reference } = this.#address;
    find('loading-bar').value = Math.max(0, Math.min(1, share));
    find('loading-step').textContent = isEngine
      ? 'Fetching the engine'
      : `Opening ${reference || 'the scene'}`;
    find('loading-bytes').textContent = bytes > 0 ? `· ${Math.ceil(bytes / 1024)} KB` : '';
  }

  #fail({ code, title, message, faults }, again = () => this.#caster.reload()) {
    this.isQuiet = false;
    const isLive = this.#address.isLive && code === 'scene';
    document.body.dataset.state = 'trouble';
    const text = isLive ? kFixAndSave : message;
    this.#trouble.show(
      { title, message: text, faults },
      {
        again,
        scenes: () => this.#dialogs.open('scenes'),
        back: this.#caster.world === null ? null : () => this.#back(),
      },
    );
    this.#trouble.near(this.#near);
    find('trouble-scenes').hidden = this.#scenes.length === 0;
  }

  // Returns to the previous scene, which is still loaded.
  #back() {
    this.#caster.source = this.#source;
    for (const [name, value] of this.#attributes) {
      this.#caster.removeAttribute(name);
      if (value !== null) this.#caster.setAttribute(name, value);
    }
    if (this.#caster.state !== 'error') this.#show(); // an error of the page, not of the scene
    this.#caster.focus({ preventScroll: true });
  }

  // One line shows the current mode; of several, the first of kModes.
  #mode(mode, isOn) {
    if (isOn) this.#modes.add(mode);
    else this.#modes.delete(mode);
    document.body.classList.toggle('steering', this.#modes.has('cursor'));
    const shown = Object.keys(kModes).find((known) => this.#modes.has(known));
    find('mode').hidden = shown === undefined;
    find('mode').dataset.mode = shown ?? '';
    find('mode').textContent = kModes[shown] ?? '';
  }
}

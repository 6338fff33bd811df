// What the page shows of the element: its state, the caption, progress, what is wrong, and what
// goes on. `body[data-state]` is loading, paused, playing (somebody steers) or trouble.
//
//     const face = new Face(caster, address, dialogs);
//     face.scenes = list;
//     face.fail(error, again);        of the page's own; again() is another try, if there is one
//     face.isQuiet = true;     the next load shows nothing of itself

import { asTrouble } from '../engine/trouble.js';
import { nearOf } from './slips.js';
import { TroubleSheet } from './trouble-sheet.js';
import { nameFrom, titleFrom } from './whose.js';

const kEngineShare = 0.5; // of the loading bar, until there was a picture

const kMended = 'It opens by itself as soon as the file is saved without them.';

const kModes = {
  recording: 'Recording; F9 saves it',
  replay: 'A recorded tour; move to take over',
  cursor: "The mouse's place steers; Escape ends it",
};

const find = (id) => document.getElementById(id);

export class Face {
  isQuiet = false;
  #scenes = [];
  #caster;
  #address;
  #dialogs;
  #trouble = new TroubleSheet(find('trouble'));
  #modes = new Set();
  #attributes = {}; // that showed the last scene without trouble
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

  // The list may come after the scene, or after what is wrong with it.
  get scenes() {
    return this.#scenes;
  }

  set scenes(scenes) {
    this.#scenes = scenes;
    this.#tellAbout();
    this.#trouble.near(this.#near);
    find('trouble-scenes').hidden = scenes.length === 0;
  }

  // What the address probably meant.
  get #near() {
    return ['fetch', 'mime', 'tour'].includes(this.#caster.error?.code)
      ? nearOf(this.#address.parameters, this.#scenes)
      : null;
  }

  #tellAbout() {
    const { reference } = this.#address;
    const known = this.#scenes.find(({ file }) => file === reference);
    find('pause-about').textContent = known?.about ?? '';
  }

  // What the page itself could not do.
  fail(error, again = null) {
    const { title, message } = asTrouble(error);
    this.#fail({ title, message, faults: [] }, again);
  }

  #show() {
    const { state, entered } = this.#caster;
    if (state === 'error' || (state === 'loading' && this.isQuiet)) return; // the event tells it
    this.#trouble.hide();
    const shown = { idle: 'loading', playing: entered ? 'playing' : 'paused' }[state] ?? state;
    if (shown === 'playing') this.#played = true;
    find('play').textContent = this.#played ? 'Continue' : 'Play';
    document.body.dataset.state = shown;
  }

  #ready() {
    this.isQuiet = false;
    const { address, world } = this.#caster;
    const title = titleFrom(address, world.title);
    this.#caster.label = nameFrom(address, world.title);
    document.title = `${title} · Slicecast`;
    find('bar-title').textContent = title;
    find('pause-title').textContent = title;
    this.#tellAbout();
    document.body.dataset.behind = '';
    this.#attributes = ['scene', 'tour', 'view'].map((name) => [
      name,
      this.#caster.getAttribute(name),
    ]);
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
    const text = isLive ? kMended : message;
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

  // What was shown before is still there.
  #back() {
    for (const [name, value] of this.#attributes) {
      this.#caster.removeAttribute(name);
      if (value !== null) this.#caster.setAttribute(name, value);
    }
    if (this.#caster.state !== 'error') this.#show();
  }

  // One line for what goes on, the weightiest first.
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

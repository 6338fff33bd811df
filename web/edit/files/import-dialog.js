// The dialog between a map from elsewhere and its world: the table of what becomes of it
// (import-rows.js), a picture that follows each choice, and the list of what cannot be taken.
// Takes a proposal and changes it; gives the scene. Keeps nothing.
//
//     const made = await importDialog(dialog, opened, { shipped, readPicture });
//     // {scene, pictures}, or null if the dialog was closed
//
// `opened` is {name, proposal, reread} of open-file.js. `readPicture(pictures, file)` gives
// bytes, also of shipped pictures.

import { keepChoices, makeScene, summaryOf } from '../import/index.js';
import { element } from './controls.js';
import { ImportRows } from './import-rows.js';

const kDelay = 150; // milliseconds after a choice
const kFocal = 0.75; // of the preview, in widths of its picture

export async function importDialog(dialog, opened, options) {
  const open = new ImportDialog(dialog, opened, options);
  try {
    return await open.made();
  } finally {
    open.stop();
  }
}

class ImportDialog {
  #dialog;
  #opened;
  #readPicture;
  #proposal;
  #table;
  #preview;
  #made = null; // {scene, pictures, notTaken}
  #timer = 0;
  #version = 0;
  #isAbove = true;
  #life = new AbortController();

  constructor(dialog, opened, { shipped, readPicture }) {
    this.#dialog = dialog;
    this.#opened = opened;
    this.#readPicture = readPicture;
    this.#table = new ImportRows(this.#part('choices'), shipped, () => this.#soon());
    this.#preview = element('ray-caster');
    for (const [name, value] of Object.entries({
      interaction: 'none',
      loading: 'eager',
      label: 'The world that the map becomes',
    }))
      this.#preview.setAttribute(name, value);
    this.#preview.addEventListener('ready', () => this.#look());
    this.#part('preview').replaceChildren(this.#preview);
  }

  #part(name) {
    return this.#dialog.querySelector(`#import-${name}`);
  }

  // The scene, when "Open" is pressed; null if the dialog is closed before.
  made() {
    const on = (name, type, act) =>
      this.#part(name).addEventListener(type, act, { signal: this.#life.signal });
    const from = (isAbove) => {
      this.#isAbove = isAbove;
      this.#look();
    };
    on('above', 'click', () => from(true));
    on('start', 'click', () => from(false));
    on('map', 'change', () => from(true));
    on('add', 'click', () => this.#part('files').click());
    on('files', 'change', ({ target }) => this.#add([...target.files]));
    const { signal } = this.#life;
    const drop = ({ dataTransfer }) => this.#add([...dataTransfer.files]);
    this.#dialog.addEventListener('drop', drop, { signal });
    this.#part('title').textContent = `Open ${this.#opened.name}`;
    this.#show(this.#opened.proposal);
    this.#dialog.showModal();
    this.#part('choices').parentElement.scrollTop = 0;
    return new Promise((resolve) => {
      on('open', 'click', () => resolve(this.#made));
      this.#dialog.addEventListener('close', () => resolve(null), { signal });
    });
  }

  stop() {
    clearTimeout(this.#timer);
    this.#version += 1;
    this.#life.abort();
    this.#preview.remove();
    this.#dialog.close();
  }

  #show(proposal) {
    this.#proposal = proposal;
    this.#part('found').textContent = summaryOf(proposal);
    this.#part('add').hidden = proposal.pictures.every(({ bytes }) => bytes !== null);
    const { maps } = proposal;
    this.#part('map').replaceChildren(...maps.map(({ name }, index) => new Option(name, index)));
    this.#part('map').hidden = maps.length < 2;
    this.#table.show(proposal);
    this.#make();
  }

  async #add(files) {
    if (files.length === 0) return;
    try {
      const proposal = await this.#opened.reread(files);
      keepChoices(this.#proposal, proposal);
      this.#show(proposal);
    } catch (error) {
      this.#tell(error.message);
    }
  }

  #soon() {
    this.#part('open').disabled = true;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#make(), kDelay);
  }

  // What cannot be made is told, and the last picture stays.
  async #make() {
    const version = (this.#version += 1);
    this.#part('open').disabled = true;
    const made = await makeScene(this.#proposal).catch((error) => error);
    if (version !== this.#version) return;
    if (made instanceof Error) {
      this.#tell(made.message);
      return;
    }
    this.#made = made;
    this.#part('open').disabled = false;
    this.#list(made.notTaken);
    const { scene, pictures } = made;
    const levels = Math.max(...scene.maps.map((map) => map.levels.length));
    const count = scene.maps.reduce((sum, { objects = [] }) => sum + objects.length, 0);
    const counted = (number, one) => `${number} ${one}${number === 1 ? '' : 's'}`;
    const kinds = Object.keys(scene.legend).length;
    this.#tell(
      `${counted(levels, 'level')}, ${counted(kinds, 'kind')} of blocks, ${counted(count, 'object')}.`,
    );
    const text = new TextEncoder().encode(JSON.stringify(scene));
    this.#preview.source = {
      name: 'preview.json',
      readText: () => text,
      readFile: (file) => this.#readPicture(pictures, file).catch(() => null),
      failures: new Map(),
    };
  }

  #tell(text) {
    this.#part('told').textContent = text;
  }

  #list(notTaken) {
    const list = this.#part('not-taken');
    list.hidden = notTaken.length === 0;
    list.querySelector('summary').textContent = `Not taken, or not as it was (${notTaken.length})`;
    list
      .querySelector('ul')
      .replaceChildren(
        ...notTaken.map(({ place, reason }) =>
          element('li', {}, element('b', {}, place), `: ${reason}`),
        ),
      );
  }

  // From the south, so that the whole map is in sight; or from where the player begins.
  #look() {
    for (const [name, isOn] of [
      ['above', this.#isAbove],
      ['start', !this.#isAbove],
    ])
      this.#part(name).setAttribute('aria-pressed', String(isOn));
    if (this.#preview.world === null || this.#made === null) return;
    const { maps, start } = this.#made.scene;
    if (!this.#isAbove) {
      this.#preview.look({ look: 0, map: maps[0].name, ...start, z: (start.z ?? 0) + 0.6 });
      return;
    }
    const index = Number(this.#part('map').value);
    const { width, depth } = this.#proposal.maps[index];
    const { name, levels } = maps[this.#proposal.base?.map ?? index];
    const { clientWidth, clientHeight } = this.#preview;
    const shape = clientWidth / Math.max(1, clientHeight);
    const back = 0.28 * shape * Math.max(width, depth) + 1.5;
    const z = 0.75 * (back + depth / 2) + levels.length;
    this.#preview.look({
      map: name,
      x: width / 2,
      y: depth + back,
      z,
      heading: 270,
      look: Math.max(-1.5, -(z / (back + depth / 2)) * kFocal * shape),
      flying: true,
    });
  }
}

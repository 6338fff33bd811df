// Photo mode: hides the page's controls, pauses the world, and shows a bar below the picture with
// field of view, time of day, and the size to save.
//
//     const photo = new Photo(bar, caster, { write, nameOf });
//     photo.begin();

import { saveFile } from '../element/save-file.js';
import { fitSliders } from './slider.js';

const kOverlays = [
  'minimap',
  'minimapRays',
  'playerPanel',
  'processPanel',
  'inspector',
  'grid',
  'slow',
];

export class Photo {
  #bar;
  #caster;
  #actions;
  #before = new Map(); // overlays to switch on again

  constructor(bar, caster, actions) {
    this.#bar = bar;
    this.#caster = caster;
    this.#actions = actions;
    const field = (name) => bar.querySelector(`[name="${name}"]`);
    field('fov').addEventListener('input', ({ target }) => {
      actions.write('fov', target.value);
      this.#show();
    });
    field('lightPreset').addEventListener('input', ({ target }) =>
      actions.write('lightPreset', target.value),
    );
    bar.querySelector('[data-photo="save"]').addEventListener('click', () => this.#save());
    bar.querySelector('[data-photo="done"]').addEventListener('click', () => this.end());
    bar.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      this.end();
    });
    // Playing ends photo mode.
    caster.addEventListener('enterchange', () => caster.entered && this.end());
  }

  get isOn() {
    return document.body.classList.contains('photo');
  }

  begin() {
    this.#caster.pause();
    fitSliders(this.#bar, this.#caster.optionList);
    for (const name of kOverlays) {
      if (this.#caster.get(name) !== 'on') continue;
      this.#before.set(name, 'on');
      this.#caster.set(name, 'off');
    }
    document.body.classList.add('photo');
    this.#show();
    this.#bar.querySelector('input').focus({ preventScroll: true });
  }

  end() {
    if (!this.isOn) return;
    document.body.classList.remove('photo');
    for (const [name, value] of this.#before) this.#caster.set(name, value);
    this.#before.clear();
    this.#status('');
    if (!this.#caster.entered) this.#caster.focus({ preventScroll: true });
  }

  #show() {
    const fov = this.#caster.get('fov');
    this.#bar.querySelector('[name="fov"]').value = fov;
    this.#bar.querySelector('output').textContent = `${Math.round(Number(fov))}°`;
    this.#bar.querySelector('[name="lightPreset"]').value = this.#caster.get('lightPreset');
  }

  async #save() {
    const size = this.#bar.querySelector('[name="size"]').value;
    const [width, height] = size === '' ? [] : size.split('x').map(Number);
    this.#status('Drawing …');
    try {
      const blob = await this.#caster.snapshot(size === '' ? {} : { width, height });
      saveFile(`${this.#actions.nameOf()}.png`, blob);
      this.#status('Saved');
    } catch (error) {
      this.#status(`Not saved: ${error.message}`);
    }
  }

  #status(text) {
    this.#bar.querySelector('[role="status"]').textContent = text;
  }
}

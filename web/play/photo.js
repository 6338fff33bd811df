// Photo mode: hides the page's controls, pauses the world, and shows a bar below the picture with
// field of view, time of day, and the size to save. Its end gives back what was before.
//
//     const photo = new Photo(bar, caster, { nameOf });
//     photo.begin();

import { saveFile } from '../element/save-file.js';
import { fullSize } from './size-now.js';
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

const kChosen = ['fov', 'lightPreset']; // in the bar, for the picture alone

export class Photo {
  #bar;
  #caster;
  #actions;
  #before = new Map(); // option -> its value, to be restored at the end
  #opener = null;

  constructor(bar, caster, actions) {
    this.#bar = bar;
    this.#caster = caster;
    this.#actions = actions;
    const field = (name) => bar.querySelector(`[name="${name}"]`);
    for (const name of kChosen)
      field(name).addEventListener('input', ({ target }) => {
        caster.set(name, target.value);
        this.#show();
      });
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
    for (const name of [...kOverlays, ...kChosen]) this.#before.set(name, this.#caster.get(name));
    for (const name of kOverlays) this.#caster.set(name, 'off');
    this.#opener = document.activeElement;
    document.body.classList.add('photo');
    this.#show();
    this.#bar.querySelector('input').focus({ preventScroll: true });
  }

  end() {
    if (!this.isOn) return;
    document.body.classList.remove('photo');
    for (const [name, value] of this.#before) this.#caster.set(name, value);
    this.#status('');
    if (!this.#caster.entered) this.#opener.focus({ preventScroll: true });
  }

  #show() {
    const fov = this.#caster.get('fov');
    this.#bar.querySelector('[name="fov"]').value = fov;
    this.#bar.querySelector('output').textContent = `${Math.round(Number(fov))}°`;
    this.#bar.querySelector('[name="lightPreset"]').value = this.#caster.get('lightPreset');
  }

  async #save() {
    const size = this.#bar.querySelector('[name="size"]').value;
    const [width, height] = size.split('x').map(Number);
    this.#status('Drawing …');
    try {
      const blob = await this.#caster.snapshot(
        size === '' ? fullSize(this.#caster) : { width, height },
      );
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

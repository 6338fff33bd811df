// What a <ray-caster> shows around its picture: names, the poster, progress, status line, errors.
//
//     const face = new Face(tree, internals);
//     face.attributes({poster, label}, hasPicture);
//     face.state('playing');

import { hideMessage, showMessage } from './message.js';

const kStatusMilliseconds = 4000;

export class Face {
  #tree;
  #internals;
  #label = '';
  #around = 'Move around';
  #title = '';
  #state = 'idle';
  #statusTimer = 0;

  constructor(tree, internals) {
    this.#tree = tree;
    this.#internals = internals;
    internals.role = 'group';
    tree.poster.addEventListener('error', () => this.hidePoster());
    this.name();
  }

  attributes({ poster, label, interaction }, hasPicture) {
    this.#label = label;
    this.#around = interaction === 'look' ? 'Look around' : 'Move around';
    this.name();
    const image = this.#tree.poster;
    image.hidden = poster === '' || hasPicture;
    if (poster !== '' && image.getAttribute('src') !== poster) image.src = poster;
  }

  hidePoster() {
    this.#tree.poster.hidden = true;
  }

  // The scene's title, used if there is no label.
  set title(title) {
    this.#title = title;
    this.name();
  }

  state(state) {
    this.#state = state;
    this.#tree.box.dataset.state = state;
    if (state !== 'loading') this.#tree.progress.hidden = true;
    this.name();
  }

  progress(share) {
    const { progress } = this.#tree;
    progress.hidden = share >= 1;
    progress.style.setProperty('--share', String(share));
    progress.setAttribute('aria-valuenow', String(Math.round(share * 100)));
  }

  // Shows a text for a moment, or with `stays` until the next one.
  status(text, { stays = false } = {}) {
    clearTimeout(this.#statusTimer);
    this.#tree.status.textContent = text;
    if (text !== '' && !stays)
      this.#statusTimer = setTimeout(() => this.status(''), kStatusMilliseconds);
  }

  trouble(detail, retry) {
    showMessage(this.#tree.message, detail, retry);
  }

  noTrouble() {
    hideMessage(this.#tree.message);
  }

  stop() {
    this.status('');
    this.noTrouble();
    this.#title = '';
    this.name();
  }

  // Says what the picture and the cover are called.
  name() {
    const { box, cover, canvas, hint } = this.#tree;
    const name = this.#label || this.#title || 'Raycaster';
    const act = this.#state === 'playing' ? this.#around : 'Play';
    this.#internals.ariaLabel = name;
    canvas?.setAttribute('aria-label', name);
    cover.setAttribute('aria-label', `${act}: ${name}`);
    box.dataset.label = name;
    hint.textContent = act;
  }
}

// The first ten seconds: where the page's address names nothing, the first scene of the list is
// seen from a slow flight behind the page's own title, until somebody plays or goes elsewhere. Who
// prefers reduced motion sees a still picture.
//
//     const opening = new Opening(caster);
//     opening.begin(scene.flight);       of the list; before the scene is there

import { Flight } from './flight.js';

export class Opening {
  #caster;
  #flight = null;
  #began = 0;
  #frame = 0;

  constructor(caster) {
    this.#caster = caster;
    caster.addEventListener('ready', () => this.#ready());
    caster.addEventListener('enterchange', () => caster.entered && this.#land());
    caster.addEventListener('error', () => this.end());
  }

  begin(flight) {
    if (flight === undefined) return;
    document.body.dataset.opening = '';
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) return;
    this.#flight = new Flight(flight);
    if (this.#caster.world !== null) this.#ready();
  }

  // Another scene was chosen, or something is wrong.
  end() {
    cancelAnimationFrame(this.#frame);
    this.#flight = null;
    delete document.body.dataset.opening;
  }

  #ready() {
    if (this.#flight === null || this.#began !== 0) return;
    this.#began = performance.now();
    this.#caster.flying = true;
    this.#caster.play();
    const fly = (time) => {
      if (this.#flight === null) return;
      this.#caster.look(this.#flight.at(Math.max(0, time - this.#began) / 1000));
      this.#frame = requestAnimationFrame(fly);
    };
    fly(this.#began);
  }

  // Who plays begins where the scene begins.
  #land() {
    const flew = this.#flight !== null && this.#began !== 0;
    this.end();
    if (!flew) return;
    this.#caster.flying = false;
    this.#caster.reset();
  }
}

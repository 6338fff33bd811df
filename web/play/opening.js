// The first ten seconds: where the page's address names nothing, the first scene of the list is
// seen from a slow flight behind the page's own title, until somebody plays or goes elsewhere. Who
// prefers reduced motion sees a still picture.
//
//     const opening = new Opening(caster);
//     opening.begin(scene.flight);       of the list; before the scene is there

import { Flight } from './flight.js';

const kLongestFrame = 100; // milliseconds of the flight, however late a picture comes

export class Opening {
  #caster;
  #flight = null;
  #hasBegun = false;
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
    if (this.#flight === null || this.#hasBegun) return;
    this.#hasBegun = true;
    this.#caster.flying = true;
    this.#caster.play();
    let seconds = 0;
    let last = performance.now();
    // Time stands while the picture does: for a benchmark, or behind something else.
    const fly = (time) => {
      if (this.#flight === null) return;
      if (this.#caster.state === 'playing') {
        seconds += Math.max(0, Math.min(kLongestFrame, time - last)) / 1000;
        this.#caster.look(this.#flight.at(seconds));
      }
      last = time;
      this.#frame = requestAnimationFrame(fly);
    };
    fly(last);
  }

  // Who plays begins where the scene begins.
  #land() {
    const flew = this.#flight !== null && this.#hasBegun;
    this.end();
    if (!flew) return;
    this.#caster.flying = false;
    this.#caster.reset();
  }
}

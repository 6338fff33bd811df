// The opening: a slow flight through the first scene of the list, behind the page's title. It runs
// if the page's address names nothing, until somebody plays or chooses a scene. Visitors who prefer
// reduced motion see a still picture.
//
//     const opening = new Opening(caster);
//     opening.begin(scene.flight);       the list's flight; before the scene has loaded

import { Flight } from './flight.js';

const kLongestFrame = 100; // milliseconds; a late picture advances the flight by no more

export class Opening {
  #caster;
  #flight = null;
  #hasBegun = false;
  #frame = 0;

  constructor(caster) {
    this.#caster = caster;
    caster.addEventListener('ready', () => this.#ready());
    // Whoever leaves the game pauses it: the flight's play() has ended.
    caster.addEventListener('enterchange', () => (caster.entered ? this.#land() : caster.pause()));
    caster.addEventListener('error', () => this.end());
  }

  begin(flight) {
    if (flight === undefined) return;
    document.body.dataset.opening = '';
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) return;
    this.#flight = new Flight(flight);
    if (this.#caster.world !== null) this.#ready();
  }

  // Another scene was chosen, or an error occurred.
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
    // The flight waits while the picture is paused: for a benchmark, or while it is covered.
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

  // The game begins at the scene's start.
  #land() {
    const flew = this.#flight !== null && this.#hasBegun;
    this.end();
    if (!flew) return;
    this.#caster.flying = false;
    this.#caster.reset();
  }
}

// The dialog of the benchmark.
//
//     const dialog = new BenchmarkDialog(element, caster, () => flight);
//     dialog.open();

import { asText, drawGraph, measure, rowsOf } from './benchmark.js';
import { Flight, roundAbout } from './flight.js';

const kPictures = 240;

export class BenchmarkDialog {
  #dialog;
  #caster;
  #flight;
  #figures = null;
  #isRunning = false;

  // `flight()` returns the scene's flight, or undefined: then the eye turns on the spot.
  constructor(dialog, caster, flight) {
    this.#dialog = dialog;
    this.#caster = caster;
    this.#flight = flight;
    this.#button('run').addEventListener('click', () => this.#run());
    this.#button('copy').addEventListener('click', () => this.#copy());
    dialog.addEventListener('close', () => {
      this.#isRunning = false;
    });
  }

  open() {
    this.#dialog.showModal();
    this.#button('run').focus();
  }

  #button(name) {
    return this.#dialog.querySelector(`[data-benchmark="${name}"]`);
  }

  async #run() {
    if (this.#isRunning) return;
    this.#isRunning = true;
    this.#button('run').disabled = this.#button('copy').disabled = true;
    const wasPlaying = !this.#caster.paused;
    this.#caster.pause();
    const canvas = this.#dialog.querySelector('canvas');
    const [width, height] = this.#dialog.querySelector('select').value.split('x').map(Number);
    const flight = this.#flight() ?? roundAbout(this.#caster.currentView);
    const way = new Flight(flight);
    const views = Array.from({ length: kPictures }, (_, index) =>
      way.at((index * flight.seconds) / kPictures),
    );
    this.#figures = await measure(this.#caster, {
      views,
      width,
      height,
      onProgress: (times) => {
        drawGraph(canvas, times, kPictures);
        this.#status(`${times.length} of ${kPictures} pictures`);
      },
      isWanted: () => this.#isRunning,
    });
    this.#isRunning = false;
    this.#button('run').disabled = false;
    if (wasPlaying) this.#caster.play();
    if (this.#figures === null) return;
    drawGraph(canvas, this.#figures.times, kPictures);
    this.#show();
  }

  #show() {
    this.#dialog.querySelector('tbody').replaceChildren(
      ...rowsOf(this.#figures).map(([name, value]) => {
        const row = document.createElement('tr');
        const head = Object.assign(document.createElement('th'), {
          scope: 'row',
          textContent: name,
        });
        const cell = Object.assign(document.createElement('td'), {
          className: 'figures',
          textContent: value,
        });
        row.append(head, cell);
        return row;
      }),
    );
    this.#button('copy').disabled = false;
    this.#status('');
  }

  async #copy() {
    try {
      await navigator.clipboard.writeText(asText(this.#figures, this.#caster.world.title));
      this.#status('Copied');
    } catch {
      this.#status('The browser does not let this page copy. Select the table instead.');
    }
  }

  #status(text) {
    this.#dialog.querySelector('[role="status"]').textContent = text;
  }
}

// Keeps a <ray-caster> at what the document says. Cells change at once; anything else renews the
// scene, where the eye stays. Takes a document and an element; gives the list of faults.
// Changes neither document nor history.
//
//     const sync = new Sync(scene, caster, ({ faults, warnings }) => ...);
//     sync.isSettled                     // the picture shows the present text
//     await sync.settled();

const kTypingMilliseconds = 250; // without a key before a typed text is played
const kCalmMilliseconds = 2000; // without a change before the mistakes are looked for

export class Sync {
  #scene;
  #caster;
  #report;
  #isBusy = false;
  #isStale = false;
  #timer = 0;
  #calm = 0;
  #warnings = []; // that loading has found; null beside faults
  #waiting = [];

  constructor(scene, caster, report) {
    this.#scene = scene;
    this.#caster = caster;
    this.#report = report;
    scene.listen((change) => this.#take(change));
  }

  get isSettled() {
    return !this.#isBusy && !this.#isStale;
  }

  settled() {
    return this.isSettled
      ? Promise.resolve()
      : new Promise((resolve) => this.#waiting.push(resolve));
  }

  // Plays the text anew, as after a walk that has moved blocks and taken finds.
  renew() {
    this.#isStale = true;
    this.#soon(0);
  }

  #take({ cells, isWhole }) {
    if (!isWhole && this.isSettled && this.#setCells(cells)) return this.#findMistakesSoon();
    this.#isStale = true;
    this.#soon(document.activeElement?.closest('.cm-editor') ? kTypingMilliseconds : 0);
  }

  // False where the engine does not take them: movers, gates, floors.
  #setCells(cells) {
    if (cells.some(({ layer }) => typeof layer !== 'number')) return false;
    try {
      for (const map of new Set(cells.map((cell) => cell.map)))
        this.#caster.setCells(
          this.#scene.value.maps[map].name,
          cells
            .filter((cell) => cell.map === map)
            .map(({ layer, x, y, sign }) => ({ level: layer, x, y, character: sign })),
        );
      return true;
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      return false;
    }
  }

  #soon(milliseconds) {
    clearTimeout(this.#calm);
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#renew(), milliseconds);
  }

  // Adds the mistakes that take long to find. What nothing uses is none: it waits in the palette.
  async #findMistakes() {
    const found = await this.#caster.findMistakes(this.#scene.text).catch(() => null);
    if (found === null || !this.isSettled) return;
    const warnings = [...this.#warnings, ...found.warnings];
    warnings.sort((a, b) => a.line - b.line || a.column - b.column);
    this.#report({ faults: [], warnings });
  }

  #findMistakesSoon() {
    clearTimeout(this.#calm);
    if (this.#warnings === null) return;
    this.#calm = setTimeout(() => this.#findMistakes(), kCalmMilliseconds);
  }

  async #renew() {
    if (this.#isBusy) return; // goes on afterwards
    this.#isBusy = true;
    try {
      while (this.#isStale) {
        this.#isStale = false;
        if (this.#scene.mistake !== null) break; // the text view tells it
        const report = await this.#caster.update(this.#scene.text);
        if (report === null) continue;
        this.#report(report);
        this.#warnings = report.faults.length === 0 ? report.warnings : null;
        this.#findMistakesSoon();
      }
    } finally {
      this.#isBusy = false;
    }
    for (const resolve of this.#waiting.splice(0)) resolve();
  }
}

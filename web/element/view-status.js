// Describes the view for screen readers, each time the player has come to rest. The text is
// announced while the focus is in the element, and can be read at any time.
//
//     const status = new ViewStatus(tree, () => engine);
//     status.moved();      // the view has changed: describes it 800 ms after the last change
//     status.stop();       // empties the text

import { bringMore } from './later-parts.js';

const kRestMilliseconds = 800;

export class ViewStatus {
  #timer = 0;
  #lastMove = 0;

  constructor(tree, engine) {
    this.tree = tree;
    this.engine = engine;
    tree.box.addEventListener('focusin', () => this.moved());
  }

  moved() {
    this.#lastMove = performance.now();
    if (this.#timer === 0) this.#wait(kRestMilliseconds);
  }

  stop() {
    clearTimeout(this.#timer);
    this.#timer = 0;
    this.tree.seen.textContent = '';
  }

  #wait(milliseconds) {
    this.#timer = setTimeout(() => {
      const left = this.#lastMove + kRestMilliseconds - performance.now();
      if (left > 0) return this.#wait(left);
      this.#timer = 0;
      return this.#tell().catch(() => {}); // no such script: no text
    }, milliseconds);
  }

  async #tell() {
    const { describeView } = await bringMore();
    const { seen, root, canvas } = this.tree;
    const engine = this.engine();
    // One that rests is not woken for this, unless somebody is there.
    if (engine === null || canvas === null || (engine.rests && root.activeElement === null)) return;
    if (!engine.isComplete) {
      this.#wait(kRestMilliseconds); // what looks around is in the program's later part
      return;
    }
    seen.setAttribute('aria-live', root.activeElement === null ? 'off' : 'polite');
    const text = describeView(engine, canvas.width, canvas.height);
    if (text !== seen.textContent) seen.textContent = text;
  }
}

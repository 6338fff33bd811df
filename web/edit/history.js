// What was done to a document, to be undone and done again, without end.
// Takes changes; gives them to the document as edits, and remembers how to go back.
// Knows no tool and no view.
//
//     const history = new History(scene);
//     history.do('Place', [{ map: 0, cells }], 'stroke 7');  // joins others with the same key
//     history.undo();                                        // the label, or null
//     history.redo();
//     history.listen(() => ...);

const kPause = 1000; // milliseconds without a key; what is typed then is undone by itself

export class History {
  #scene;
  #done = []; // {label, key, undoing: [edits, ...]}, the newest last
  #undone = [];
  #listeners = [];
  #isActing = false;
  #typedAt = 0; // milliseconds

  constructor(scene) {
    this.#scene = scene;
    // Edits that others apply, as the text view does, can be undone, too.
    scene.listen(({ undoing }) => {
      if (this.#isActing) return;
      const now = performance.now();
      if (now - this.#typedAt > kPause) this.close();
      this.#typedAt = now;
      this.#keep({ label: 'Type', key: 'type', undoing: [undoing] });
    });
  }

  listen(listener) {
    this.#listeners.push(listener);
  }

  get undoLabel() {
    return this.#done.at(-1)?.label ?? null;
  }

  get redoLabel() {
    return this.#undone.at(-1)?.label ?? null;
  }

  // How many things were done: the same number, the same text.
  get length() {
    return this.#done.length;
  }

  // Each change is made in the text that those before it have left.
  do(label, changes, key = null) {
    const undoing = [];
    this.#act(() => {
      for (const change of changes) {
        const edits = this.#scene.edits(change);
        if (edits.length > 0) undoing.push(this.#scene.apply(edits));
      }
    });
    if (undoing.length > 0) this.#keep({ label, key, undoing });
  }

  undo() {
    return this.#move(this.#done, this.#undone);
  }

  redo() {
    return this.#move(this.#undone, this.#done);
  }

  // Nothing joins what was done so far.
  close() {
    const last = this.#done.at(-1);
    if (last !== undefined) last.key = null;
  }

  #keep(entry) {
    const last = this.#done.at(-1);
    if (entry.key !== null && last?.key === entry.key) last.undoing.push(...entry.undoing);
    else this.#done.push(entry);
    this.#undone = [];
    this.#tell();
  }

  #move(from, to) {
    const entry = from.pop();
    if (entry === undefined) return null;
    const undoing = [];
    this.#act(() => {
      for (const edits of entry.undoing.toReversed()) undoing.push(this.#scene.apply(edits));
    });
    to.push({ label: entry.label, key: null, undoing });
    this.#tell();
    return entry.label;
  }

  #act(act) {
    this.#isActing = true;
    try {
      act();
    } finally {
      this.#isActing = false;
    }
  }

  #tell() {
    for (const listener of this.#listeners) listener();
  }
}

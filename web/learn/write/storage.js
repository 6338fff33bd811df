// Keeps the reader's programs, one for each chapter, in a Storage.
//
//     const shelf = new Shelf(localStorage);
//     shelf.open(4)              // { text, from, unfinished }: chapter 4's, or 3's; or null
//     shelf.save(4, text, true)  // before each run
//     shelf.finish(4)            // after it: the program came to its end
//     shelf.keep(4, text, why)   // before another text takes its place
//     shelf.earlier(4)           // [{ text, time, why }], the newest first
//
// A program that was begun and never finished is `unfinished`: shown, but not run unasked. If
// another tab has saved the chapter since this one looked, its text goes to the earlier ones: no
// tab loses work to another. A storage that is full or forbidden makes `fails` true; work goes on.

const kPrefix = 'slicecast.learn.program.';
const kEarlier = 12; // texts kept for a chapter

export class Shelf {
  fails = false;
  #storage;
  #seen = new Map(); // chapter -> the text that this tab read or wrote last

  constructor(storage) {
    this.#storage = storage;
  }

  open(chapter) {
    const own = this.#read(chapter);
    if (own !== null) {
      this.#seen.set(chapter, own.text);
      return { text: own.text, from: chapter, unfinished: own.running === true };
    }
    const last = this.#read(chapter - 1);
    return last && { text: last.text, from: chapter - 1, unfinished: last.running === true };
  }

  // The nearest chapter before this one that has a program; 0 if none has.
  before(chapter) {
    for (let number = chapter - 1; number > 0; number--)
      if (this.#read(number) !== null) return number;
    return 0;
  }

  // `isRunning`: it begins to run, and is unfinished until `finish`.
  save(chapter, text, isRunning) {
    this.#write(chapter, { text, time: Date.now(), running: isRunning }, text);
  }

  finish(chapter) {
    const slot = this.#read(chapter);
    // Another tab's program may still run.
    if (slot !== null && slot.text === this.#seen.get(chapter))
      this.#write(chapter, { ...slot, running: false }, slot.text);
  }

  keep(chapter, text, why) {
    const slot = this.#read(chapter);
    const earlier = withText(slot?.earlier, { text, time: Date.now(), why });
    this.#write(chapter, { ...(slot ?? { text, time: Date.now() }), earlier }, slot?.text ?? text);
  }

  earlier(chapter) {
    return this.#read(chapter)?.earlier ?? [];
  }

  #read(chapter) {
    try {
      const slot = JSON.parse(this.#storage.getItem(kPrefix + chapter));
      if (typeof slot?.text !== 'string') return null;
      const earlier = Array.isArray(slot.earlier) ? slot.earlier.filter(isVersion) : [];
      return { ...slot, earlier };
    } catch {
      return null;
    }
  }

  #write(chapter, slot, text) {
    const there = this.#read(chapter);
    let earlier = slot.earlier ?? there?.earlier ?? [];
    const seen = this.#seen.get(chapter);
    if (there !== null && there.text !== seen && there.text !== text)
      earlier = withText(earlier, { text: there.text, time: there.time, why: 'Another tab' });
    this.#seen.set(chapter, text);
    try {
      this.#storage.setItem(kPrefix + chapter, JSON.stringify({ ...slot, earlier }));
      this.fails = false;
    } catch {
      this.fails = true;
    }
  }
}

function isVersion(version) {
  return typeof version?.text === 'string' && typeof version.why === 'string';
}

function withText(versions = [], version) {
  return [version, ...versions.filter(({ text }) => text !== version.text)].slice(0, kEarlier);
}

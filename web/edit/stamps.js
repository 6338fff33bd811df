// Parts that are kept in the browser, for all worlds and tabs: stamps with names, and what was
// copied last. Takes parts (parts.js); gives them back. Knows no editor.
//
//     const stamps = new Stamps();
//     await stamps.read();                        // from the browser; then stamps.all
//     await stamps.save('gate house', part);      await stamps.remove('gate house');
//     await stamps.copy(part);                    await stamps.copied()       // or null
//     stamps.listen(() => ...);

import { get, set, update } from 'idb-keyval';

const kStamps = 'slicecast stamps';
const kCopied = 'slicecast copied part';

export class Stamps {
  #all = []; // {name, part}
  #copied = null; // also where the browser keeps nothing
  #listeners = [];

  get all() {
    return this.#all;
  }

  listen(listener) {
    this.#listeners.push(listener);
  }

  async read() {
    const all = await get(kStamps).catch(() => null);
    if (all === null) return;
    this.#all = all ?? [];
    this.#tell();
  }

  // Another one with that name is replaced. False if the browser keeps nothing.
  save(name, part) {
    return this.#change((all) => [...all.filter((one) => one.name !== name), { name, part }]);
  }

  remove(name) {
    return this.#change((all) => all.filter((one) => one.name !== name));
  }

  async copy(part) {
    this.#copied = part;
    await set(kCopied, part).catch(() => {});
  }

  async copied() {
    const kept = await get(kCopied).catch(() => null);
    return kept ?? this.#copied;
  }

  // What other tabs have saved meanwhile stays.
  async #change(change) {
    let isKept = true;
    await update(kStamps, (all = []) => (this.#all = change(all))).catch(() => {
      this.#all = change(this.#all);
      isKept = false;
    });
    this.#tell();
    return isKept;
  }

  #tell() {
    for (const listener of this.#listeners) listener();
  }
}

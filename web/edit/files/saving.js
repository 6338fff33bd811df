// Saves the world into its file, and knows whether the file has what the document has.
// Takes the document, its history and a file (file-homes.js); gives bytes to the file. Changes the
// document only when the visitor wants the file's text instead.
//
//     const saving = new Saving(scene, history, { home, form, tag, savedText, choose });
//     await saving.save();         // 'saved', 'taken', 'kept'; throws an Error in plain words
//     saving.isUnsaved             // false without a file
//     saving.listen(() => ...)     // that, or the file, may be another now
//     saving.base                  // what is kept with the text in the browser
//     await saving.settle()        // takes what others have saved, if nothing is unsaved: 'taken'
//     saving.isOvertaken           // others have saved, and there are changes here
//     await saving.decide()        // asks what to do then: 'taken', 'kept'
//     beginningOf(world, kept)     // {text, savedText, tag}: of the file, or as it was kept here
//
// `choose({name, mine, theirs, both})` asks what to do with a file that has changed outside; it
// gives 'mine', 'theirs', 'both' or null. `both` is the text with the changes of both, or null.

import { Changed } from './file-homes.js';
import { merged } from './line-differences.js';
import { bytesIn, kPlainForm, textIn } from './text-form.js';

const kDelay = 100; // milliseconds: comparing long texts is no part of a stroke

// `world` is that of open-world.js, `kept` what the browser has of it, or null.
export function beginningOf({ text, tag, home, isRead }, kept) {
  if (kept === null) return { text, savedText: text, tag };
  const { isSaved = false, tag: keptTag = null, savedText = null } = kept.base ?? {};
  if (!home) return { text: kept.text, savedText: null, tag: null };
  if (!isRead) return { text: kept.text, savedText: isSaved ? kept.text : savedText, tag: keptTag };
  if (isSaved || kept.text === text) return { text, savedText: text, tag };
  return { text: kept.text, savedText: keptTag === tag ? text : savedText, tag: keptTag };
}

export class Saving {
  #scene;
  #history;
  #choose;
  #home;
  #form;
  #tag;
  #saved; // the text that the file has, as far as it was read
  #isOvertaken = false;
  #isSaving = false; // or asking
  #timer = 0;
  #listeners = [];

  constructor(scene, history, { home = null, form, tag = null, savedText = null, choose }) {
    this.#scene = scene;
    this.#history = history;
    this.#choose = choose;
    this.#home = home;
    this.#form = form ?? kPlainForm;
    this.#tag = tag;
    this.#saved = savedText;
    scene.listen(() => {
      clearTimeout(this.#timer);
      this.#timer = setTimeout(() => this.#tell(), kDelay);
    });
  }

  listen(listener) {
    this.#listeners.push(listener);
  }

  get home() {
    return this.#home;
  }

  get isUnsaved() {
    return this.#home !== null && this.#scene.text !== this.#saved;
  }

  // As a file holds it.
  get bytes() {
    return bytesIn(this.#scene.text, this.#form);
  }

  get isOvertaken() {
    return this.#isOvertaken;
  }

  get base() {
    const isSaved = this.#home !== null && !this.isUnsaved; // a world without a file is only here
    const handle = this.#home?.handle;
    return {
      ...{ form: this.#form, tag: this.#tag, isSaved },
      ...(!isSaved && { savedText: this.#saved }),
      ...(handle && { handle }),
    };
  }

  save() {
    return this.#alone(() => this.#save());
  }

  decide() {
    return this.#alone(async () => {
      const theirs = await this.#home.read();
      return (await this.#ask(theirs)) === 'theirs' ? 'taken' : 'kept';
    });
  }

  async #alone(work) {
    if (this.#isSaving) return 'kept';
    this.#isSaving = true;
    try {
      return await work();
    } finally {
      this.#isSaving = false;
      this.#tell();
    }
  }

  // From now on the world has that file, if it can be written.
  async saveTo(home) {
    const before = { home: this.#home, tag: this.#tag };
    this.#home = home;
    this.#tag = null; // the visitor has agreed to replace what is there
    try {
      return await this.save();
    } catch (error) {
      this.#home = before.home;
      this.#tag = before.tag;
      this.#tell();
      throw error;
    }
  }

  async settle() {
    if (this.#isSaving) return 'kept';
    const theirs = (await this.#home?.ifReadable()) ?? null;
    if (this.#isSaving || theirs === null) return 'kept';
    const { text } = textIn(theirs.bytes);
    const isOther = theirs.tag !== this.#tag;
    this.#isOvertaken = isOther && this.isUnsaved && text !== this.#scene.text;
    const isTaken = isOther && !this.#isOvertaken;
    if (isTaken) this.#take(theirs, text);
    this.#tell();
    return isTaken ? 'taken' : 'kept';
  }

  async #save() {
    for (;;) {
      const { mistake, text } = this.#scene;
      if (mistake !== null)
        throw new Error('The text has a mistake: mend it, then save. It is kept in this browser.');
      try {
        this.#tag = await this.#home.write(bytesIn(text, this.#form), this.#tag);
        this.#saved = text;
        this.#isOvertaken = false;
        return 'saved';
      } catch (error) {
        if (!(error instanceof Changed)) throw error;
      }
      const theirs = await this.#home.read();
      if (textIn(theirs.bytes).text === text) {
        this.#take(theirs, text);
        return 'saved';
      }
      const choice = await this.#ask(theirs);
      if (choice === null) this.#isOvertaken = true;
      if (choice === null || choice === 'theirs') return choice === null ? 'kept' : 'taken';
    }
  }

  async #ask(theirs) {
    const { text } = textIn(theirs.bytes);
    const mine = this.#scene.text;
    const both = bothIn(this.#saved, mine, text);
    const choice = await this.#choose({ name: this.#home.name, mine, theirs: text, both });
    if (choice !== null) this.#take(theirs, text, { mine, theirs: text, both }[choice]);
    return choice;
  }

  // What is there may be replaced now.
  #take({ tag, bytes }, text, wanted = text) {
    this.#tag = tag;
    this.#saved = text;
    this.#isOvertaken = false;
    if (wanted === this.#scene.text) return;
    this.#form = textIn(bytes).form;
    this.#history.do(`Take ${this.#home.name}`, [{ text: wanted }]);
  }

  #tell() {
    clearTimeout(this.#timer);
    for (const listener of this.#listeners) listener();
  }
}

// Lines that fit each other may be no JSON together.
function bothIn(base, mine, theirs) {
  const both = base === null ? null : merged(base, mine, theirs);
  try {
    JSON.parse(both);
    return both;
  } catch {
    return null;
  }
}

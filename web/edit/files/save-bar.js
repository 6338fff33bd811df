// Saving as the visitor sees it: the button, the title with its dot, the question before leaving,
// and what went wrong. Takes a Saving; gives files to the browser.
//
//     const saveBar = new SaveBar({ scene, saving, world, ownPictures, tell });
//     await saveBar.save();          // into its file; without one, as a file to be named
//     await saveBar.saveAs();
//     saveBar.saveCopy(text)         // as a download; the words for it
//     saveBar.settle();              // with what others have saved
//     saveBar.leave(() => location.reload());      // without the question
//     saveBar.name                   // for files, without an ending

import { download } from './download.js';
import { pickedFile } from './file-homes.js';

const kType = 'application/json';
const kPicking = {
  types: [{ description: 'A scene of Slicecast', accept: { [kType]: ['.json'] } }],
};

export class SaveBar {
  #scene;
  #saving;
  #world;
  #ownPictures;
  #tell;
  #isLeaving = false;
  #button = document.getElementById('save');
  #outside = document.getElementById('outside');
  #watched = null;

  constructor({ scene, saving, world, ownPictures, tell }) {
    this.#scene = scene;
    this.#saving = saving;
    this.#world = world;
    this.#ownPictures = ownPictures;
    this.#tell = tell;
    this.#button.addEventListener('click', () => this.save());
    addEventListener('beforeunload', (event) => {
      if (saving.isUnsaved && !this.#isLeaving) event.preventDefault();
    });
    this.#outside
      .querySelector('button')
      .addEventListener('click', () => this.#try(() => saving.decide()));
    addEventListener('focus', () => this.settle());
    saving.listen(() => this.#show());
    this.#show();
  }

  get name() {
    return (this.#scene.value.title || this.#world.name).replace(/[^\w-]+/g, '-').toLowerCase();
  }

  async save() {
    const { home } = this.#saving;
    if (home === null) await this.saveAs();
    else await this.#try(() => this.#saving.save());
  }

  // Where pages may write files, a world without one has that one from then on.
  async saveAs() {
    const suggestedName = `${this.name}.json`;
    if (globalThis.showSaveFilePicker === undefined) {
      download(suggestedName, this.#saving.bytes, kType);
      this.#tell(`Saved as ${suggestedName}`);
      return;
    }
    const handle = await showSaveFilePicker({ ...kPicking, suggestedName }).catch(orNothing);
    if (!handle) return;
    const file = pickedFile(handle);
    if (this.#saving.home === null) await this.#try(() => this.#saving.saveTo(file));
    else
      await this.#try(async () => {
        await file.write(this.#saving.bytes, null);
        this.#tell(`Saved a copy as ${file.name}`);
      });
  }

  // Others may have saved the file. Not while the visitor is asked something else.
  async settle() {
    if (document.querySelector('dialog[open]') !== null) return;
    this.#tellTaken(await this.#saving.settle().catch(() => 'kept')); // a save will tell
  }

  saveCopy(text) {
    const name = `${this.name}-mine.json`;
    download(name, text, kType);
    return `Saved as ${name}`;
  }

  leave(go) {
    this.#isLeaving = true;
    go();
  }

  async #try(save) {
    try {
      const how = await save();
      const { name } = this.#saving.home;
      const pictures = [...this.#ownPictures.named.keys()];
      if (how === 'saved')
        this.#tell(
          pictures.length === 0
            ? `Saved ${name}`
            : `Saved ${name}. Put ${pictures.join(', ')} beside it: the zip has them.`,
        );
      this.#tellTaken(how);
    } catch (error) {
      this.#tell(error.message);
    }
  }

  #tellTaken(how) {
    if (how === 'taken') this.#tell(`This is ${this.#saving.home.name} as it was changed outside`);
  }

  #show() {
    const { home, isUnsaved, isOvertaken } = this.#saving;
    const title = this.#scene.value.title || 'A world without a name';
    document.title = `${isUnsaved ? '● ' : ''}${title} · Build a world`;
    this.#button.hidden = home === null;
    this.#outside.hidden = !isOvertaken;
    if (home === null) return;
    if (home !== this.#watched) home.watch(() => this.settle());
    this.#watched = home;
    this.#outside.querySelector('p').textContent =
      `Others have changed ${home.name}, and so have you.`;
    this.#button.title = `Save ${home.name} (Ctrl+S)`;
    this.#button.toggleAttribute('data-unsaved', isUnsaved);
  }
}

function orNothing(error) {
  if (error.name !== 'AbortError') throw error;
  return null;
}

// The share dialog: the view as a link, tag or frame to copy, and as a picture to save.
//
//     const share = new ShareDialog(dialog);
//     share.open(caster, address);        address.reference is null if the scene has no address

import { sceneAddress } from './scene-list.js';
import { seenOptions } from './seen-options.js';
import { fullSize } from './size-now.js';
import { frameFor, linkTo, sharedParameters, tagFor } from '../element/share-links.js';
import { saveFile } from '../element/save-file.js';

const kPreviewWidth = 480; // pixels

export class ShareDialog {
  #caster = null;
  #reference = null;

  constructor(dialog) {
    this.dialog = dialog;
    this.find = (name) => dialog.querySelector(`#share-${name}`);
    for (const button of dialog.querySelectorAll('[data-copy]'))
      button.addEventListener('click', () => this.#copy(button));
    this.find('from-view').addEventListener('input', () => this.#write());
    this.find('save').addEventListener('click', () => this.#save());
    this.find('preview').addEventListener('contextrestored', () => this.#preview().catch(() => {}));
  }

  open(caster, { reference }) {
    this.#caster = caster;
    this.#reference = reference;
    const { width, height } = fullSize(caster);
    const own = this.find('size').options[0];
    own.value = `${width}x${height}`;
    own.textContent = `Full size, ${width} × ${height}`;
    const link = caster.source?.link; // it holds the whole world
    this.find('addresses').hidden = reference === null && link === undefined;
    this.find('addresses').classList.toggle('link-only', link !== undefined);
    this.find('no-address').hidden = !this.find('addresses').hidden;
    if (reference !== null) this.#write();
    else if (link !== undefined) {
      this.find('link').value = new URL(`./${link}`, document.baseURI).href;
      this.#say(null, '');
    }
    this.#preview().catch(() => {}); // the dialog does without
    this.dialog.showModal();
  }

  #write() {
    const caster = this.#caster;
    const reference = this.#reference;
    const base = new URL('.', document.baseURI).href;
    const label = caster.world.title;
    const { currentView, flying } = caster;
    const view = this.find('from-view').checked ? { ...currentView, flying } : null;
    const shared = sharedParameters({ reference, view, options: seenOptions(caster.optionList) });
    this.find('link').value = linkTo(shared, base);
    this.find('tag').value = tagFor(shared, { base, scene: sceneAddress(reference).href, label });
    this.find('frame').value = frameFor(shared, { base, label });
    this.#say(null, '');
  }

  // Also after a restart of the browser's graphics process, which leaves canvases black.
  async #preview() {
    const preview = this.find('preview');
    const { width, height } = this.#caster.picture;
    preview.width = kPreviewWidth;
    preview.height = Math.max(1, Math.round((kPreviewWidth * height) / width));
    const blob = await this.#caster.snapshot({ width: preview.width, height: preview.height });
    preview.getContext('2d').drawImage(await createImageBitmap(blob), 0, 0);
  }

  // If the browser refuses the clipboard, selects the text, so that the visitor can copy it.
  async #copy(button) {
    const field = this.find(button.dataset.copy);
    try {
      await navigator.clipboard.writeText(field.value);
      this.#say(button, `Copied: the ${button.dataset.copy}`);
    } catch {
      field.focus();
      field.select();
      this.#say(
        null,
        'Your browser did not allow copying. The text is selected: copy it with Ctrl+C or ⌘C.',
      );
    }
  }

  // One button at a time says "Copied"; the status line repeats it for screen readers.
  #say(copied, text) {
    for (const button of this.dialog.querySelectorAll('[data-copy]')) {
      button.textContent = button === copied ? 'Copied' : 'Copy';
      button.classList.toggle('done', button === copied);
    }
    this.find('status').textContent = text;
  }

  async #save() {
    const [width, height] = this.find('size').value.split('x').map(Number);
    const name = (this.#reference ?? this.#caster.source.name).replace(/^.*\/|\.json$/gi, '');
    const blob = await this.#caster.snapshot({ width, height }).catch(() => null);
    if (blob === null) {
      this.#say(null, 'There is not enough memory for a picture of that size.');
      return;
    }
    saveFile(`${name}-${width}x${height}.png`, blob);
    this.#say(null, `Saved: ${name}-${width}x${height}.png`);
  }
}

// The share dialog: the view's link, tag and frame, each to be copied, and the view as a picture.
//
//     const share = new ShareDialog(dialog);
//     share.open({engine, reference, name, canvas});        the reference is null where the scene has no address

import { sceneAddress } from './scene-source.js';
import { frameFor, linkTo, sharedParameters, tagFor } from '../element/share-links.js';
import { saveFile } from '../element/save-file.js';

const kPreviewWidth = 480; // pixels

export class ShareDialog {
  #shown = null;

  constructor(dialog) {
    this.dialog = dialog;
    this.find = (name) => dialog.querySelector(`#share-${name}`);
    for (const button of dialog.querySelectorAll('[data-copy]'))
      button.addEventListener('click', () => this.#copy(button));
    this.find('from-view').addEventListener('input', () => this.#write());
    this.find('save').addEventListener('click', () => this.#save());
  }

  open(shown) {
    this.#shown = shown;
    const { canvas, reference } = shown;
    const own = this.find('size').options[0];
    own.value = `${canvas.width}x${canvas.height}`;
    own.textContent = `As shown, ${canvas.width} × ${canvas.height}`;
    this.find('addresses').hidden = reference === null;
    this.find('no-address').hidden = reference !== null;
    if (reference !== null) this.#write();
    this.#preview();
    this.dialog.showModal();
  }

  #write() {
    const { engine, reference } = this.#shown;
    const base = new URL('.', document.baseURI).href;
    const label = engine.world.title;
    const view = this.find('from-view').checked ? engine.view : null;
    const shared = sharedParameters({ reference, view, options: engine.options });
    this.find('link').value = linkTo(shared, base);
    this.find('tag').value = tagFor(shared, { base, scene: sceneAddress(reference).href, label });
    this.find('frame').value = frameFor(shared, { base, label });
    this.#say(null, '');
  }

  #preview() {
    const { engine, canvas } = this.#shown;
    const preview = this.find('preview');
    preview.width = kPreviewWidth;
    preview.height = Math.max(1, Math.round((kPreviewWidth * canvas.height) / canvas.width));
    preview.getContext('2d').putImageData(engine.drawOnce(preview.width, preview.height), 0, 0);
  }

  // Where a browser refuses the clipboard, the text is selected: then one key copies it.
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
        'Your browser keeps the clipboard to itself. The text is selected: copy it with Ctrl or ⌘ and C.',
      );
    }
  }

  // One button at a time says "Copied"; the status line says it too, for those who hear the page.
  #say(copied, text) {
    for (const button of this.dialog.querySelectorAll('[data-copy]')) {
      button.textContent = button === copied ? 'Copied' : 'Copy';
      button.classList.toggle('done', button === copied);
    }
    this.find('status').textContent = text;
  }

  async #save() {
    const { engine, name } = this.#shown;
    const [width, height] = this.find('size').value.split('x').map(Number);
    const picture = document.createElement('canvas');
    picture.width = width;
    picture.height = height;
    picture.getContext('2d').putImageData(engine.drawOnce(width, height), 0, 0);
    const blob = await new Promise((resolve) => picture.toBlob(resolve, 'image/png'));
    if (blob === null) {
      this.#say(null, 'There is not enough memory for a picture of that size.');
      return;
    }
    saveFile(`${name}-${width}x${height}.png`, blob);
    this.#say(null, `Saved: ${name}-${width}x${height}.png`);
  }
}

// The dialog that opens another world: a template, a shipped scene, or files, which may also be
// dropped anywhere on the page. Gives addresses to the browser: each world has one, so that going
// back works.

import { listScenes, posterAddress } from '../../play/scene-list.js';
import { tagOf } from './file-homes.js';
import { openFiles } from './open-file.js';
import { templates } from './templates.js';
import { keepOpened } from './world-store.js';

const kMostListed = 12; // of what could not be taken

// `beginAnew` opens the present world as it was; `takePictures(files)` returns true if it takes
// what was dropped; `leave(go)` goes to another page.
export function openDialog(dialog, button, { beginAnew, takePictures, leave }) {
  let isFilled = false;
  const told = dialog.querySelector('#open-told');
  const input = document.createElement('input');
  Object.assign(input, { type: 'file', multiple: true, hidden: true });
  dialog.append(input);
  dialog.querySelector('#anew').addEventListener('click', beginAnew);
  dialog.querySelector('#open-file').addEventListener('click', pick);
  input.addEventListener('change', () => take([...input.files]));
  addEventListener('dragover', (event) => event.preventDefault());
  addEventListener('drop', (event) => {
    event.preventDefault();
    const files = [...event.dataTransfer.files];
    if (files.length === 0 || document.querySelector('dialog[open]:not(#files)') !== null) return;
    if (!dialog.open && takePictures(files)) return;
    // Asked for at once: the list is emptied after this event.
    const handles = [...event.dataTransfer.items].map((item) => item.getAsFileSystemHandle?.());
    if (!dialog.open) dialog.showModal();
    take(files, Promise.all(handles));
  });

  // Where pages may write files, the file is remembered, to be saved to.
  async function pick() {
    if (globalThis.showOpenFilePicker === undefined) return input.click();
    try {
      const handles = await showOpenFilePicker({ multiple: true });
      take(await Promise.all(handles.map((handle) => handle.getFile())), handles);
    } catch (error) {
      if (error.name !== 'AbortError')
        told.replaceChildren(`This cannot be opened. ${error.message}`);
    }
  }

  async function take(files, handles = []) {
    told.replaceChildren('Opening …');
    try {
      const { name, text, pictures, notTaken, form, scene } = await openFiles(files);
      const base = { form, isSaved: false };
      const handle = (await handles)[files.indexOf(scene)];
      if (handle?.kind === 'file' && handle.createWritable !== undefined) {
        const tag = await tagOf(new Uint8Array(await scene.arrayBuffer()));
        Object.assign(base, { handle, tag, isSaved: true });
      }
      const query = await keepOpened(name, { text, pictures, base });
      const go = () => leave(() => location.assign(new URL(query, location.href)));
      if (notTaken.length === 0) go();
      else told.replaceChildren(...listOf(notTaken), opener(go));
    } catch (error) {
      told.replaceChildren(`This cannot be opened. ${error.message}`);
    }
  }

  button.addEventListener('click', async () => {
    dialog.showModal();
    if (isFilled) return;
    isFilled = true;
    dialog
      .querySelector('#templates')
      .append(...templates.map(({ name, title }) => card(title, `?template=${name}`, null)));
    const scenes = await listScenes().catch(() => []); // the templates are there
    dialog.querySelector('#remixes').append(
      ...scenes.map(({ file, title, poster }) => {
        const name = file.replace('.json', '');
        const picture = poster === undefined ? null : posterAddress(poster);
        return card(title, `?scene=${name}`, picture);
      }),
    );
  });
}

function card(title, query, picture) {
  const item = document.createElement('li');
  const button = document.createElement('button');
  button.type = 'button';
  if (picture !== null) {
    const image = document.createElement('img');
    Object.assign(image, { src: picture.href, alt: '', loading: 'lazy' });
    button.append(image);
  }
  button.append(title);
  button.addEventListener('click', () => location.assign(new URL(query, location.href)));
  item.append(button);
  return item;
}

function listOf(notTaken) {
  const title = document.createElement('p');
  title.textContent = `What could not be taken (${notTaken.length}):`;
  const list = document.createElement('ul');
  list.append(
    ...notTaken.slice(0, kMostListed).map(({ place, reason }) => {
      const item = document.createElement('li');
      item.textContent = `${place}: ${reason}`;
      return item;
    }),
  );
  return [title, list];
}

function opener(go) {
  const button = document.createElement('button');
  button.type = 'button';
  button.className = 'main';
  button.textContent = 'Open the rest';
  button.addEventListener('click', go);
  return button;
}

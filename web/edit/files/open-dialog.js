// The dialog that opens another world: a template, a shipped scene, or files, which may also be
// dropped anywhere on the page. Gives addresses to the browser: each world has one, so that going
// back works.

import { kHome } from '../../engine/home.js';
import { listScenes, posterAddress } from '../../play/scene-list.js';
import { printed } from '../json-text.js';
import { tagOf } from './file-homes.js';
import { openFiles, openText } from './open-file.js';
import { templates } from './templates.js';
import { keepOpened } from './world-store.js';

const kTemplates = new URL('edit/templates/', kHome); // pictures

// `beginAnew` opens the present world as it was; `takePictures(files)` returns true if it takes
// what was dropped; `leave(go)` goes to another page; `importing` is the dialog for maps from
// elsewhere, and the rest gives shipped pictures to it.
export function openDialog(dialog, button, parts) {
  const { beginAnew, takePictures, leave, importing, readShipped, readPicture } = parts;
  let isFilled = false;
  let missing = null; // {name, reread} of a map that could not be read without further files
  const told = dialog.querySelector('#open-told');
  const pasted = dialog.querySelector('#open-text');
  const input = document.createElement('input');
  Object.assign(input, { type: 'file', multiple: true, hidden: true });
  dialog.append(input);
  dialog.querySelector('#anew').addEventListener('click', beginAnew);
  dialog.querySelector('#open-file').addEventListener('click', pick);
  dialog
    .querySelector('#open-pasted')
    .addEventListener('click', () => take(() => openText(pasted.value)));
  input.addEventListener('change', () => {
    const files = [...input.files];
    input.value = ''; // the same file may be chosen again
    if (files.length > 0) take(() => opened(files));
  });
  addEventListener('dragover', (event) => event.preventDefault());
  addEventListener('drop', (event) => {
    event.preventDefault();
    const files = [...event.dataTransfer.files];
    if (files.length === 0 || document.querySelector('dialog[open]:not(#files)') !== null) return;
    if (!dialog.open && takePictures(files)) return;
    // Asked for at once: the list is emptied after this event.
    const handles = [...event.dataTransfer.items].map((item) => item.getAsFileSystemHandle?.());
    if (!dialog.open) show();
    take(() => opened(files), { files, handles: Promise.all(handles) });
  });

  function tell(text, ...more) {
    const line = document.createElement('p');
    line.textContent = text;
    told.replaceChildren(line, ...more);
    told.scrollIntoView({ block: 'nearest' });
  }

  // Where pages may write files, the file is remembered, to be saved to.
  async function pick() {
    if (globalThis.showOpenFilePicker === undefined) return input.click();
    try {
      const handles = await showOpenFilePicker({ multiple: true });
      const files = await Promise.all(handles.map((handle) => handle.getFile()));
      take(() => opened(files), { files, handles });
    } catch (error) {
      if (error.name !== 'AbortError') tell(`This cannot be opened. ${error.message}`);
    }
  }

  // Files that hold no map may be those that the last one wanted.
  async function opened(files) {
    const wanted = missing;
    missing = null;
    try {
      return await openFiles(files);
    } catch (error) {
      if (wanted === null || error.missing !== undefined) throw error;
      missing = wanted;
      return { ...wanted, proposal: await wanted.reread(files) };
    }
  }

  async function take(open, { files = [], handles = [] } = {}) {
    told.replaceChildren('Opening …');
    try {
      const world = await open();
      told.replaceChildren();
      const isMap = world.proposal !== undefined;
      const { text, pictures } = isMap ? await imported(world) : world;
      if (text === null) return;
      const base = { form: world.form, isSaved: false };
      const handle = (await handles)[files.indexOf(world.scene)];
      if (handle?.kind === 'file' && handle.createWritable !== undefined) {
        const tag = await tagOf(new Uint8Array(await world.scene.arrayBuffer()));
        Object.assign(base, { handle, tag, isSaved: true });
      }
      const query = await keepOpened(world.name, {
        text,
        pictures,
        base: isMap ? undefined : base,
      });
      leave(() => location.assign(new URL(query, location.href)));
    } catch (error) {
      missing = error.missing ?? missing;
      if (error.missing === undefined) tell(`This cannot be opened. ${error.message}`);
      else {
        const choose = document.createElement('button');
        Object.assign(choose, { type: 'button', textContent: 'Choose files', onclick: pick });
        tell(`${error.message}. Choose it now, or all files of the map at once.`, choose);
      }
    }
  }

  async function imported(world) {
    const { importDialog } = await import('../import.js');
    const shipped = await readShipped();
    const made = await importDialog(importing, world, { shipped, readPicture });
    if (made === null) return { text: null };
    return { text: `${printed(made.scene, '')}\n`, pictures: made.pictures };
  }

  button.addEventListener('click', show);

  async function show() {
    dialog.showModal();
    if (isFilled) return;
    isFilled = true;
    dialog
      .querySelector('#templates')
      .append(
        ...templates.map(({ name, title }) =>
          card(title, `?template=${name}`, new URL(`${name}.png`, kTemplates)),
        ),
      );
    const scenes = await listScenes().catch(() => []); // the templates are there
    dialog.querySelector('#remixes').append(
      ...scenes.map(({ file, title, poster }) => {
        const name = file.replace('.json', '');
        const picture = poster === undefined ? null : posterAddress(poster);
        return card(title, `?scene=${name}`, picture);
      }),
    );
  }
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

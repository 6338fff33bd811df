// The dialog that saves the world and writes a link to it.
// Takes the document and the world's own pictures; gives files to the browser.

import { strToU8, zipSync } from 'fflate';
import { linkOf } from './world-link.js';

export function shareDialog(dialog, button, { scene, own, world }) {
  const find = (id) => dialog.querySelector(`#${id}`);
  button.addEventListener('click', () => {
    const link =
      scene.mistake === null && own.size === 0 ? linkOf(scene.text, location.href) : null;
    find('share-link').value = link ?? '';
    find('share-link').disabled = link === null;
    dialog.querySelector('[data-copy]').disabled = link === null;
    find('share-about').textContent =
      link !== null
        ? 'The link holds the whole world. Whoever opens it can walk in it, and change a copy.'
        : own.size > 0
          ? 'A world with its own pictures has no link: save a zip.'
          : 'This world is too large for a link: save the scene, or a zip.';
    find('save-zip').hidden = own.size === 0;
    dialog.showModal();
  });
  dialog.querySelector('[data-copy]').addEventListener('click', async ({ target }) => {
    const field = find('share-link');
    field.select();
    try {
      await navigator.clipboard.writeText(field.value);
    } catch {
      document.execCommand('copy'); // without the permission
    }
    target.textContent = 'Copied';
    setTimeout(() => (target.textContent = 'Copy'), 2000);
  });
  const name = () => (scene.value.title ?? world.name).replace(/[^\w-]+/g, '-').toLowerCase();
  find('save-scene').addEventListener('click', () =>
    save(`${name()}.json`, new Blob([scene.text], { type: 'application/json' })),
  );
  find('save-zip').addEventListener('click', () => {
    const files = { [`${name()}.json`]: strToU8(scene.text) };
    for (const [file, bytes] of own) files[file] = bytes;
    save(`${name()}.zip`, new Blob([zipSync(files)], { type: 'application/zip' }));
  });
}

function save(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

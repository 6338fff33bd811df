// The dialog that shows the world as a link, a tag and a frame, names it, and saves it as files.
// Takes the document and the world's own pictures; gives files to the browser, and
// a new name to `rename`.

import { deflateSync, strToU8, zipSync } from 'fflate';
import { kHome } from '../../engine/home.js';
import { readPicture } from '../open-world.js';
import { download } from './download.js';
import { htmlFile } from './html-file.js';
import { frameFor, tagFor } from './share-texts.js';
import { kSureCharacters, linkOf } from './world-link.js';

const kPlayer = new URL('edit/player.bin', kHome);
const kShownCopied = 2000; // milliseconds

export function shareDialog(dialog, button, { scene, own, ownPictures, world, saveBar, rename }) {
  const find = (id) => dialog.querySelector(`#${id}`);
  const tell = (text) => (find('share-told').textContent = text);
  const name = () => saveBar.name;

  button.addEventListener('click', () => {
    tell('');
    show();
    dialog.showModal();
    dialog.querySelector('[data-copy=share-link]').focus();
  });
  find('share-name').addEventListener('change', ({ target }) => {
    rename(target.value);
    show();
  });

  function show() {
    const title = scene.value.title ?? '';
    showLink();
    find('share-name').value = title;
    find('share-tag').value = tagFor({ name: name(), title });
    find('share-frame').value = frameFor({ name: name(), title });
    const pictures = ownPictures.named.size === 0 ? '' : ' and its own pictures';
    find('tag-about').textContent =
      `Needs Slicecast’s folder on your site as slicecast, with ${name()}.json${pictures} in slicecast/scenes.`;
    find('frame-about').textContent =
      `Needs the same, but no script in your page. A frame may also show the one HTML file.`;
  }

  function showLink() {
    const obstacle =
      scene.mistake !== null
        ? 'The text has a fault. Mend it, and there is a link.'
        : ownPictures.named.size > 0
          ? 'A world with its own pictures has no link: send the HTML file instead, below.'
          : null;
    const link = obstacle === null ? linkOf(scene.text, new URL('./', location.href)) : null;
    const isLong = link !== null && link.length > kSureCharacters;
    find('share-link').value = link ?? '';
    find('share-link-field').hidden = link === null;
    find('share-about').className = link === null || isLong ? 'warning' : 'soft';
    find('share-about').textContent =
      obstacle ??
      (link === null
        ? 'This world is too large for a link: send the HTML file instead, below.'
        : isLong
          ? `Mails and chats may cut a link of ${link.length.toLocaleString('en')} letters. Send the HTML file instead, below, or try the link yourself first.`
          : 'Whoever opens it sees this world, can walk in it, and change a copy.');
  }

  for (const copy of dialog.querySelectorAll('[data-copy]'))
    copy.addEventListener('click', async () => {
      const field = find(copy.dataset.copy);
      field.select();
      try {
        await navigator.clipboard.writeText(field.value);
      } catch {
        document.execCommand('copy'); // without the permission
      }
      copy.textContent = 'Copied';
      setTimeout(() => (copy.textContent = 'Copy'), kShownCopied);
    });

  find('save-scene').addEventListener('click', () => saveBar.saveAs());
  find('save-zip').addEventListener('click', () => {
    const files = { [`${name()}.json`]: strToU8(scene.text) };
    for (const [file, bytes] of ownPictures.named) files[file] = bytes;
    download(`${name()}.zip`, zipSync(files), 'application/zip');
    tell(`Saved ${name()}.zip.`);
  });
  find('save-html').addEventListener('click', async ({ currentTarget }) => {
    currentTarget.disabled = true;
    tell('Making the file …');
    try {
      const bytes = await htmlFile({
        player: await readPlayer(),
        text: scene.text,
        readPicture: (file) => readPicture(own, file, world),
        deflate: (bytes) => deflateSync(bytes, { level: 9, mem: 12 }),
      });
      download(`${name()}.html`, bytes, 'text/html');
      tell(`Saved ${name()}.html: ${Math.ceil(bytes.length / 1024)} KB.`);
    } catch (error) {
      tell(`The file cannot be made. ${error.message}`);
    }
    currentTarget.disabled = false;
  });
}

async function readPlayer() {
  const answer = await fetch(kPlayer).catch(() => null);
  if (!answer?.ok) throw new Error('The player could not be loaded: is the page offline?');
  return answer.arrayBuffer();
}

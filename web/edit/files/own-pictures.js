// The world's own pictures: files that are dropped, pasted or chosen become textures and sprites,
// scaled as the visitor agrees. Takes files, an editor and the map of pictures; gives changes to
// the history, and pictures to the map.
//
//     const ownPictures = new OwnPictures(dialog, editor, own, tell);
//     ownPictures.takes(files)               // whether all are pictures, as far as names tell
//     await ownPictures.add(files, 'textures');        // asks for each; the last name, or null
//     ownPictures.list('textures')           // [{file, name, isUsed}]
//     ownPictures.remove(file)               // an unused one; can be undone
//     ownPictures.named                      // a Map of those that the scene names
//     ownPictures.kept                       // the same and those that it does not name yet

import { kMostFileBytes } from '../../engine/limits.js';
import { freeName, kindFor } from '../kinds.js';
import { picturesOf, wordsIn } from './html-file.js';
import { pictureSizeOf } from './picture-size.js';

const kSides = [8, 16, 32, 64, 128, 256, 512, 1024]; // of the engine's textures
const kUsualSide = 256;
const kTypes = /^image\/(png|jpeg|webp|gif|svg\+xml)$/;
const kPreview = 128; // CSS pixels
const kLongestName = 40;
const kTables = ['textures', 'sprites'];
const fileOf = (picture) => picture?.file ?? picture;

export class OwnPictures {
  #dialog;
  #editor;
  #own;
  #tell;
  #removed = new Set();

  constructor(dialog, editor, own, tell) {
    this.#dialog = dialog;
    this.#editor = editor;
    this.#own = own;
    this.#tell = tell;
    this.#find('side').append(...kSides.map((side) => new Option(side, side)));
    addEventListener('paste', ({ clipboardData, target }) => {
      const files = [...(clipboardData?.files ?? [])];
      const isText = Boolean(target.closest?.('input, textarea, .cm-editor'));
      if (files.length > 0 && !isText && this.takes(files)) this.add(files);
    });
  }

  #find(name) {
    return this.#dialog.querySelector(`[data-picture=${name}]`);
  }

  takes(files) {
    return files.every(({ type }) => kTypes.test(type));
  }

  get named() {
    const named = picturesOf(this.#editor.scene.value);
    return new Map([...this.#own].filter(([file]) => named.includes(file)));
  }

  get kept() {
    const { named } = this;
    return new Map([...this.#own].filter(([file]) => named.has(file) || !this.#removed.has(file)));
  }

  list(table) {
    const { scene } = this.#editor;
    const words = wordsIn(scene.value);
    return Object.entries(scene.value[table] ?? {})
      .filter(([, picture]) => this.#own.has(fileOf(picture)))
      .map(([name, picture]) => ({ name, file: fileOf(picture), isUsed: words.has(name) }));
  }

  // The bytes stay until the page is closed, for Undo.
  remove(file) {
    const changes = kTables.flatMap((table) =>
      this.list(table)
        .filter((one) => one.file === file && !one.isUsed)
        .map(({ name }) => ({ path: [table, name], value: undefined })),
    );
    this.#removed.add(file);
    this.#editor.history.do('Remove a picture', changes);
  }

  // `wanted`: for what, if that is known: 'blocks', 'textures' or 'sprites'.
  async add(files, wanted = null) {
    let last = null;
    for (const file of files) {
      try {
        last = (await this.#addOne(file, wanted)) ?? last;
      } catch (error) {
        this.#tell(`${file.name}: ${error.message}`);
      }
    }
    return last;
  }

  async #addOne(file, wanted) {
    if (file.size > kMostFileBytes)
      throw new Error(`Found ${file.size} bytes, expected at most ${kMostFileBytes}.`);
    const size = pictureSizeOf(new Uint8Array(await file.arrayBuffer()));
    const image = await createImageBitmap(file).catch(() => {
      throw new Error('The picture is damaged: the browser cannot read it.');
    });
    const answer = await this.#ask(file, image, size, wanted);
    if (answer === null) return null;
    const { what, side, name: said } = answer;
    const canvas = scaled(image, what, side);
    const blob = await canvas.convertToBlob({ type: 'image/png' });
    return this.#take(said, what, new Uint8Array(await blob.arrayBuffer()));
  }

  #take(said, what, bytes) {
    const { scene, history, map } = this.#editor;
    const table = what === 'sprites' ? 'sprites' : 'textures';
    const file = freeFile(said, this.#own, picturesOf(scene.value));
    this.#own.set(file, bytes);
    const name = freeName(said, scene.value[table] ?? {});
    history.do('Add a picture', [{ path: [table, name], value: file }], `picture ${file}`);
    if (what === 'blocks') {
      const { sign, changes } = kindFor(scene, map, name, { faces: name });
      history.do('Add a picture', changes, `picture ${file}`);
      this.#editor.choose({ sign });
    } else if (what === 'textures') this.#editor.choose({ texture: name });
    else this.#editor.choose({ thing: { name, height: 1 } });
    history.close();
    return name;
  }

  // {what, side, name}, or null.
  #ask(file, image, { type, width, height }, wanted) {
    const [what, side, name] = ['what', 'side', 'name'].map((one) => this.#find(one));
    what.value = wanted ?? 'blocks';
    what.disabled = wanted === 'sprites' || wanted === 'textures';
    name.value = nameOf(file.name);
    side.value = String(usualSide(Math.min(width, height)));
    const show = () => {
      const canvas = scaled(image, what.value, Number(side.value));
      const preview = this.#find('preview');
      preview.width = preview.height = kPreview;
      const share = kPreview / Math.max(canvas.width, canvas.height);
      const context = preview.getContext('2d');
      context.imageSmoothingEnabled = share < 1;
      context.drawImage(canvas, 0, 0, canvas.width * share, canvas.height * share);
      const isCut = what.value !== 'sprites' && width !== height;
      this.#find('about').textContent =
        `${type}, ${width} × ${height} pixels, becomes a PNG of ${canvas.width} × ${canvas.height}` +
        (isCut ? ': its middle, as textures are square.' : '.');
    };
    what.onchange = side.onchange = show;
    show();
    this.#dialog.returnValue = '';
    this.#dialog.showModal();
    return new Promise((resolve) => {
      this.#dialog.addEventListener(
        'close',
        () =>
          resolve(
            this.#dialog.returnValue === 'add'
              ? { what: what.value, side: Number(side.value), name: nameOf(name.value) }
              : null,
          ),
        { once: true },
      );
    });
  }
}

// Textures are cut out of the middle; sprites keep their shape, and `side` is the longer one.
function scaled(image, what, side) {
  const least = Math.min(image.width, image.height);
  const cut =
    what === 'sprites'
      ? [0, 0, image.width, image.height]
      : [(image.width - least) / 2, (image.height - least) / 2, least, least];
  const share = side / Math.max(cut[2], cut[3]);
  const sides = [cut[2], cut[3]].map((length) => Math.max(1, Math.round(length * share)));
  const canvas = new OffscreenCanvas(...sides);
  const context = canvas.getContext('2d');
  context.imageSmoothingEnabled = share < 1;
  context.imageSmoothingQuality = 'high';
  context.drawImage(image, ...cut, 0, 0, ...sides);
  return canvas;
}

// The largest one that the picture fills.
function usualSide(least) {
  return kSides.findLast((side) => side <= Math.min(least, kUsualSide)) ?? kSides[0];
}

function nameOf(text) {
  const name = text
    .replace(/^.*[/\\]|\.\w+$/g, '')
    .replace(/[^\p{L}\p{N}_ -]+/gu, ' ')
    .trim()
    .slice(0, kLongestName)
    .trim();
  return name === '' ? 'picture' : name;
}

function freeFile(name, own, named) {
  const stem =
    name
      .normalize('NFKD')
      .replace(/[^\w-]+/g, '-')
      .replace(/^-+|-+$/g, '') || 'picture';
  for (let count = 1; ; ++count) {
    const file = `${stem}${count === 1 ? '' : `-${count}`}.png`;
    if (!own.has(file) && !named.includes(file)) return file;
  }
}

// Puts the editor together: the world, its history, the views, the tools, the parts of the page.

import '../ray-caster.js';
import { Adding } from './adding.js';
import { SceneDocument } from './document.js';
import { Editor } from './editor.js';
import { Autosave } from './files/autosave.js';
import { conflictDialog } from './files/conflict-dialog.js';
import { pickedFile } from './files/file-homes.js';
import { OneTab } from './files/one-tab.js';
import { openDialog } from './files/open-dialog.js';
import { OwnPictures } from './files/own-pictures.js';
import { SaveBar } from './files/save-bar.js';
import { beginningOf, Saving } from './files/saving.js';
import { shareDialog } from './files/share-dialog.js';
import { keepOpened } from './files/world-store.js';
import { FlyCamera } from './fly-camera.js';
import { History } from './history.js';
import { keyHelp, listenToKeys } from './keys.js';
import { KindPanel } from './kind-panel.js';
import { openWorld, readPicture } from './open-world.js';
import { Palette } from './palette.js';
import { Panel } from './panel.js';
import { Schema } from './forms/schema.js';
import { Pictures } from './pictures.js';
import { PictureView } from './picture-view.js';
import { PlanView } from './plan-view.js';
import { Problems } from './problems.js';
import { sizeOf } from './cells.js';
import { textureOf } from './shapes.js';
import { Sync } from './sync.js';
import { iconOf } from './tool-icons.js';
import { box } from './tools/box.js';
import { fill } from './tools/fill.js';
import { paint } from './tools/paint.js';
import { place } from './tools/place.js';
import { replace } from './tools/replace.js';
import { shape } from './tools/shape.js';
import { thing } from './tools/thing.js';

const kTools = [place, box, fill, replace, paint, shape, thing];
const byId = (id) => document.getElementById(id);

const caster = byId('picture');
const world = await openWorld(new URL(location.href)).catch((error) => fail(error));
const kept = new Autosave(world.name);
const before = await kept.read();
if (before?.base?.handle !== undefined) world.home ??= pickedFile(before.base.handle);
const beginning = beginningOf(world, before);
const scene = readScene(beginning.text);
const own = new Map(before?.pictures); // the world's own pictures: file -> bytes
const history = new History(scene);
const editor = new Editor(scene, history, place);
const pictures = new Pictures(scene, (file) => readPicture(own, file, world));
const camera = new FlyCamera(caster);
let textView = null;

caster.source = {
  name: `${world.name}.json`,
  readText: () => new TextEncoder().encode(scene.text),
  readFile: (file) => readPicture(own, file, world).catch(() => null),
  failures: new Map(),
};

const problems = new Problems(byId('problems'), (fault) =>
  showView('text').then(() => textView.goTo(fault)),
);
const sync = new Sync(scene, caster, ({ faults, warnings }) => {
  problems.show(faults, warnings);
  textView?.show(faults);
  pictureView.refresh();
});
const pictureView = new PictureView(caster, editor, camera);
const plan = new PlanView(
  byId('plan'),
  editor,
  {
    of: (blueprint) => {
      const name = textureOf(blueprint, 'top') ?? textureOf(blueprint, 'north');
      return name === null ? null : pictures.meanOf(name);
    },
    floor: (map) => {
      const { floor } = scene.value.maps[map];
      const name = typeof floor === 'string' ? floor : floor?.texture;
      return name === undefined ? null : pictures.meanOf(name);
    },
    listen: (listener) => pictures.listen(listener),
  },
  caster,
);
const shipped = fetch(new URL('edit/pictures.json', document.baseURI))
  .then((answer) => answer.json())
  .catch(() => []); // only what the scene has can be chosen then
const heights = new Map(); // usual ones of the shipped sprites
shipped.then((groups) => {
  for (const { file, height } of groups.flatMap(({ pictures: all }) => all))
    heights.set(`../${file}`, height);
});
const ownPictures = new OwnPictures(byId('own-picture'), editor, own, (text) => toast(text));
const adding = new Adding(byId('adding'), editor, pictures, {
  readShipped: () => shipped,
  ownPictures,
});
const palette = new Palette(byId('palette'), editor, pictures, {
  add: (what) => {
    if (what === 'blocks') adding.block();
    else if (what === 'things') adding.sprite();
    else adding.texture((texture) => editor.choose({ texture }));
  },
  heightOf: (file) => heights.get(file),
});
new KindPanel(byId('kind'), editor, pictures, {
  chooseTexture: (then) => adding.texture(then),
});

const panel = new Panel(
  editor,
  new Schema(
    await fetch(new URL('scene.schema.json', document.baseURI)).then((answer) => answer.json()),
  ),
);

// ---- The bar

const playable = new URL(location.href).searchParams.get('scene');
if (playable !== null)
  byId('home').search = new URLSearchParams({
    scene: playable,
    ...(world.home?.at === undefined ? {} : { live: 1 }),
  });
byId('title').value = scene.value.title ?? '';
byId('title').addEventListener('change', ({ target }) =>
  history.do('Rename', [{ path: ['title'], value: target.value || undefined }]),
);
const actions = {
  undo: () => tell(history.undo(), 'Undone'),
  redo: () => tell(history.redo(), 'Done again'),
  walk: () => walk(!document.body.hasAttribute('data-walking')),
  view: (name) => showView(name),
  nextView: () => showView(byId('plan-view').hidden ? 'plan' : 'picture'),
  level: (by) => setLevel(editor.level + by),
  tool: (name) => editor.choose({ tool: kTools.find((tool) => tool.name === name) }),
  way() {
    const ways = editor.tool.ways ?? [];
    if (ways.length === 0) return;
    editor.choose({ way: ways[(ways.indexOf(editor.way) + 1) % ways.length] });
    toast(`Box: ${editor.way}`);
  },
  digit: (number) => palette.digit(number),
  next: (by) => palette.move(by),
  remove() {
    const { target } = editor;
    if (target === null || editor.stroke !== null) return;
    editor.press(target, { removes: true });
    editor.release();
  },
  use() {
    const { target } = editor;
    if (target === null || editor.stroke !== null) return;
    editor.press(target);
    editor.release();
  },
  cancel: () => editor.cancel(),
  save: () => saveBar.save(),
};
byId('undo').addEventListener('click', actions.undo);
byId('redo').addEventListener('click', actions.redo);
byId('walk').addEventListener('click', actions.walk);
byId('level-up').addEventListener('click', () => actions.level(1));
byId('level-down').addEventListener('click', () => actions.level(-1));
for (const button of document.querySelectorAll('[data-view]'))
  button.addEventListener('click', () => showView(button.dataset.view));
for (const button of document.querySelectorAll('[data-close]'))
  button.addEventListener('click', () => button.closest('dialog').close());
history.listen(() => {
  byId('undo').disabled = history.undoLabel === null;
  byId('redo').disabled = history.redoLabel === null;
  byId('undo').title = `Undo${history.undoLabel === null ? '' : `: ${history.undoLabel}`} (Ctrl+Z)`;
  if (document.activeElement !== byId('title')) byId('title').value = scene.value.title ?? '';
});

// ---- Tools

byId('tools').append(
  ...kTools.map((tool) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.dataset.tool = tool.name;
    button.title = `${tool.label} (${tool.key}). ${tool.about}`;
    button.append(iconOf(tool.name), tool.label);
    button.addEventListener('click', () => editor.choose({ tool }));
    return button;
  }),
);
editor.listen((what) => {
  if (what === 'choice') showChoice();
  else showWhere();
});
showChoice();

function showChoice() {
  for (const button of byId('tools').children)
    button.setAttribute('aria-pressed', String(button.dataset.tool === editor.tool.name));
  byId('about').textContent = editor.tool.about;
  byId('level').textContent = String(editor.level);
  const maps = scene.value.maps.map(({ name }) => name);
  const list = byId('map');
  if (String([...list.options].map(({ text }) => text)) !== String(maps))
    list.replaceChildren(...maps.map((name, index) => new Option(name, index)));
  list.value = String(editor.map);
  panel.show();
  showWhere();
}

function showWhere() {
  const { target, map } = editor;
  const { width, depth, levels } = sizeOf(scene, map);
  const at = target?.cell ?? target?.before ?? null;
  byId('where').textContent =
    at === null
      ? `${width} × ${depth} tiles, ${levels} ${levels === 1 ? 'level' : 'levels'}`
      : `x ${at.x}, y ${at.y}, level ${at.level}`;
}

byId('map').addEventListener('change', ({ target }) => {
  editor.choose({ map: Number(target.value) });
  const { width, depth } = sizeOf(scene, editor.map);
  caster.look({ map: editor.mapName, x: width / 2, y: depth / 2, z: 4, flying: true });
  plan.fit();
});

function setLevel(level) {
  const { levels } = sizeOf(scene, editor.map);
  editor.choose({ level: Math.max(0, Math.min(levels, 31, level)) });
}

// ---- Views

async function showView(name) {
  const isWide = matchMedia('(min-width: 1500px)').matches;
  byId('picture-view').hidden = name !== 'picture' && !isWide;
  byId('plan-view').hidden = name !== 'plan';
  byId('text-view').hidden = name !== 'text';
  for (const button of document.querySelectorAll('[data-view]'))
    button.setAttribute('aria-pressed', String(button.dataset.view === name));
  if (name === 'text' && textView === null) {
    const { TextView } = await import('./text-view.js');
    textView = new TextView(byId('text-view'), scene);
  }
  if (name === 'text') textView.focus();
  if (name === 'plan') {
    byId('plan').focus({ preventScroll: true });
    plan.draw();
  }
}

// ---- Walking

async function walk(isOn) {
  if (isOn === document.body.hasAttribute('data-walking')) return;
  if (isOn) {
    await showView('picture');
    await sync.settled();
    document.body.setAttribute('data-walking', '');
    byId('walking').hidden = false;
    pictureView.isOn = false;
    caster.mark([]);
    caster.interaction = 'walk';
    caster.land();
    await new Promise(requestAnimationFrame); // the element takes attributes a moment later
    caster.enter();
  } else {
    document.body.removeAttribute('data-walking');
    byId('walking').hidden = true;
    caster.pause();
    caster.interaction = 'none';
    caster.flying = true;
    pictureView.isOn = true;
    sync.renew();
  }
  byId('walk').textContent = isOn ? 'Build' : 'Walk';
}

// ---- Keeping

const saving = new Saving(scene, history, {
  ...{ home: world.home, form: world.form, ...beginning },
  choose: conflictDialog(byId('conflict'), (text) => saveBar.saveCopy(text)),
});
const saveBar = new SaveBar({ scene, saving, world, ownPictures, tell: toast });
const toKeep = () =>
  scene.mistake === null && tab.hasWorld
    ? { text: scene.text, pictures: ownPictures.kept, base: saving.base }
    : null;
const keep = () => kept.keep(toKeep);
scene.listen(keep);
saving.listen(keep);
kept.listen((what) => {
  byId('kept').textContent = {
    kept: 'Kept in this browser.',
    failed: 'This browser keeps nothing: save the scene before you close the page.',
  }[what];
});
const tab = new OneTab(world.name, byId('other-tab'), {
  flush: () => kept.write(),
  reload: () => saveBar.leave(() => location.reload()),
  copy: async () => {
    const name = `${scene.value.title ?? 'world'} copy`;
    const query = await keepOpened(name, { text: scene.text, pictures: ownPictures.kept });
    saveBar.leave(() => location.assign(query));
  },
});
shareDialog(byId('share'), byId('open-share'), { scene, own, ownPictures, world, saveBar });
byId('anew').parentElement.hidden = world.name.startsWith('file '); // there is no other copy
openDialog(byId('files'), byId('open-files'), {
  leave: (go) => saveBar.leave(go),
  takePictures(files) {
    const takes = ownPictures.takes(files);
    if (takes) ownPictures.add(files);
    return takes;
  },
  async beginAnew() {
    await kept.forget();
    saveBar.leave(() => location.reload());
  },
});
keyHelp(byId('keys'), byId('open-keys'), kTools);
listenToKeys(actions, camera, kTools, {
  isWalking: () => document.body.hasAttribute('data-walking'),
});

if (beginning.text !== world.text) toast('Your world is as you left it.');
if (world.isStranger && before === null)
  toast('A world from a link. What you change stays in this browser.');

caster.addEventListener('ready', () => start(), { once: true });
caster.addEventListener('error', ({ detail }) => {
  problems.show(detail.faults, []);
  document.body.dataset.state = 'ready';
});

function start() {
  caster.flying = true;
  const view = caster.currentView;
  editor.choose({
    map: Math.max(
      0,
      scene.value.maps.findIndex(({ name }) => name === view.map),
    ),
  });
  caster.look({ ...view, z: view.z + 1.2, flying: true });
  document.body.dataset.state = 'ready';
  saveBar.settle();
  // For the browser's console, and for tests.
  window.slicecastEditor = { scene, history, editor, sync, caster, saving };
}

// ---- Small things

let toastTimer = 0;
function toast(text) {
  const line = byId('toast');
  line.textContent = text;
  line.classList.add('shown');
  clearTimeout(toastTimer);
  toastTimer = setTimeout(() => line.classList.remove('shown'), 3500);
}

function tell(label, what) {
  if (label !== null) toast(`${what}: ${label}`);
}

function readScene(text) {
  try {
    return new SceneDocument(text);
  } catch (error) {
    return fail(error);
  }
}

function fail(error) {
  document.body.dataset.state = 'failed';
  byId('about').textContent = `This world cannot be opened. ${error.message}`;
  throw error;
}

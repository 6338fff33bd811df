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
import { inTouch, isTouch, listenToFingers } from './fingers.js';
import { FlyCamera } from './fly-camera.js';
import { History } from './history.js';
import { keyHelp, listenToKeys } from './keys.js';
import { KindPanel } from './kind-panel.js';
import { MapPanel } from './map-panel.js';
import { isVisit, openWorld, readPicture } from './open-world.js';
import { Palette } from './palette.js';
import { Panel } from './panel.js';
import { Schema } from './forms/schema.js';
import { Pictures } from './pictures.js';
import { PictureView } from './picture-view.js';
import { PlanView } from './plan-view.js';
import { Problems } from './problems.js';
import { isInside, sizeOf } from './cells.js';
import { textureOf, waterOf } from './shapes.js';
import { Selecting } from './selecting.js';
import { knowShipped } from './files/shipped.js';
import { SideView } from './side-view.js';
import { askName } from './small-dialogs.js';
import { Stamps } from './stamps.js';
import { Sync } from './sync.js';
import { iconOf } from './tool-icons.js';
import { ToolWays } from './tool-ways.js';
import { Tour } from './tour.js';
import { box } from './tools/box.js';
import { fill } from './tools/fill.js';
import { line } from './tools/line.js';
import { link } from './tools/link.js';
import { paint } from './tools/paint.js';
import { place } from './tools/place.js';
import { replace } from './tools/replace.js';
import { select } from './tools/select.js';
import { shape } from './tools/shape.js';
import { stamp } from './tools/stamp.js';
import { thing } from './tools/thing.js';

const kTools = [place, line, box, fill, replace, paint, shape, thing, link, select, stamp];
const byId = (id) => document.getElementById(id);

// Whoever opens a link sees the world first; the play page leads here, to a copy.
if (isVisit(new URL(location.href))) {
  location.replace(`./${location.hash}`);
  await new Promise(() => {});
}

const caster = byId('picture');
const named = fetch(new URL('pictures.json', document.baseURI))
  .then((answer) => answer.json())
  .then(knowShipped)
  .catch(() => {}); // the engine tells which names are unknown
const world = await openWorld(new URL(location.href)).catch((error) => fail(error));
await named;
const kept = new Autosave(world.name);
const before = await kept.read();
if (before?.base?.handle !== undefined) world.home ??= pickedFile(before.base.handle);
const beginning = beginningOf(world, before);
const scene = readScene(beginning.text);
const own = new Map(before?.pictures); // the world's own pictures: file -> bytes
const history = new History(scene);
const editor = new Editor(scene, history, place);
editor.world = world.name;
editor.isTouch = isTouch();
listenToFingers((byFinger) => editor.choose({ isTouch: byFinger }));
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
const colours = {
  of: colourOf,
  texture: (name) => pictures.meanOf(name),
  sprite: (name) => pictures.spriteOf(name),
  floor: (map) => {
    const { floor } = scene.value.maps[map];
    const name = typeof floor === 'string' ? floor : floor?.texture;
    return name === undefined ? null : pictures.meanOf(name);
  },
  listen: (listener) => pictures.listen(listener),
};
const plan = new PlanView(byId('plan'), editor, colours, caster);
const side = new SideView(byId('side'), editor, colours, pictures, caster);
const flat = { plan, side }; // views on a canvas
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
const stamps = new Stamps();
const selecting = new Selecting(byId('select-bar'), editor, {
  stamps,
  own,
  colourOf,
  tell: (text) => toast(text),
  askName,
  // How often the plan must be turned clockwise to lie as the picture does.
  quarters: () => {
    if (!byId('plan-view').hidden) return 0;
    return Math.round((caster.currentView.heading + 90) / 90) & 3;
  },
});
const palette = new Palette(byId('palette'), editor, pictures, {
  add: (what) => {
    if (what === 'blocks') adding.block();
    else if (what === 'things') adding.sprite();
    else if (what === 'stamps') selecting.save();
    else adding.texture((texture) => editor.choose({ texture }));
  },
  heightOf: (file) => heights.get(file),
  stamps: () => stamps.all,
  useStamp: (one) => selecting.useStamp(one),
});
stamps.listen(() => palette.show());
stamps.read();
addEventListener('focus', () => stamps.read()); // other tabs save some, too
new KindPanel(byId('kind'), editor, pictures, {
  chooseTexture: (then) => adding.texture(then),
});

const panel = new Panel(
  editor,
  new Schema(
    await fetch(new URL('scene.schema.json', document.baseURI)).then((answer) => answer.json()),
  ),
);

const isWalking = () => document.body.hasAttribute('data-walking');
const tour = new Tour(byId('tour'), { scene, caster, isWalking, find: byId });
const mapPanel = new MapPanel(byId('map-tools'), editor, {
  async moved({ x, y, z }) {
    const view = caster.currentView;
    if (view === null) return;
    await sync.settled();
    const { width, depth } = sizeOf(scene, editor.map);
    const limit = (at, end) => Math.max(0.3, Math.min(end - 0.3, at));
    caster.look({
      ...view,
      map: editor.mapName,
      x: limit(view.x + x, width),
      y: limit(view.y + y, depth),
      z: view.z + z,
      flying: true,
    });
  },
});

// ---- The bar

const playable = new URL(location.href).searchParams.get('scene');
if (playable !== null)
  byId('home').search = new URLSearchParams({
    scene: playable,
    ...(world.home?.at === undefined ? {} : { live: 1 }),
  });
byId('title').value = scene.value.title ?? '';
const rename = (title) =>
  history.do('Rename', [{ path: ['title'], value: title.trim() || undefined }]);
byId('title').addEventListener('change', ({ target }) => rename(target.value));
const actions = {
  undo: () => back(history.undo(), 'Undone'),
  redo: () => back(history.redo(), 'Done again'),
  walk: () => walk(!isWalking()),
  view: (name) => showView(name),
  nextView: () => showView(byId('plan-view').hidden ? 'plan' : 'picture'),
  sideView: () => (byId('side-view').hidden ? showView('side') : side.turn()),
  ofView: (event) =>
    event.target.closest?.('#picture, #panel') === null && (flatView()?.take(event) ?? false),
  level(by) {
    if (editor.stroke === null || !editor.turn(by)) setLevel(editor.level + by);
  },
  tool: (name) => editor.choose({ tool: kTools.find((tool) => tool.name === name) }),
  way() {
    const ways = editor.tool.ways ?? [];
    if (ways.length === 0) return;
    editor.choose({ way: ways[(ways.indexOf(editor.way) + 1) % ways.length] });
    toast(`${editor.tool.label}: ${editor.way}`);
  },
  digit: (number) => palette.digit(number),
  next: (by) => palette.move(by),
  remove() {
    if (selecting.remove()) return;
    const { target, tool } = editor;
    if (editor.stroke !== null) return;
    if (tool.hasThings && !target?.thing && editor.removeEdited()) return;
    if (target === null) return;
    editor.press(target, { removes: true });
    editor.release();
  },
  duplicate: () => editor.duplicate(),
  finish: () => editor.finish(),
  // Of what has two corners, the first one, then the second one.
  use() {
    if (editor.stroke !== null) {
      editor.release();
      return;
    }
    const isAimed = editor.target === null;
    if (isAimed) (flatView() ?? pictureView).aim();
    if (editor.target === null) return;
    editor.press(editor.target);
    if (editor.tool.hasCorners?.(editor.way)) return;
    editor.release();
    if (isAimed) editor.point(null);
  },
  cancel: () => selecting.escape() || (flatView() ?? editor).cancel(),
  selectionKey: (event) => selecting.key(event),
  save: () => saveBar.save(),
};
byId('undo').addEventListener('click', actions.undo);
byId('redo').addEventListener('click', actions.redo);
byId('walk').addEventListener('click', actions.walk);
byId('level-up').addEventListener('click', () => actions.level(1));
byId('level-down').addEventListener('click', () => actions.level(-1));
byId('section-far').addEventListener('click', () => side.move(1));
byId('section-near').addEventListener('click', () => side.move(-1));
byId('section-turn').addEventListener('click', () => side.turn());
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
new ToolWays(byId('ways'), editor);
byId('thing-copy').addEventListener('click', actions.duplicate);
byId('thing-remove').addEventListener('click', () => editor.removeEdited());
editor.listen((what, more) => {
  if (what === 'words') toast(more);
  else if (what === 'choice') showChoice(more);
  else showWhere();
});
scene.listen(({ isWhole }) => isWhole && showMaps());
showChoice();

function showChoice(choice) {
  for (const button of byId('tools').children)
    button.setAttribute('aria-pressed', String(button.dataset.tool === editor.tool.name));
  byId('level').textContent = String(editor.level);
  byId('section').textContent = side.name;
  showMaps();
  panel.show(choice);
  mapPanel.show();
  showWhere();
}

function showMaps() {
  const maps = scene.value.maps.map(({ name }) => name);
  const list = byId('map');
  if (String([...list.options].map(({ text }) => text)) !== String(maps))
    list.replaceChildren(...maps.map((name, index) => new Option(name, index)));
  list.value = String(editor.map);
}

function showWhere() {
  const { target, map } = editor;
  const { width, depth, levels } = sizeOf(scene, map);
  const at = target?.cell ?? target?.before ?? null;
  const isIn = at !== null && isInside(scene, map, at);
  byId('about').textContent = inTouch(editor.about);
  byId('about').toggleAttribute('data-hint', editor.hint !== undefined);
  byId('where').textContent = !isIn
    ? `${width} × ${depth} tiles, ${levels} ${levels === 1 ? 'level' : 'levels'}`
    : `x ${at.x}, y ${at.y}, level ${at.level}`;
}

byId('map').addEventListener('change', ({ target }) => {
  editor.choose({ map: Number(target.value) });
  lookAtMap();
});

async function lookAtMap() {
  await sync.settled(); // it may be a new one
  if (caster.currentView === null) return;
  const { width, depth } = sizeOf(scene, editor.map);
  caster.look({ map: editor.mapName, x: width / 2, y: depth / 2, z: 4, flying: true });
  for (const view of Object.values(flat)) view.fit();
}

// Who flies through a portal builds where it leads.
let eyeMap = null;
caster.addEventListener('viewchange', () => {
  const { map } = caster.currentView ?? {};
  if (map === eyeMap) return;
  eyeMap = map;
  const index = scene.value.maps.findIndex(({ name }) => name === map);
  if (index >= 0 && index !== editor.map && editor.stroke === null) editor.choose({ map: index });
});

function setLevel(level) {
  const { levels } = sizeOf(scene, editor.map);
  editor.choose({ level: Math.max(0, Math.min(levels, 31, level)) });
}

// ---- Views

async function showView(name) {
  const isWide = matchMedia('(min-width: 1500px)').matches;
  byId('picture-view').hidden = name !== 'picture' && !isWide;
  for (const other of ['plan', 'side', 'text']) byId(`${other}-view`).hidden = other !== name;
  for (const part of document.querySelectorAll('[data-of]')) part.hidden = part.dataset.of !== name;
  for (const button of document.querySelectorAll('[data-view]'))
    button.setAttribute('aria-pressed', String(button.dataset.view === name));
  if (name === 'text' && textView === null) {
    const { TextView } = await import('./text-view.js');
    textView = new TextView(byId('text-view'), scene);
  }
  if (name === 'text') textView.focus();
  if (name === 'side') side.show();
  else if (name !== 'plan') editor.choose({ section: null }); // the plan shows it no longer
  flatView()?.canvas.focus({ preventScroll: true });
  flatView()?.draw();
}

function flatView() {
  return Object.entries(flat).find(([name]) => !byId(`${name}-view`).hidden)?.[1];
}

// Keys go to what is seen, so that Space flies: a button that a pointer pressed does not keep them,
// nor any while the pointer is over a view. Who works by keys alone stays on the button.
const kKeepsNoKeys = 'button, summary, a, input[type=checkbox]';
function giveKeys() {
  const { activeElement } = document;
  if (!activeElement.matches(kKeepsNoKeys) || document.querySelector('dialog[open]') !== null)
    return;
  activeElement.blur();
  flatView()?.canvas.focus({ preventScroll: true });
}
addEventListener('click', ({ detail }) => detail > 0 && giveKeys());
for (const view of document.querySelectorAll('#picture, .flat'))
  view.addEventListener('pointerenter', giveKeys);

// ---- Walking

async function walk(isOn) {
  if (isOn === isWalking() || caster.currentView === null) return;
  document.body.toggleAttribute('data-walking', isOn);
  byId('walk').textContent = isOn ? 'Back to editing' : 'Walk';
  byId('walk').title = isOn ? 'Back to editing (Escape)' : 'Walk (Tab)';
  byId('walking').hidden = !isOn;
  pictureView.isOn = !isOn;
  tour.look();
  if (isOn) {
    editor.cancel();
    await showView('picture');
    await sync.settled();
    if (!isWalking()) return;
    caster.mark([]);
    caster.interaction = 'walk';
    standOnGround();
    await new Promise(requestAnimationFrame); // the element takes attributes a moment later
    if (isWalking()) caster.enter({ touch: isTouch() });
  } else {
    caster.pause();
    caster.interaction = 'none';
    caster.flying = true;
    sync.renew();
  }
}

caster.addEventListener('enterchange', ({ detail }) =>
  document.body.toggleAttribute('data-steering', detail.entered),
);

// Under the eye, without the time that a fall takes, and looking ahead: who builds looks down.
function standOnGround() {
  caster.land();
  caster.look({ ...caster.currentView, look: 0 });
  for (let z = Infinity; !caster.player.onGround && caster.player.z < z;) {
    ({ z } = caster.player);
    caster.step(12);
  }
}

// ---- The first steps

byId('begin-tour').addEventListener('click', () => tour.begin());
addEventListener('click', () => tour.look()); // a dialog may be open now

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
shareDialog(byId('share'), byId('open-share'), {
  ...{ scene, own, ownPictures, world, saveBar, rename },
});
byId('anew').parentElement.hidden = world.name.startsWith('file '); // there is no other copy
openDialog(byId('files'), byId('open-files'), {
  importing: byId('import'),
  readShipped: () => shipped,
  readPicture,
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
listenToKeys(actions, camera, kTools, { isWalking, isSteering: () => caster.entered });

if (beginning.text !== world.text) toast('Your world is as you left it.');
if (world.isStranger && before === null)
  toast('A copy of a world from a link. What you change stays in this browser.');

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
  byId('walk').disabled = false;
  tour.begin({ once: !new URL(location.href).searchParams.has('tour') });
  saveBar.settle();
  // For the browser's console, and for tests.
  window.slicecastEditor = { scene, history, editor, sync, caster, saving };
}

// ---- Small things

function colourOf(blueprint) {
  const name = textureOf(blueprint, 'top') ?? textureOf(blueprint, 'north');
  return name === null ? waterOf(blueprint) : pictures.meanOf(name);
}

let toastTimer = 0;
function toast(text) {
  const line = byId('toast');
  line.textContent = inTouch(text);
  line.classList.add('shown');
  clearTimeout(toastTimer);
  toastTimer = setTimeout(() => line.classList.remove('shown'), 3500);
}

function back(label, what) {
  editor.recall();
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

// The play page: <ray-caster> in the whole window, with menu, settings and sharing around it. The
// page only sets the element's attributes and listens to its events.
//
//     address-line.js      turns the page's address into attributes of the element
//     address-problems.js  lists mistakes in the address
//     page-status.js       shows title, progress, errors and modes
//     dialogs.js           scenes, keys, settings, share; page-keys.js opens them too
//     settings.js          the visitor's settings; view-options.js passes them to the engine
//     page-parts.js        opening, hints, Lab, photo mode, benchmark, recordings, key editor
//
// Parameters of the address: scene=NAME or a path, view=, options= and overlay= as
// engine/address.js spells them, tour=NAME (a recording in the folder tours, which names its
// scene), live=1 (reload when tools/play reports a save), engine=simd or scalar. Behind the sign #
// there may be a whole world, which somebody has built in the editor.

import '../ray-caster.js';
import { isFinger } from '../element/details.js';
import { Gamepads } from '../element/gamepads.js';
import { AddressLine } from './address-line.js';
import { AddressProblems } from './address-problems.js';
import { Dialogs } from './dialogs.js';
import { playDropped } from './dropped-scene.js';
import { listenForFiles } from './file-drop.js';
import { guardLeaving } from './leave-guard.js';
import { listenForSaves } from './live-scene.js';
import { padMenu } from './pad-menu.js';
import { listenForPageKeys } from './page-keys.js';
import { addPageParts } from './page-parts.js';
import { PageStatus } from './page-status.js';
import { editAddress, listScenes } from './scene-list.js';
import { SceneMenu } from './scene-menu.js';
import { Settings } from './settings.js';
import { ShareDialog } from './share.js';
import { showSize } from './size-now.js';
import { ViewOptions } from './view-options.js';

const find = (id) => document.getElementById(id);

function start() {
  const caster = find('picture');
  const settings = new Settings(find('settings').querySelector('form'), (name, value) =>
    apply(name, value),
  );
  const problems = new AddressProblems(find('address-problems'), caster);
  const options = new ViewOptions(caster, settings, (message) => problems.add('view', message));
  const address = new AddressLine(caster, options, problems);
  const dialogs = new Dialogs(caster);
  const status = new PageStatus(caster, address, dialogs);

  // All settings but these are options of the engine.
  function apply(name, value) {
    if (name === 'size') caster.size = value;
    else if (name === 'rate') find('rate').hidden = !value;
    else if (name === 'mouse') caster.mouse = { speed: value };
    else if (name === 'invert') caster.mouse = { invert: value };
    else if (name === 'sound') caster.muted = !value;
    else options.set(name, value);
  }
  for (const name of settings.names) apply(name, settings.value(name));
  caster.addEventListener('ready', () => settings.ranges(caster.optionList));
  caster.addEventListener('modechange', ({ detail: { mode, on } }) => {
    if (mode === 'sound') settings.set('sound', on);
  });

  showSize(caster, find('size-now'));
  const share = new ShareDialog(find('share'));
  dialogs.before('settings', () => options.takeFromKeys());
  dialogs.opens('share', () => caster.world !== null && share.open(caster, address));
  listenForPageKeys(caster, {
    dialogs,
    toggleFullScreen,
    toggleRate: () => settings.set('rate', !settings.value('rate')),
    toggleRecording: () => replayBar.toggleRecording(),
  });

  const { opening, replayBar } = addPageParts(caster, { settings, address, dialogs, status });
  find('play').addEventListener('click', (press) =>
    caster.enter({ touch: isFinger(press), mouse: press.pointerType === 'mouse' }),
  );
  find('edit-copy').addEventListener('click', () => editOwn(caster.source));
  find('standard-settings').addEventListener('click', () => settings.backToStandard());
  find('choose-files').addEventListener('click', () => find('files').click());
  listenForFiles({
    input: find('files'),
    onEntries: async (entries) => {
      dialogs.close();
      opening.end();
      await playDropped(caster, address, await entries).catch((error) => status.fail(error));
    },
  });
  playByClick(caster);
  guardLeaving(caster);
  listenForFullScreen();
  // A gamepad's button starts the game, as a click would.
  new Gamepads(padMenu(caster, dialogs, () => status.state === 'paused'));

  const scenes = listScenes();
  scenes.then(
    (list) => show(list, null),
    (error) => show([], error),
  );
  function show(list, missing) {
    const menu = new SceneMenu(find('scenes'), list, {
      missing,
      addressOf: (file) => address.of(file),
      onChoose: (file) => {
        opening.end();
        address.go(file);
      },
    });
    dialogs.opens('scenes', () => menu.open(address.reference));
    status.scenes = list;
    const edit = find('open-edit');
    edit.addEventListener('click', (event) => {
      const { reference, isLive } = address;
      const isKnown = isLive || list.some(({ file }) => file === reference);
      if (reference !== null) edit.href = isKnown ? editAddress(reference) : 'edit.html';
      else if (caster.source !== null) {
        event.preventDefault();
        editOwn(caster.source).catch((error) => status.fail(error));
      }
    });
    if (address.isPlain) opening.begin(list[0]?.flight);
  }
  const open = () =>
    address.open(scenes).catch((error) => status.fail(error, () => location.reload()));
  window.addEventListener('popstate', () => {
    opening.end();
    open();
  });
  open();
  if (address.isLive) listenForSaves(caster, address, status);

  // For the browser's console, and for tests.
  window.slicecast = caster;
}

// A copy: the link, or the file, stays as it is.
async function editOwn(source) {
  if (source.link !== undefined) return location.assign(`edit.html?copy${source.link}`);
  const { handOver } = await import('../edit/hand-over.js');
  location.assign(`edit.html${await handOver(source)}`);
}

// A click on the picture plays and captures the mouse, unless a recording is replayed, which the
// mouse does not steer. The element handles taps.
function playByClick(caster) {
  let begins = false;
  caster.addEventListener(
    'pointerdown',
    ({ pointerType }) => {
      begins = pointerType === 'mouse' && !caster.entered;
    },
    { capture: true },
  );
  caster.addEventListener('click', () => {
    if (begins) caster.enter({ mouse: caster.replay === null });
    begins = false;
  });
}

function toggleFullScreen() {
  if (document.fullscreenElement !== null) document.exitFullscreen().catch(() => {});
  else document.documentElement.requestFullscreen?.().catch(() => {});
}

function listenForFullScreen() {
  const button = find('full-screen');
  button.hidden = !document.fullscreenEnabled;
  button.addEventListener('click', toggleFullScreen);
  document.addEventListener('fullscreenchange', () => {
    button.textContent = document.fullscreenElement !== null ? 'Leave full screen' : 'Full screen';
  });
}

if (document.body.dataset.state !== 'impossible') start();

// The play page: <ray-caster> in the whole window, and around it menu, settings and sharing. What
// plays is the element's affair; the page sets its attributes and hears its events.
//
//     address-line.js    what the page's address names, as attributes of the element
//     slips.js           what the address says that cannot be
//     face.js            what the page shows of the element: title, progress, trouble, modes
//     dialogs.js         scenes, keys, settings, share; page-keys.js opens them too
//     settings.js        what somebody likes; view-options.js hands the options on
//     around.js          opening, hints, Lab, photo mode, benchmark, keys that can be changed
//
// Parameters of the address: scene=NAME or a path, view=, options= and overlay= as
// engine/address.js spells them, tour=NAME (a recording of the folder tours, which names its
// scene), live=1 (tools/play says when the scene was saved), engine=simd or scalar.

import '../ray-caster.js';
import { Gamepads } from '../element/gamepads.js';
import { AddressLine } from './address-line.js';
import { putAround } from './around.js';
import { Dialogs } from './dialogs.js';
import { playDropped } from './dropped-scene.js';
import { Face } from './face.js';
import { listenForFiles } from './file-drop.js';
import { guardLeaving } from './leave-guard.js';
import { listenForSaves } from './live-scene.js';
import { padMenu } from './pad-menu.js';
import { listenForPageKeys } from './page-keys.js';
import { toggleRecording } from './recording.js';
import { listScenes } from './scene-list.js';
import { SceneMenu } from './scene-menu.js';
import { Settings } from './settings.js';
import { ShareDialog } from './share.js';
import { showSize } from './size-now.js';
import { Slips } from './slips.js';
import { ViewOptions } from './view-options.js';

const find = (id) => document.getElementById(id);

function start() {
  const caster = find('picture');
  const settings = new Settings(find('settings').querySelector('form'), (name, value) =>
    apply(name, value),
  );
  const options = new ViewOptions(caster, settings);
  const address = new AddressLine(caster, options, new Slips(find('slips'), caster));
  const dialogs = new Dialogs(caster);
  const face = new Face(caster, address, dialogs);

  // A setting is an option of the engine, unless it is one of these.
  function apply(name, value) {
    if (name === 'size') caster.size = value;
    else if (name === 'rate') find('rate').hidden = !value;
    else if (name === 'mouse') caster.mouse = { speed: value };
    else if (name === 'invert') caster.mouse = { invert: value };
    else options.set(name, value);
  }
  for (const name of settings.names) apply(name, settings.value(name));
  caster.addEventListener('ready', () => settings.ranges(caster.optionList));

  showSize(caster, find('size-now'));
  const share = new ShareDialog(find('share'));
  dialogs.before('settings', () => options.takeFromKeys());
  dialogs.opens('share', () => caster.world !== null && share.open(caster, address));
  listenForPageKeys(caster, {
    dialogs,
    toggleFullScreen,
    toggleRate: () => settings.set('rate', !settings.value('rate')),
    toggleRecording: () => toggleRecording(caster, address),
  });

  const { opening } = putAround(caster, { settings, address, dialogs, face });
  find('play').addEventListener('click', ({ pointerType }) =>
    caster.enter({ touch: pointerType === 'touch' }),
  );
  find('standard-settings').addEventListener('click', () => settings.backToStandard());
  find('choose-files').addEventListener('click', () => find('files').click());
  listenForFiles({
    input: find('files'),
    onEntries: async (entries) => {
      dialogs.close();
      opening.end();
      await playDropped(caster, address, await entries).catch((error) => face.fail(error));
    },
  });
  playByClick(caster);
  guardLeaving(caster);
  listenForFullScreen();
  // A press on a gamepad begins the game, as a click would.
  new Gamepads(padMenu(caster, dialogs, () => face.state === 'paused'));

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
    face.scenes = list;
    if (address.isPlain) opening.begin(list[0]?.flight);
  }
  const open = () =>
    address.open(scenes).catch((error) => face.fail(error, () => location.reload()));
  window.addEventListener('popstate', () => {
    opening.end();
    open();
  });
  open();
  if (address.isLive) listenForSaves(caster, address, face);

  // For the browser's console, and for tests.
  window.slicecast = caster;
}

// A click on the picture plays, and takes the mouse along. A finger's tap does what the element
// does with it.
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
    if (begins) caster.enter({ mouse: true });
    begins = false;
  });
}

function toggleFullScreen() {
  if (document.fullscreenElement !== null) document.exitFullscreen();
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
